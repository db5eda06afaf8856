"""Vectors: directions and vectors in the plane, the words for them, and the inertia tensor."""
