"""Layout: what the scene tells of places is kept, strings run straight and tangent, and nothing overlaps that does not touch."""

from __future__ import annotations

import math
from functools import cache

import pytest
from gallery import PLANE, problem

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.signs import normal, rests, surface_of
from rotsolve.draw.paper.figure import FORCE, SENSE, SPIN, SURFACE, Line, box_of
from rotsolve.draw.paper.labels import crosses, straight_pieces
from rotsolve.draw.paper.tikz import tikz
from rotsolve.draw.pictures import scene_picture
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.draw.plane.places.overlaps import hull, overlapping, plane_stage
from rotsolve.draw.plane.places.rules import meetings_to_come
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.scene import draw_scene, largest_first, plane_scale
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.strings import draw_spring
from rotsolve.elements.connections.drives import Gear
from rotsolve.elements.connections.supports import Hinge
from rotsolve.elements.connections.touch import Touch
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_text

NEAR = 2e-3  # of the measure of a scene


@cache
def stage(name: str) -> PlaneStage:
    """A problem at its first state."""
    configuration = configured(problem(name))
    states = problem(name).states
    return plane_stage(configuration, numbers_for(configuration), states[0].name if states else "")


@pytest.mark.parametrize("name", PLANE)
def test_nothing_overlaps(name: str) -> None:
    assert not list(overlapping(stage(name)))


@pytest.mark.parametrize("name", PLANE)
def test_legs_run_along_their_directions_and_touch_their_rims(name: str) -> None:
    found = stage(name)
    for _, _, leg in found.legs():
        if leg.along is None:
            continue
        ends = []
        for ref, side in ((leg.first, leg.sides[0]), (leg.second, leg.sides[1])):
            place = found.leg_end(ref, side, leg.along)
            ends.append(None if place is None or ref.owner not in found.bodies else found.middle(place))
            if side:
                centre = found.middle(found.place_of(ref.owner, found.model.spot(ref)))
                arm = (ends[-1][0] - centre[0], ends[-1][1] - centre[1])  # type: ignore[index]
                assert math.hypot(*arm) == pytest.approx(radius_of(found.model.body(ref.owner), ref.point, found.value))
                assert arm[0] * leg.along[0] + arm[1] * leg.along[1] == pytest.approx(0.0, abs=1e-9)
        if None not in ends:
            (ax, ay), (bx, by) = ends  # type: ignore[misc]
            across = (bx - ax) * leg.along[1] - (by - ay) * leg.along[0]
            along = (bx - ax) * leg.along[0] + (by - ay) * leg.along[1]
            assert abs(across) < NEAR * found.sizes.whole
            assert along > 0.0


@pytest.mark.parametrize("name", PLANE)
def test_what_lies_on_a_flat_surface_touches_it(name: str) -> None:
    found = stage(name)
    for item in found.kinds.contacts:
        surface, ref = surface_of(item, found.model), item.pair()[0]
        if (
            surface is None
            or surface.curved
            or surface.name not in found.surfaces
            or item.pair()[1].owner in found.bodies
        ):
            continue
        out = normal(surface, found.model)
        body = found.bodies[ref.owner]
        level = found.surfaces[surface.name][1].at(found.found)
        if found.model.turns(ref.owner) or rests(item, found.model):
            touched = body.place[0] * out[0] + body.place[1] * out[1] - body.reach((-out[0], -out[1]))
        else:
            x, y = body.spot(found.model.tied(ref))
            touched = x * out[0] + y * out[1]
        assert touched == pytest.approx(level, abs=2 * NEAR * found.sizes.whole)


@pytest.mark.parametrize("name", PLANE)
def test_hinges_join_points_of_two_bodies(name: str) -> None:
    found = stage(name)
    coming = meetings_to_come(found)
    for item in found.model.acting.connections:
        refs = item.touches()
        if type(item) is Hinge and len(refs) == 2 and all(ref.owner in found.bodies for ref in refs):
            assert {ref.owner for ref in refs} not in coming
            (ax, ay), (bx, by) = (found.bodies[ref.owner].spot(found.model.drawn(ref)) for ref in refs)
            assert math.dist((ax, ay), (bx, by)) < NEAR * found.sizes.whole


def test_a_title_is_never_more_than_a_comment_of_tex() -> None:
    """A line break in it would end the comment, and TeX would carry out what follows."""
    scene = 'title: "one\\n\\\\input{two}\\r\\u2028three"\nbodies: {block: {mass: 2 kg, moves: down}}\n'
    scene += "find: {a: block.acceleration}\n"
    lines = tikz(scene_picture(read_text(scene))).split("\n")
    assert lines[0] == r"% one \input{two} three" and not any("input" in line for line in lines[1:])


