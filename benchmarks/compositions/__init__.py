"""Compositions: scenes made of one body or two, held and joined in every way that the language can say, and what must hold of them."""
