"""Contacts: bodies that touch and push on each other, with or without friction, at rest, sliding or rolling."""
