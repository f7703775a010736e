"""Analyses of compiled systems: each returns a record."""
