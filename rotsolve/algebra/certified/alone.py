"""Alone: the lock of who works with certified numbers among other threads: their precision is one for all threads of a process."""

from threading import Lock

ALONE = Lock()
