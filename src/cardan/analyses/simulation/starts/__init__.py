"""Consistent states at which runs start."""
