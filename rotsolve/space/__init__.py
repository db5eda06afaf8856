"""Space: scenes with z up: how bodies stand and turn there, the laws in three components, and what can be asked of them."""
