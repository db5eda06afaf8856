"""Signs: what is drawn for each body, surface and connection, and the letters and arrows beside them."""
