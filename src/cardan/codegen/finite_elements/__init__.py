"""Folders of models whose elements stand in tables."""
