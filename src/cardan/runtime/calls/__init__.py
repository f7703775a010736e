"""Calls of generated C from NumPy."""
