"""Checkpoints and run files."""
