"""Which results of elements add up to a function: powers, outputs, reactions, forces by name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....errors import ModelError
from ....records import dataclass
from ....schema.finite_elements import MOTION_NUMBERS
from ....schema.manifest import Manifest
from .elements import Elements, State
from .tables import Integers, Table, Tables

ENERGIES, WRENCH = 2, 6
BODIES = "bodies"


@dataclass(frozen=True)
class Summands:
    """Sums to which the elements of some groups add results.

    Attributes:
        form: Function of the elements whose results these are.
        count: How many sums there are.
        which: Number of a group -> (n, size) the sum to which each result of its elements adds;
            ``count`` where to none.
    """

    form: str
    count: int
    which: Mapping[int, Integers]

    def total(self, elements: Elements, at: State) -> Array:
        """The sums (count,) at a state."""
        sums: Array = np.zeros(self.count + 1)
        having = having_form(elements.tables, self.form)
        for k, results in zip(having, elements.results(self.form, at), strict=True):
            if k in self.which:
                np.add.at(sums, self.which[k], results)
        return sums[:-1]


def having_form(tables: Tables, form: str) -> list[int]:
    """Numbers of the groups whose elements have a function."""
    return [k for k, group in enumerate(tables.groups) if form in group.kind.functions]


def of_scene(tables: Tables, name: str) -> Summands:
    """Those of a function of the whole scene: energy, momentum, power or outputs."""
    groups = having_form(tables, name)
    if name in ("power", "outputs"):
        count = len(tables.powers) if name == "power" else tables.outputs
        read = {k: tables.groups[k] for k in groups}
        listed = {k: x.powers if name == "power" else x.outputs for k, x in read.items()}
        return Summands(name, count, {k: x for k, x in listed.items() if x is not None})
    count = ENERGIES if name == "energy" else WRENCH
    return Summands(name, count, {k: _every(tables.groups[k], count) for k in groups})


def of_reaction(tables: Tables, manifest: Manifest, joint: str) -> Summands:
    """Those of the reaction of a joint.

    Raises:
        ModelError: it transmits none.
    """
    elements = manifest.elements
    if joint in elements.tree_joints:
        # shares of the elements that it carries
        form, number = "reactions", elements.tree_joints.index(joint)
        shares = {k: tables.groups[k].reactions for k in having_form(tables, form)}
        return Summands(
            form,
            WRENCH,
            {k: _blocks(x == number, WRENCH) for k, x in shares.items() if x is not None},
        )
    if joint not in elements.reactions:
        raise ModelError(
            f"reaction: '{joint}' transmits none in model '{manifest.name}' in absolute coordinates"
        )
    group, member = elements.reactions[joint]
    _size(tables, manifest, "reaction", group)
    alone = np.arange(len(tables.groups[group])) == member
    return Summands("reaction", WRENCH, {group: _blocks(alone[:, None], WRENCH)})


def of_body(tables: Tables, manifest: Manifest, place: tuple[int, int, int]) -> Summands:
    """Motion of a body of a rigid tree: group, member, number of the body.

    Raises:
        ModelError: there is no such body.
    """
    group, member, body = place
    size = _size(tables, manifest, BODIES, group)
    if not (member < len(tables.groups[group]) and body < size // MOTION_NUMBERS):
        raise _no_element(manifest, BODIES)
    here = np.zeros((len(tables.groups[group]), size // MOTION_NUMBERS), dtype=bool)
    here[member, body] = True
    return Summands(BODIES, MOTION_NUMBERS, {group: _blocks(here, MOTION_NUMBERS)})


def of_forces(tables: Tables, manifest: Manifest) -> Summands:
    """Those of the forces of elements by name; elements that never exert any have no function.

    Raises:
        ModelError: an element has not as many forces as names.
    """
    form, count = "element_forces", len(manifest.element_forces)
    which = {
        k: np.full((len(tables.groups[k]), _size(tables, manifest, form, k)), count, dtype=np.intp)
        for k in having_form(tables, form)
    }
    taken, start = Counter[tuple[int, int]](), 0
    for name, rows in groupby(manifest.element_forces, lambda row: row.element):
        group, member = manifest.elements.forces.get(name, (-1, 0))
        entries = len(list(rows))
        first = taken[group, member]
        taken[group, member] += entries
        if group in which:
            line = which[group][member : member + 1, first : first + entries]
            if line.shape != (1, entries):
                raise _no_element(manifest, form)
            line[0] = np.arange(start, start + entries)
        start += entries
    return Summands(form, count, which)


def _size(tables: Tables, manifest: Manifest, form: str, group: int) -> int:
    """Number of results of a function for every element of a group.

    Raises:
        ModelError: its elements have no such function.
    """
    if not (group < len(tables.groups) and form in tables.groups[group].kind.functions):
        raise _no_element(manifest, form)
    size: int = manifest.functions[tables.groups[group].kind.functions[form]].output_size
    return size


def _no_element(manifest: Manifest, form: str) -> ModelError:
    return ModelError(
        f"model '{manifest.name}': the manifest names elements for {form} that it does not have. "
        "Compile the scene again"
    )


def _every(group: Table, count: int) -> Integers:
    """Every element adds its results to the same sums."""
    return np.tile(np.arange(count), (len(group), 1)).astype(np.intp)


def _blocks(counts: NDArray[np.bool_], size: int) -> Integers:
    """Of blocks (n, k) of results those that count add to the sums, (n, k size)."""
    which = np.where(counts[:, :, None], np.arange(size), size)
    return which.reshape(len(counts), -1).astype(np.intp)
