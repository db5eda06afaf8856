"""Derivation: what is told of a solved scene, in letters, lines and words, and what is held against the answers."""
