"""Moving: the equations of motion of a scene, from where it starts, and what may happen on the way."""
