"""Momentum and angular momentum: at an instant, over a phase, through an event."""
