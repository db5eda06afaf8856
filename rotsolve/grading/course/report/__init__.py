"""The report of a class: its pages as blocks, and the folder that holds them."""
