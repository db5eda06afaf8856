"""Run time against error: problems with references of 60 digits, and what solves them."""
