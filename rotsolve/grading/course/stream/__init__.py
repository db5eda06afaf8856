"""A stream: papers without end, read, marked and written in batches, here or on a cluster, of which few are held at a time."""
