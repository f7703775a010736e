"""Motions that repeat: cycles through events, their multipliers, and paths of them."""
