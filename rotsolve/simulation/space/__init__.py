"""Scenes in space as they move in time: rotations by unit quaternions, rates in axes that go with the bodies, by the laws of `space/`."""
