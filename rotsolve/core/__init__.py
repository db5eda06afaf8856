"""Core: the records that all rooms share: facts, laws, equations, quantities, vectors, the derivation, faults."""
