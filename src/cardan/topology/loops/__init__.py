"""Closed loops of the system graph."""
