"""Scenes in space for the tests of simulations, whose motions are known otherwise."""

BOOK = """title: Book thrown up
up: z
given: {I1: 1e-3 kg m^2, I2: 2e-3 kg m^2, I3: 2.6e-3 kg m^2, g: 9.8 m/s^2}
bodies: {book: {mass: 0.5 kg, inertia: {principal: [I1, I2, I3]}, turned: {about: x, by: 30 deg}}}
states: {thrown: {"book.angular_velocity in body axes": [0.1 rad/s, 4 rad/s, -0.2 rad/s], book.velocity: [1 m/s, 0, 3 m/s]}}
find: {K: book.kinetic_energy}
"""
LUMP = """title: Lump without symmetry on a ball joint, pushed and twisted
up: z
given: {I: 0.01 kg m^2, g: 9.8 m/s^2}
bodies:
  lump:
    mass: 2 kg
    inertia: {tensor: [[50*I, -4*I, 3*I], [-4*I, 60*I, 2*I], [3*I, 2*I, 40*I]], about: P}
    points: {P: [0.1 m, -0.2 m, -0.3 m], Q: [0.2 m, 0.1 m, 0]}
    turned: {about: y, by: 40 deg}
connections: {peg: {ball: lump.P}}
actions:
  push:  {force: [1 N, -2 N, 0.5 N], on: lump.Q}
  twist: {couple: [0, 0.3 N m, 0.7 N m], on: lump}
states: {start: {"lump.angular_velocity in body axes": [1 rad/s, 2 rad/s, -1 rad/s]}}
find: {K: lump.kinetic_energy}
"""
TOP = """title: Top let go
up: z
given: {{M: 0.2 kg, l: 0.05 m, A: 6e-4 kg m^2, C: 8e-5 kg m^2, w3: {axial}, theta: {tilt}, g: 9.8 m/s^2}}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [A, A, C]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
states: {{start: {{top.tilt: theta, top.axial_rate: w3, top.precession: {precession}, top.nutation: {nutation}}}{later}}}
find: {{K: top.kinetic_energy at start}}
"""
WOBBLE = """title: Plate thrown
up: z
gravity: none
given: {A: 0.02 kg m^2, C: 0.03 kg m^2}
bodies: {plate: {mass: 1 kg, inertia: {principal: [A, A, C]}, axis: z}}
states: {thrown: {plate.angular_velocity: [4 rad/s, 0, 10 rad/s]}}
find: {K: plate.kinetic_energy}
"""
GATE = """title: Bar on a slanted axis
up: z
given: {M: 2 kg, L: 0.9 m, beta: 50 deg, g: 9.81 m/s^2}
bodies: {bar: {shape: rod, mass: M, length: L}}
connections: {axis: {hinge: bar.start, along: [0, sin(beta), cos(beta)]}}
states: {released: {bar.angle: 0 deg, at rest: all}}
find: {alpha: bar.angular_acceleration}
"""
COIN = """title: Coin that rolls
up: z
given: {m: 10 g, R: 1 cm, g: 9.8 m/s^2}
bodies: {coin: {shape: disc, mass: m, radius: R}}
surfaces: {table: level}
connections: {grip: {rolls: [coin, table]}}
states: {now: {coin.tilt: 70 deg, coin.spin: 30 rad/s, coin.precession: 3 rad/s, coin.nutation: 1 rad/s}}
find: {K: coin.kinetic_energy}
"""
GYROSCOPE = """title: Rotor on a frame that a ball joint holds
up: z
given: {g: 9.8 m/s^2}
bodies:
  frame: {mass: 1 kg, inertia: {principal: [0.02 kg m^2, 0.03 kg m^2, 0.04 kg m^2]}, points: {P: [-0.2 m, 0, 0]}}
  rotor: {mass: 2 kg, inertia: {principal: [0.01 kg m^2, 0.01 kg m^2, 0.02 kg m^2]}, axis: z}
connections:
  pivot: {ball: frame.P}
  shaft: {axle: [frame, rotor], along: [1, 1, 0]}
states: {now: {rotor.spin: 60 rad/s, frame.angular_velocity: [0, 0, 0.5 rad/s]}}
find: {K: rotor.kinetic_energy}
"""
