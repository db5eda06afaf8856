"""language: what the scene language declares: its keys and words, how answers are marked, and the Problem that a scene becomes."""
