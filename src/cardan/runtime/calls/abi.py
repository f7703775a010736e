"""The way into generated C: the extension where it was built, else ctypes."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ...schema.blocks import ORDER
from . import abi_ctypes

__all__ = ["NAME", "fast", "first_bad", "prepare", "run"]

if TYPE_CHECKING:
    NAME = abi_ctypes.NAME
    from .abi_ctypes import fast, first_bad, prepare, run
else:
    chosen = abi_ctypes
    if os.environ.get("CARDAN_ABI") != "ctypes":
        try:
            from . import _abi as chosen
        except ImportError:
            # no extension on this machine: the same interface through ctypes
            chosen = abi_ctypes
        if getattr(chosen, "BLOCK_COUNT", len(ORDER)) != len(ORDER):
            # built for another version of the interface
            chosen = abi_ctypes
    NAME, fast, first_bad = chosen.NAME, chosen.fast, chosen.first_bad
    prepare, run = chosen.prepare, chosen.run
