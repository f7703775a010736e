"""Nodes carried to where the coordinates of the joints say, for the start of runs and searches."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..calling import Array
from . import loading
from .trailing import trailed

if TYPE_CHECKING:
    from ..compiled import CompiledModel

SAVED = "states"


def carried(model: CompiledModel, x: Array, rest: Collection[str]) -> Array:
    """A state with its nodes where the joints carry them from the ground, and moving so.

    Args:
        model: In absolute coordinates.
        x: State (nx,) whose coordinates and speeds of joints hold.
        rest: Names of the entries that may change; all others were given.
    """
    from ...ir.serialize import from_dict

    # coordinates of the tree have the same names here
    made = from_dict(model._objects.saved()[SAVED])
    blocks = {block.name: block.entries for block in made.inputs}
    q, u = model.split(x)[:2]
    at = {name: k for k, name in enumerate(model.coordinates)}
    of = {name: k for k, name in enumerate(model.speeds)}
    inputs = np.array([row["default"] or 0.0 for row in model.manifest["inputs"]])

    def nodes(q: Array, u: Array) -> Mapping[str, Array]:
        r, p = inputs[: len(blocks["r"])], model.parameters.vector
        found: Mapping[str, Array] = model._evaluate_saved(SAVED, t=np.zeros(1), q=q, u=u, r=r, p=p)
        return found

    tree = q[[at[name] for name in blocks["q"]]], u[[of[name] for name in blocks["u"]]]
    found = nodes(*tree)
    free, moved, names = set(rest), x.copy(), model.coordinates
    for entries, first, values in ((names, 0, found["q"]), (model.speeds, model.nq, found["u"])):
        for k, value in enumerate(values):
            if entries[k] in free:
                moved[first + k] = value
    tables = loading.tables(model.manifest, model.directory)
    if not tables.beams:
        return moved
    # nodes that only beams hold go along, unless somebody says where they are
    own = {k: names[tables.q[k] : tables.q[k + 1]] for k in model.manifest["mesh"]["loose"]}
    loose = {k for k, entries in own.items() if free.issuperset(entries)}
    held = set(range(len(tables.kind))) - loose
    # beams are without stress where all joints are at their own defaults
    rest_of = np.array(model.manifest["mesh"]["rest"], dtype=np.float64)
    reference = model._layout.start("q").copy()
    placed = nodes(rest_of, 0 * tree[1])["q"]
    reference[: len(placed)] = placed
    return trailed(tables, tables.beams, reference, moved, held)
