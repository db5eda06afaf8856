"""Phases: what happens between two states that no event joins, as the laws of energy, momentum and kinematics read it."""
