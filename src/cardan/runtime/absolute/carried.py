"""Nodes carried to where the coordinates of the joints say, for the start of runs and searches."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import islice
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..calling import Array
from . import loading
from .tables import Tables
from .trailing import trailed

if TYPE_CHECKING:
    from ..compiled import CompiledModel

SAVED = "states"
ROUNDING = 1e-14
# entries of the coordinates and speeds of a node in space
POSE, MOTION = ("w", "x", "y", "z", "px", "py", "pz"), ("x", "y", "z", "px", "py", "pz")


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
    tables, names, free = loading.tables_of(model), model.coordinates, set(rest)
    inputs = np.array([row["default"] or 0.0 for row in model.manifest["inputs"]])

    def nodes(q: Array, u: Array) -> Mapping[str, Array]:
        r, p = inputs[: len(blocks["r"])], model.parameters.vector
        found: Mapping[str, Array] = model._evaluate_saved(SAVED, t=np.zeros(1), q=q, u=u, r=r, p=p)
        return found

    def by_joints(x: Array) -> Array:
        q, u = model.split(x)[:2]
        told = _joints(model, tables, q, u, {*blocks["q"], *blocks["u"]})
        found, moved = nodes(*(np.array([told[n] for n in blocks[b]]) for b in "qu")), x.copy()
        for entries, first, values in ((names, 0, found["q"]), (model.speeds, len(q), found["u"])):
            for k, value in enumerate(values):
                if entries[k] in free:
                    moved[first + k] = value
        return moved

    moved = by_joints(x)
    if not tables.beams:
        return moved
    # nodes that only beams hold go along, unless somebody says where they are
    own = {k: names[tables.q[k] : tables.q[k + 1]] for k in model.manifest["mesh"]["loose"]}
    loose = {k for k, entries in own.items() if free.issuperset(entries)}
    held = set(range(len(tables.kind))) - loose
    # beams are without stress where all joints are at their own defaults
    rest_of = np.array(model.manifest["mesh"]["rest"], dtype=np.float64)
    reference = model._layout.start("q").copy()
    placed = nodes(rest_of, np.zeros(len(blocks["u"])))["q"]
    reference[: len(placed)] = placed
    # what was given stays as it is, nodes between others too
    kept = np.array([name not in free for name in (*names, *model.speeds)])
    # bodies that joints hold on the end of a beam follow it, and carry the next beam
    for _ in range(len(loose) + 1):
        trail = trailed(tables, tables.beams, reference, moved, held)
        trail[: len(kept)][kept] = moved[: len(kept)][kept]
        before, moved = moved, by_joints(trail)
        # the joints round what beams said: the same again is all there is
        if np.allclose(moved, before, rtol=ROUNDING, atol=ROUNDING):
            break
    return moved


def leading(model: CompiledModel) -> NDArray[np.bool_]:
    """Whether a speed is that of a joint (nu,): nodes of bodies and beams follow those."""
    from ...ir.serialize import from_dict

    made = from_dict(model._objects.saved()[SAVED])
    told = next(set(block.entries) for block in made.inputs if block.name == "u")
    tables = loading.tables_of(model)
    loose, found = set(model.manifest["mesh"]["loose"]), np.zeros(model.nu, dtype=bool)
    for place, row in enumerate(model.manifest["joints"]):
        start, count = row["u"]
        free = f"{row['name']}.u.px" in told and place not in loose
        found[start : start + count] = free or not tables.kinds[tables.kind[place]].node
    return found


def _joints(
    model: CompiledModel, tables: Tables, q: Array, u: Array, wanted: Collection[str]
) -> dict[str, float]:
    """Coordinates and speeds of the joints by name; of nodes of a plane those in space too."""
    pairs = ((model.coordinates, q), (model.speeds, u))
    told = {
        name: float(x)
        for names, values in pairs
        for name, x in zip(names, values, strict=False)
        if name in wanted
    }
    # nodes inside of beams are the last places and no joints
    named = len(tables.kind) - sum(len(line) - 2 for line in tables.beams)
    for place, row in enumerate(islice(model.manifest["joints"], named)):
        if tables.kinds[tables.kind[place]].plane is not None:
            pose, speeds = tables.pose(q, place), tables.speeds(u, place)
            told |= {f"{row['name']}.{x}": v for x, v in zip(POSE, pose, strict=True)}
            told |= {f"{row['name']}.u.{x}": v for x, v in zip(MOTION, speeds, strict=True)}
    return told
