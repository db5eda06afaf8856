"""Solving: closed forms for the unknown of linear, quadratic and trigonometric equations, and for linear systems."""
