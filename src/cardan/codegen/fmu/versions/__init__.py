"""Versions of FMI: name -> what its description and its entry points are; one file each."""

from __future__ import annotations

from . import fmi2, fmi3
from .version import Version

VERSIONS: dict[str, Version] = {one.VERSION.name: one.VERSION for one in (fmi2, fmi3)}

__all__ = ["VERSIONS", "Version"]
