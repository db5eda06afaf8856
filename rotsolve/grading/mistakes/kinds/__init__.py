"""Kinds of mistakes, by what they are made with, each a function from a scene to what it looks like and changes at each place."""
