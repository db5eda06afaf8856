"""Inertia: mass, centre of mass and moments of inertia, from the table, by theorems or by integration."""
