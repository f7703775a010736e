"""Nastran: matrices as DMIG in punch files, such as KAAX and MAAX of EXTSEOUT(DMIGPCH).

Fields have eight columns, or sixteen with a star. GRID in the same file, or in another one, gives
the positions. Made by the manual; no file of the program was at hand.

Source: MSC Nastran, Quick Reference Guide, DMIG and GRID.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...arrays import Array
from ...errors import ModelError, brief
from .labeled import Positions, labeled_matrices, with_positions
from .matrix_files import MOST_ENTRIES, ComponentMatricesRecord, MatrixReader
from .records import integer, number, text_lines

SQUARE, SYMMETRIC = 1, 6  # forms of DMIG
REAL = (1, 2)  # types of its numbers
Card = tuple[int, list[str]]  # number of its line, its fields behind the name


def _read(contents: Mapping[str, bytes], names: Mapping[str, str]) -> ComponentMatricesRecord:
    """Stiffness and mass of one or two files."""
    file = names["stiffness"]
    cards = _cards(text_lines(contents["stiffness"], file), file)
    heavy, mass_file = cards, names.get("mass", file)
    if "mass" in contents:
        heavy = _cards(text_lines(contents["mass"], mass_file), mass_file)
    K, M = _entries(cards["DMIG"], "K", file), _entries(heavy["DMIG"], "M", mass_file)
    grid, plain = _grid(cards["GRID"], file), None
    if "nodes" in contents:
        lines = text_lines(contents["nodes"], names["nodes"])
        if any(line.upper().startswith("GRID") for line in lines):
            grid = _grid(_cards(lines, names["nodes"])["GRID"], names["nodes"])
        else:
            grid, plain = with_positions(contents["nodes"], names["nodes"])
    if plain is not None:
        raise ModelError(f"{names['nodes']}: give the number of each node before x, y, z")
    return labeled_matrices((K, M), (file, mass_file), grid)


def _cards(lines: Sequence[str], file: str) -> dict[str, list[Card]]:
    """DMIG and GRID with their continuations; other lines are left out."""
    cards: dict[str, list[Card]] = {"DMIG": [], "GRID": []}
    last: list[str] | None = None
    for k, line in enumerate(lines, 1):
        head = line[:8].strip().upper()
        if not line.strip() or line.startswith("$"):
            continue
        name = head.partition(",")[0].rstrip("*")
        if name in cards:
            last = _fields(line)
            cards[name].append((k, last))
        elif last is not None and (not head or head[0] in "*+,"):
            last += _fields(line)
        else:
            last = None
        if sum(map(len, cards.values())) > MOST_ENTRIES:
            raise ModelError(f"{file}: more than {MOST_ENTRIES} cards; split the component")
    return cards


def _fields(line: str) -> list[str]:
    """Fields of a line behind the first: 8 columns each, 16 with a star, or between commas."""
    if "," in line:
        return [word.strip() for word in line.split(",")[1:]]
    width, count = (16, 4) if "*" in line[:8] else (8, 8)
    padded = line.ljust(72)
    return [padded[8 + width * k : 8 + width * (k + 1)].strip() for k in range(count)]


def _entries(cards: Sequence[Card], letter: str, file: str) -> Array:
    """Node, direction, node, direction, value of the one matrix whose name has a first letter.

    Raises:
        ModelError: none or several of them, or one that is neither real nor square.
    """
    heads = [card for card in cards if card[1][0].upper().startswith(letter) and card[1][1] == "0"]
    if len(heads) != 1:
        names = ", ".join(sorted({card[1][0] for card in cards})) or "none"
        raise ModelError(
            f"{file}: {len(heads)} matrices whose names begin with {letter}, expected one. DMIG "
            f"there: {names}"
        )
    line, head = heads[0]
    name, form, kind = head[0], integer(head[2], file, line), integer(head[3], file, line)
    if form not in (SQUARE, SYMMETRIC) or kind not in REAL:
        raise ModelError(f"{file}:{line}: {name} of form {form} and type {kind}; a real square one")
    rows: list[tuple[float, ...]] = []
    for k, fields in cards:
        if fields[0] != name or fields[1] == "0":
            continue
        column = integer(fields[1], file, k), integer(fields[2], file, k)
        # behind name, node, direction and an empty field
        for start in range(4, len(fields), 4):
            entry = [*fields[start : start + 4], "", "", ""][:4]
            if entry[3]:
                raise ModelError(
                    f"{file}:{k}: {brief(entry[3])} behind a value, which is real: it has an "
                    "imaginary part, or does not fit its field"
                )
            if any(entry):
                row = integer(entry[0], file, k), integer(entry[1], file, k)
                if 0 in (row[1], column[1]):
                    raise ModelError(
                        f"{file}:{k}: {name} has a scalar point, which is not a motion of a node; "
                        "write the matrix before its reduction"
                    )
                rows.append((*row, *column, number(entry[2], file, k)))
    if not rows:
        raise ModelError(f"{file}: {name} has no columns")
    return np.array(rows)


def _grid(cards: Sequence[Card], file: str) -> Positions | None:
    """Numbers and positions of nodes.

    Raises:
        ModelError: one in axes of its own.
    """
    rows: dict[int, list[float]] = {}
    for k, fields in cards:
        parts = [*fields, *[""] * 6]
        node = integer(parts[0], file, k)
        if parts[1] not in ("", "0") or parts[5] not in ("", "0"):
            raise ModelError(f"{file}:{k}: node {node} has other axes; write it in the basic ones")
        if node in rows:
            raise ModelError(f"{file}:{k}: node {node} is there twice")
        rows[node] = [number(word or "0", file, k) for word in parts[2:5]]
    return Positions(tuple(rows), np.array([*rows.values()]), file) if rows else None


NASTRAN = MatrixReader("Nastran DMIG", (".pch", ".dat", ".bdf"), _read, {}, untested=True)
