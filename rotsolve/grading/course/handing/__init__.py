"""Handing in: answers of one student, or of a class, as text that says where everything stands."""
