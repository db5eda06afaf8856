"""Paths: what a path such as `rod.end.acceleration` stands for at one moment."""
