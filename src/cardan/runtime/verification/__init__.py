"""Judges of compiled functions: independent routes to the numbers of every build."""
