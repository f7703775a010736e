"""Closed loops and other constraints, and the ways to treat them."""
