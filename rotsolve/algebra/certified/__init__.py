"""Certified: numbers in ball arithmetic, and roots found with them."""
