"""Kinds of cells: one per file. A new kind is one file and one line here."""

from __future__ import annotations

from . import hex8, hex20, quad4, quad8, tet4, tet10, tri3, tri6
from .cell import Cell, Rule

MEMBERS = (tet4, tet10, hex8, hex20, tri3, tri6, quad4, quad8)
CELLS: dict[str, Cell] = {member.CELL.kind: member.CELL for member in MEMBERS}
SOLIDS: dict[str, Cell] = {kind: cell for kind, cell in CELLS.items() if cell.dimension == 3}
FACES: dict[str, Cell] = {kind: cell for kind, cell in CELLS.items() if cell.dimension == 2}

__all__ = ["CELLS", "FACES", "SOLIDS", "Cell", "Rule"]
