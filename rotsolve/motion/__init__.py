"""Motion: which bodies are one and how they can move, how they stand at one moment, free bodies, phases."""
