"""A course: what one student or a class hands in is read, marked, and reported."""
