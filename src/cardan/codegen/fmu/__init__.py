"""Functional Mock-up Units: an exported model with a description that other programs read."""
