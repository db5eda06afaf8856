"""In space: the assembly for scenes with `up: z`: bodies with a place and a rotation each, held by constraints on points and directions.

Nothing is chosen to make equations short: each body has the velocity of its centre of mass and its angular velocity along the axes of
space, each joint ties them, and the tensor is turned into space.
"""
