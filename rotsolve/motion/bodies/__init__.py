"""Bodies: what is known of a rigid body by itself: its pieces, its own axes, its data at each state, how its mass is spread."""
