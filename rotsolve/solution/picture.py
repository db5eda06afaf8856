"""Picture: the scene of a solution and its free-body diagrams, drawn when they are asked for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

if TYPE_CHECKING:
    from rotsolve.language.problem import Problem
    from rotsolve.search.acting import ActingWays


class PictureView(Struct, frozen=True):
    """The picture of a scene at one of its states, the first unless another is named; drawn when it is asked for."""

    problem: Problem
    state: str = ""
    acting: Callable[[], ActingWays | None] = lambda: None

    def at(self, state: str) -> PictureView:
        """The same scene at another state."""
        return replace(self, state=state)

    @property
    def svg(self) -> str:
        """The scene as SVG."""
        from rotsolve.draw.paper.svg import svg
        from rotsolve.draw.pictures import scene_picture

        return svg(scene_picture(self.problem, self.state))

    @property
    def tikz(self) -> str:
        """The scene as a `tikzpicture`."""
        from rotsolve.draw.paper.tikz import tikz
        from rotsolve.draw.pictures import scene_picture

        return tikz(scene_picture(self.problem, self.state))

    @property
    def free_bodies(self) -> str:
        """The free-body diagrams as SVG: at the states of which the scene asks, unless another is named."""
        from rotsolve.draw.paper.svg import svg
        from rotsolve.draw.pictures import free_body_picture

        return svg(free_body_picture(self.problem, self.state, self.acting()))

    def _repr_svg_(self) -> str:
        return self.svg
