"""Pages: what is printed, as blocks that are data, and the formats that print them."""
