"""Keys: answer keys, sheets of problems, and their variants."""
