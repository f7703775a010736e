"""Compiled models as data and calls."""
