"""Numbers for the symbols of a reference motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import DerivationError, near
from .reference import Reference
from .reference_input import NOMINAL

OPEN = 1e-8  # of loops: what assembling leaves at the most, with room for other numbers


def by_name(at: Reference, named_values: Mapping[str, object]) -> dict[str, Array]:
    """Inputs of Functions at the reference: numbers or arrays by name, the rest by default.

    Raises:
        DerivationError: an unknown name, a symbol without a value, or loops that do not close.
    """
    parameters, symbols = at.names["p"], at.symbols.values
    for name in named_values:
        if name != "t" and name not in parameters and name not in symbols:
            names = (*parameters, *symbols)
            raise DerivationError(f"linearize: there is no symbol '{name}'.{near(name, names)}")
    p = [named_values.get(x.name, x.value) for x in at.system.parameters]
    nominal = {name: named_values.get(name, value) for name, value in symbols.items()}
    for name, value in nominal.items():
        if value is None:
            raise DerivationError(f"linearize: symbol '{name}' needs a value: {name}=...")
    # coordinates that were assembled follow whatever else is said
    followed = [] if at.assembly is None else at.assembly.names
    if followed and any(name not in ("t", *followed) for name in named_values):
        nominal |= {
            name: x for name, x in _closed_again(at, p, nominal).items() if name not in named_values
        }
    values = {"t": [named_values.get("t", 0.0)], "p": p, NOMINAL: list(nominal.values())}
    stacked_values = {name: stacked(row) for name, row in values.items()}
    if named_values and not at.trusted and not at.open_at(stacked_values) <= OPEN:
        raise DerivationError(
            "linearize: the loops do not close at the reference with "
            f"{', '.join(named_values)} as "
            "given. Give coordinates as expressions in what changes, or fewer of them, so that "
            "those left out are assembled anew; or the values as defaults of the scene"
        )
    return stacked_values


def _closed_again(at: Reference, p: list[Any], nominal: Mapping[str, object]) -> dict[str, Any]:
    """Assembled coordinates at other numbers, state by state."""
    assert at.assembly is not None
    table, n = stacked([*p, *nominal.values()]), len(p)
    flat = table.reshape(-1, table.shape[-1])
    solutions = np.array([at.assembly.at(row[:n], row[n:]) for row in flat])
    solutions = solutions.reshape(*table.shape[:-1], -1)
    names = at.names["q"]
    return {name: solutions[..., names.index(name)] for name in at.assembly.names}


def stacked(entries: Sequence[object]) -> Array:
    """Numbers or arrays that broadcast as one array (..., n)."""
    if not entries:
        return np.zeros(0)
    arrays = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in entries))
    return np.stack(arrays, axis=-1)
