"""Layout: what the scene tells of places is kept, strings run straight and tangent, and nothing overlaps that does not touch."""

from __future__ import annotations

import math
from functools import cache

import pytest
from gallery import PLANE, problem

from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.signs import normal, rests, surface_of
from rotsolve.draw.paper.tikz import tikz
from rotsolve.draw.pictures import scene_picture
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.draw.plane.places.overlaps import overlapping, plane_stage
from rotsolve.draw.plane.places.rules import meetings_to_come
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.elements.connections.supports import Hinge
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
