"""Elements: shapes, surfaces, connections, actions, events: each states facts at a moment, and writes no law."""
