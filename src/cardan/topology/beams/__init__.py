"""Beams as nodes and the segments between them."""
