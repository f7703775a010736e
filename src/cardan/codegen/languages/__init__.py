"""Languages a Program can be written in: name -> module with ``write`` and ``SUFFIX``."""

from __future__ import annotations

from types import ModuleType

from . import c

LANGUAGES: dict[str, ModuleType] = {"c": c}
