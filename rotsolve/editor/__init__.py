"""Editor: what an editor asks of a scene while it is written: faults, completions, help, fixes, places; `server` speaks the protocol."""
