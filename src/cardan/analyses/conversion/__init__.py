"""States in the coordinates and speeds of other programs."""
