"""Drawing: pictures of scenes, and the free-body diagrams of their bodies."""
