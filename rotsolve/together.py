"""Together: the bytecode of the modules that every run loads, in one piece, which is kept as this module's own bytecode.

Of two hundred files each brings the same names; in one piece they are made once. Whoever has this source alone has nothing kept: `lean`
writes the piece after a run that has solved a scene, and takes a module from it as long as its source is as it was then.
"""

from types import CodeType

Piece = tuple[str, tuple[int, int], CodeType]  # where the source is, its time and size, and its bytecode
KEPT: tuple[Piece, ...] = ()
