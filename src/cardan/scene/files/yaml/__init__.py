"""Scene files: YAML 1.2 that says with the same words what Python says."""

from .reader import from_text, read

__all__ = ["from_text", "read"]
