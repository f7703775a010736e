"""Nodes carried to where the coordinates of the joints say, for the start of runs and searches."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

import numpy as np

from ..calling import Array

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
    found = model._evaluate_saved(
        SAVED,
        t=np.zeros(1),
        q=q[[at[name] for name in blocks["q"]]],
        u=u[[of[name] for name in blocks["u"]]],
        r=inputs[: len(blocks["r"])],
        p=model.parameters.vector,
    )
    free, moved = set(rest), x.copy()
    for names, first, values in (
        (model.coordinates, 0, found["q"]),
        (model.speeds, model.nq, found["u"]),
    ):
        for k, value in enumerate(values):
            if names[k] in free:
                moved[first + k] = value
    return moved
