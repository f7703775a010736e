"""Verification of elements in tables."""
