"""Languages a model can be written in: name -> module with ``write`` and ``SUFFIX``.

``c`` writes a Program; what calls the C, such as ``cython``, writes from the manifest.
"""

from __future__ import annotations

from types import ModuleType

from . import c, cython

LANGUAGES: dict[str, ModuleType] = {"cython": cython, "c": c}
