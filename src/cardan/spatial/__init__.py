"""Frames, vectors, rotations, twists, wrenches and inertias, on expressions."""
