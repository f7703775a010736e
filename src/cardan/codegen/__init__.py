"""Functions as C that people can read: programs, names, files, manifest."""

from .writing import CFile, generate

__all__ = ["CFile", "generate"]
