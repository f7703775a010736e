"""Cables as point masses and the straight pieces between them."""
