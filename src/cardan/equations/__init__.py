"""Equations of motion, derived from the system graph."""
