"""Course: the motion of a scene followed by the assembly from state to state, and the answers held against what is read from it."""
