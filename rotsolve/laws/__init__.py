"""Laws: the table of laws, and the functions that write them from facts."""
