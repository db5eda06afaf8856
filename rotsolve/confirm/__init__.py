"""Confirm: an assembly of all bodies' equations in numbers, from the scene as read, by which answers are held against Newton's laws.

It shares nothing with the laws, the search and the configuration: places, constraints and forces are written once more, plainly.
"""


class NotConfirmed(Exception):
    """What the assembly does not speak of, with the reason."""


class Unfollowed(NotConfirmed):
    """A motion that is told whole, and that nothing here follows."""


class TooFar(NotConfirmed):
    """A way too long to be followed, with what is known of it: what lies at its end is neither tested nor refuted."""


class Unfit(Exception):
    """What a state in space tells is no motion, with the reason."""


class OverBudget(NotConfirmed):
    """A motion that costs more than the budget."""