def inside(point: tuple[float, float], polygon: list[tuple[float, float]]) -> bool:
    """Whether a point is within a polygon without dents, its corners counterclockwise."""
    x, y = point
    return all(
        (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0
        for (ax, ay), (bx, by) in zip(polygon, [*polygon[1:], polygon[0]], strict=True)
    )


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", PLANE)
def test_no_body_hides_a_smaller_one(name: str) -> None:
    """The edge of what lies on or in another body is drawn later than what that is filled with, in the same layer."""
    sheet = ScenePaper(plane_scale(stage(name)))
    for body in largest_first(stage(name)):
        for outline in body.shown():
            sheet.outline(outline)
    filled = [mark for mark in sheet.figure.in_layers() if mark.role.fill]
    boxes = [box_of(mark) for mark in filled]
    for early, one in enumerate(boxes):
        for late, other in enumerate(boxes[early + 1 :], early + 1):
            covers = other[0] < one[0] and other[1] < one[1] and one[2] < other[2] and one[3] < other[3]
            assert not covers, (filled[early].role.name, filled[late].role.name)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", PLANE)
def test_what_two_bodies_do_to_each_other_acts_at_one_place(name: str) -> None:
    """Where rims mesh and where round bodies lie on each other: the bodies of the picture meet where the laws say so."""
    known = SceneFacts(stage(name))
    items = {item.name: item for item in known.stage.model.acting.connections}
    meeting = {owner for owner, item in items.items() if isinstance(item, Gear) or is_round_pair(item, known)}
    places: dict[tuple[str, Formula], list[tuple[float, float]]] = {}
    for body in (body for body in known.facts.bodies if body.name in known.stage.bodies):
        for force in (force for force in body.forces if force.owner in meeting and force.size != ZERO):
            places.setdefault((force.owner, force.size), []).append(known.applied(force))
    for (owner, _), found in places.items():
        if len(found) == 2:
            assert math.dist(*found) < NEAR * known.stage.sizes.whole, owner


def is_round_pair(item: Connection, known: SceneFacts) -> bool:
    """Whether one round body touches another one, which both have a radius."""
    if not isinstance(item, Touch) or item.side is not None:
        return False
    owners = [ref.owner for ref in item.pair()[:2]]
    return all(owner in known.stage.bodies and known.stage.rim(PointRef(owner)) for owner in owners)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", PLANE)
def test_springs_end_at_the_sides_of_blocks(name: str) -> None:
    found = stage(name)
    sheet = ScenePaper(1.0)
    for item in found.kinds.springs:
        draw_spring(item, found, sheet)
    ends = [end for mark in sheet.figure.marks if isinstance(mark, Line) for end in (mark.points[0], mark.points[-1])]
    for body in (body for body in found.bodies.values() if body.block):
        shrunk = [
            (body.place[0] + 0.9 * (x - body.place[0]), body.place[1] + 0.9 * (y - body.place[1]))
            for x, y in hull(body.bound())
        ]
        assert not any(inside(end, shrunk) for end in ends), body.name


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", PLANE)
def test_arrows_of_senses_lie_on_no_other_body(name: str) -> None:
    """Nor on arrows of forces and on each other."""
    found = stage(name)
    figure = draw_scene(found)
    arrows = [mark for mark in figure.marks if isinstance(mark, Line) and mark.heads and mark.role in (SENSE, SPIN)]
    forces = [mark for mark in figure.marks if isinstance(mark, Line) and mark.heads and mark.role is FORCE]
    for number, arrow in enumerate(arrows):
        for other in (*arrows[number + 1 :], *forces):
            pieces = list(straight_pieces(other))
            for (ax, ay), (bx, by) in straight_pieces(arrow):
                box = (min(ax, bx) - 0.1, min(ay, by) - 0.1, max(ax, bx) + 0.1, max(ay, by) + 0.1)
                assert not any(crosses(piece, box) for piece in pieces), (arrow.points, other.points)


POST = """
title: Loads on a rope round a peg
given: {{m: 2 kg, M: 5 kg, mu: 0.3}}
surfaces: {{peg: post, table: level}}
bodies: {{one: {{mass: M, moves: {way}}}, load: {{mass: m, moves: down}}}}
connections: {{rope: {{string: [one, peg, load], friction: mu, wrap: {wrap} deg}}{under}}}
states: {{start: at rest}}
find: {{T: rope.load.tension}}
"""


@pytest.mark.parametrize(("way", "wrap", "under"), [("up", 180, ""), ("right", 90, ", under: {contact: [one, table]}")])
def test_a_rope_round_a_post_touches_it_on_both_sides(way: str, wrap: int, under: str) -> None:
    """Both strands straight to it, square to its radius, and the loads on their own sides of it."""
    configuration = configured(read_text(POST.format(way=way, wrap=wrap, under=under)))
    found = plane_stage(configuration, numbers_for(configuration), "start")
    [(_, _, first), (_, _, last)] = list(found.legs())
    x, y = found.middle(found.post("peg"))
    for leg, ref in ((first, first.second), (last, last.first)):
        assert leg.along is not None
        end = found.leg_end(ref, 0, leg.along)
        assert end is not None
        u, w = found.middle(end)
        assert math.hypot(u - x, w - y) == pytest.approx(found.post_radius)
        assert (u - x) * leg.along[0] + (w - y) * leg.along[1] == pytest.approx(0.0, abs=1e-9)
    assert found.bodies["one"].place[0] < x < found.bodies["load"].place[0]
    assert not list(overlapping(found))


def test_what_leans_between_a_wall_and_a_wedge_lies_on_the_wedge() -> None:
    """Over its slope, and the wall ends above that."""
    figure = scene_picture(problem("rolling/rod-that-drives-a-wedge"))
    found = stage("rolling/rod-that-drives-a-wedge")
    wedge, rod = (found.bodies[name].bound() for name in ("wedge", "rod"))
    assert min(x for x, _ in wedge) < min(x for x, _ in rod) < max(x for x, _ in rod) < max(x for x, _ in wedge)
    walls = [mark for mark in figure.marks if mark.role is SURFACE and isinstance(mark, Line)]
    upright = [mark for mark in walls if abs(mark.points[0][0] - mark.points[1][0]) < 1e-6]
    floor = min(y for mark in walls for _, y in mark.points)
    assert upright and all(min(y for _, y in mark.points) > floor + 10.0 for mark in upright)
