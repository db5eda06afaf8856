"""Actions: forces, couples and powers that act from outside."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rotsolve.algebra.formula import Formula
from rotsolve.scene.keys import key
from rotsolve.scene.model import PointRef

Direction = str | Formula | tuple[Formula, Formula]
DIRECTIONS = ("right", "left", "up", "down", "tangential", "clockwise", "counterclockwise")


@dataclass(frozen=True)
class Action:
    """Base of all actions. An action between two states is absent before and after."""

    word: ClassVar[str] = ""
    about: ClassVar[str] = ""
    quantities: ClassVar[tuple[str, ...]] = ()
    later: ClassVar[bool] = False
    name: str = ""
    from_: str | None = key("name", "the state at which it begins", default=None, refers=("state",))
    to: str | None = key("name", "the state at which it ends", default=None, refers=("state",))


@dataclass(frozen=True)
class Force(Action):
    word = "force"
    about = "a force on a point of a body; pulled off a wheel's rim with `over` or `under`"
    quantities = ("force", "torque", "work", "power", "impulse", "angular_impulse")
    force: Formula | None = key("quantity", "size; `unknown` asks for it", dimension="force", letter="F", varies=True, required=True, example="20 N")
    on: PointRef | None = key("point", "where it acts", required=True, example="rod.end")
    direction: Direction | None = key(
        "direction", "right, left, up, down, tangential, clockwise, counterclockwise, [x, y] or an angle", default=None, choices=DIRECTIONS
    )
    over: bool = key("flag", "the pull leaves the wheel at its top", default=False)
    under: bool = key("flag", "the pull leaves the wheel at its bottom", default=False)


@dataclass(frozen=True)
class Couple(Action):
    word = "couple"
    about = "a torque without a force, along the body's positive sense unless `direction` says otherwise"
    quantities = ("torque", "work", "power", "angular_impulse")
    couple: Formula | None = key("quantity", "torque; `unknown` asks for it", dimension="torque", letter="tau", varies=True, required=True)
    on: PointRef | None = key("point", "the body that it turns", required=True, example="wheel")
    direction: Direction | None = key(
        "direction", "clockwise or counterclockwise", default=None, choices=("clockwise", "counterclockwise")
    )


@dataclass(frozen=True)
class Press(Action):
    word = "press"
    about = "a brake block pressed on a rim"
    quantities = ("force", "normal_force", "friction_force", "torque", "work", "power")
    later = True
    press: Formula | None = key("quantity", "force that presses", dimension="force", letter="F", varies=True, required=True)
    on: PointRef | None = key("point", "the rim", required=True, example="wheel.rim")
    friction: Formula | None = key("quantity", "coefficient of friction", dimension="number", letter="mu", limits="nonnegative", required=True)


@dataclass(frozen=True)
class Power(Action):
    word = "power"
    about = "a motor of given power turning a body"
    quantities = ("power", "torque", "work")
    power: Formula | None = key("quantity", "power; `unknown` asks for it", dimension="power", letter="P", varies=True, required=True)
    on: PointRef | None = key("point", "the body that it drives", required=True, example="wheel")


ACTIONS: tuple[type[Action], ...] = (Force, Couple, Press, Power)
