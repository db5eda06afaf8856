"""Places: where everything in a scene goes on paper, in metres."""
