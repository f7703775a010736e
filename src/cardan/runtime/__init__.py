"""Compiled models: built, loaded, called, verified, and the records of their runs."""
