"""Grading: what a student wrote is read, compared with the answers of the scene, and marked."""
