"""Languages a model can be written in: name -> module.

``c`` and ``wasm`` write a Program: they have ``write`` and ``SUFFIX``. What calls the exported C, such as
``cython``, writes from the manifest: it has a ``BINDING``.
"""

from __future__ import annotations

from types import ModuleType

from . import c, casadi, cython, jax, wasm
from .binding import Binding

LANGUAGES: dict[str, ModuleType] = {
    "cython": cython,
    "c": c,
    "casadi": casadi,
    "jax": jax,
    "wasm": wasm,
}
# those that an export may be asked for: what calls its C, or nothing beside it
BINDINGS: dict[str, Binding | None] = {
    name: getattr(module, "BINDING", None)
    for name, module in LANGUAGES.items()
    if name == "c" or hasattr(module, "BINDING")
}
