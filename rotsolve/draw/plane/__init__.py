"""Scenes in the plane: where their bodies stand on paper, and what is drawn for each element."""
