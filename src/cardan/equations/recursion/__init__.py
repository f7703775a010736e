"""Recursions over the tree, cut into steps."""
