"""Sparse linear systems of small blocks."""
