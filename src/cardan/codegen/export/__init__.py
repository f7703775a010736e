"""Exports: models as plain C that compiles alone."""
