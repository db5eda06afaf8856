"""Animation: a motion that has been followed, as a page on which its picture moves."""
