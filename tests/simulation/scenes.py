"""Scenes for the tests of simulations, whose motions are known otherwise."""

PENDULUM = """title: Rod let go
given: {{M: 2 kg, L: 0.9 m, g: 9.81 m/s^2}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pivot: {{hinge: rod.start}}}}
states:
  released: {{rod.angle: {angle}, at rest: all}}
find: {{alpha: rod.angular_acceleration at released}}
"""
ATWOOD = """title: Two blocks over a pulley
given: {{m: {m}, n: {n}, M: 3 kg, R: 10 cm, g: 9.8 m/s^2}}
bodies:
  left:   {{mass: m, moves: down}}
  right:  {{mass: n, moves: up}}
  pulley: {{shape: disc, mass: M, radius: R}}
connections:
  axle:   {{axle: pulley}}
  string: {{string: [left, pulley, right]}}
states: {{start: at rest}}
find: {{a: left.acceleration}}
"""
SPRING = """title: Block on a spring
gravity: none
given: {m: 3 kg, k: 12 N/m, v: 0.5 m/s, x0: 10 cm}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections:
  base: {contact: [block, floor]}
  coil: {spring: [ground, block], stiffness: k}
states: {start: {block.velocity: v, coil.elongation: x0}}
find: {a: block.acceleration}
"""
DRAG = """title: Flywheel in oil
gravity: none
given: {J: 2 kg m^2, c: 0.7 N m s, w: 30 rad/s}
bodies: {wheel: {inertia: J, turns: counterclockwise}}
connections: {axle: {axle: wheel}}
actions: {oil: {couple: -c*wheel.angular_velocity, on: wheel}}
states: {start: {wheel.angular_velocity: w}}
find: {alpha: wheel.angular_acceleration}
"""
SLIDING = """title: Block thrown over a rough floor
given: {m: 2 kg, mu: 0.25, v: 4 m/s, g: 9.8 m/s^2}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}}
states: {thrown: {block.velocity: v}}
find: {a: block.acceleration}
"""
SHAKEN = """title: Block pulled to and fro on a rough floor
given: {m: 2 kg, F: 12 N, w: 3 rad/s, g: 9.8 m/s^2}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: {static: 0.4, kinetic: 0.3}}}
actions: {pull: {force: F*sin(w*time), on: block, direction: right}}
states: {start: at rest}
find: {a: block.acceleration}
"""
TWO_RODS = """title: Rod hanging from the end of a rod
given: {M: 2 kg, m: 0.7 kg, L: 1.5 m, l: 0.8 m, g: 9.8 m/s^2}
bodies:
  upper: {shape: rod, mass: M, length: L}
  lower: {shape: rod, mass: m, length: l}
connections:
  pivot: {hinge: upper.start}
  elbow: {hinge: [upper.end, lower.start]}
states: {now: {upper.angle: -20 deg, lower.angle: -75 deg, at rest: all}}
find: {alpha: upper.angular_acceleration}
"""
DRIVEN_PULLEY = """title: Pulley on a rubbing axle under a force that comes and goes
gravity: none
given: {J: 0.5 kg m^2, R: 20 cm, tau: 1 N m, F: 12 N, w: 2 rad/s}
bodies: {pulley: {inertia: J, radius: R, turns: counterclockwise}}
connections: {axle: {axle: pulley, friction_torque: tau}}
actions: {pull: {force: F*sin(w*time), on: pulley.rim, direction: tangential}}
states: {start: at rest}
find: {alpha: pulley.angular_acceleration}
"""
