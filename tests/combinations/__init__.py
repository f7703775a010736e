"""Scenes in which many features meet, each against an independent route."""
