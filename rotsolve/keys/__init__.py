"""keys: answer keys, sheets of problems, and their variants."""
