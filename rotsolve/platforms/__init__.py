"""Platforms: sheets as questions of learning platforms: Moodle XML, STACK, QTI packages. What is right is what `check` says."""
