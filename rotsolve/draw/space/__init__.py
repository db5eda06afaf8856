"""Scenes in space, seen obliquely."""
