"""A state out of named initial values."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, miscounted, near
from ...processes import collector_paused
from ...schema.manifest import Manifest
from ..calls.layout import Layout
from ..verification.rotations import unit
from .named_rotations import check_units, component, refuse_components

if TYPE_CHECKING:
    from .loaded_model import LoadedModel


def start_of(
    model: LoadedModel,
    q: Mapping[str, ArrayLike],
    u: Mapping[str, ArrayLike],
    z: Mapping[str, ArrayLike] | None = None,
) -> tuple[Array, tuple[str, ...]]:
    """Same as :func:`initial_state`;

    nodes of absolute coordinates go where the joints carry them.
    """
    if q or u or z:
        return _with_nodes(model, q, u, z)
    if start_of not in model._derived:
        model._derived[start_of] = _with_nodes(model, q, u, z)
    x, defaulted = model._derived[start_of]
    return x.copy(), defaulted


@collector_paused()
def _with_nodes(
    model: LoadedModel,
    q: Mapping[str, ArrayLike],
    u: Mapping[str, ArrayLike],
    z: Mapping[str, ArrayLike] | None,
) -> tuple[Array, tuple[str, ...]]:
    x, defaulted = initial_state(model._layout, q, u, z)
    if not model.manifest.absolute:
        return x, defaulted
    from .finite_elements.joint_driven_nodes import follow_joints

    return follow_joints(model, x, defaulted), defaulted


def initial_state(
    layout: Layout,
    q: Mapping[str, ArrayLike],
    u: Mapping[str, ArrayLike],
    z: Mapping[str, ArrayLike] | None = None,
) -> tuple[Array, tuple[str, ...]]:
    """State x = [q, u, z] from values by joint (``"elbow"``, ``"base"``) or entry (``"base.px"``).

    Args:
        layout: Of the model.
        q, u: Values; a joint with several coordinates takes all of them at once.
        z: Internal states by their names.

    Returns:
        x (nx,) with quaternions of unit length to rounding, and the names of the entries that
        were not given: they come from q0 and u0 of their joints, else they are those of the
        reference position; internal states start as their elements say.

    Raises:
        ModelError: an unknown name, a joint without coordinates of its own, a value given twice,
            single components of a quaternion.
        ArgumentError: the wrong number of values.
        SolveError: a value that is not finite, or a quaternion whose length is not 1.
    """
    manifest = layout.manifest
    x, end, defaulted = np.concatenate([layout.starts[b] for b in "quz"]), 0, list[str]()
    for letter, names, named in (
        ("q", layout.coordinates, q),
        ("u", layout.speeds, u),
        ("z", layout.internals, z),
    ):
        block, end = x[end : end + len(names)], end + len(names)
        if not named:
            defaulted += names
            continue
        covered = _fill(letter, block, names, layout, named)
        defaulted += [name for name, is_named in zip(names, covered, strict=True) if not is_named]
    if manifest.quaternions:
        q_block = x[: len(layout.coordinates)]
        check_units(manifest, q_block)
        q_block[:] = unit(q_block, manifest.quaternions)
    return x, tuple(defaulted)


def _fill(
    letter: str, block: Array, names: Sequence[str], layout: Layout, named: Mapping[str, ArrayLike]
) -> list[bool]:
    """Write named values into a block; which entries they cover."""
    manifest, places = layout.manifest, layout.slots[letter]
    covered = [False] * len(names)
    for name, value in named.items():
        place = places.get(name)
        if place is None:
            problem = missing(manifest, letter, name, places)
            raise ModelError(f"{letter}={{'{name}': ...}}: {problem}")
        if any(covered[place]):
            raise ModelError(
                f"{letter}={{'{name}': ...}}: '{names[place.start]}' is given twice, once by "
                "joint, once by entry"
            )
        size = place.stop - place.start
        if size == 1 and type(value) is float and isfinite(value):
            block[place.start] = value
        else:
            block[place] = _numbers(f"{letter}={{'{name}': ...}}", value, [*names[place]])
        covered[place] = [True] * size
    if letter == "q" and manifest.quaternions:
        named_here = {k for k, is_covered in enumerate(covered) if is_covered}
        refuse_components(manifest, "q=", named_here)
    return covered


def missing(manifest: Manifest, letter: str, name: str, available: Iterable[str]) -> str:
    """Why there is no such entry of q, u or z, with the known names and the likely one.

    Who names one component of a rotation is not sent to another one.
    """
    part = component(manifest, name) if letter == "q" else ""
    if part:
        return part
    if letter == "z":
        return f"there is no internal state '{name}'.{near(name, available)}"
    what = {"q": "coordinate", "u": "speed"}[letter]
    # what is there is not misspelled
    follows = _follows(name, what, manifest)
    if follows:
        return f"{follows}{near('', available)}"
    return f"there is no joint or {what} '{name}'.{near(name, available)}"


def _follows(name: str, what: str, manifest: Manifest) -> str:
    """Why a joint that is there has nothing of its own; "" where there is no such joint."""
    joint = next((j for j in manifest.joints if j.name == name), None)
    closing = {row.name for row in manifest.cuts}
    if joint is None and name in closing:
        return (
            f"joint '{name}' closes a kinematic loop and has no {what} of its own: the others "
            "determine it. Name others, or let cut=True cut another joint of the loop."
        )
    if joint is not None and joint.coupled:
        return f"joint '{name}' follows '{joint.coupled.leader}' and has no {what} of its own."
    if joint is not None and joint.solved:
        return f"joint '{name}' follows from the loop that '{joint.solved.loop}' closes."
    if joint is not None:
        return _prescribed(name, what, manifest)
    # in absolute coordinates every joint has multipliers, and one that closes a loop nothing else
    if manifest.absolute and name in {row.joint for row in manifest.multipliers}:
        return (
            f"'{name}' closes a kinematic loop and has no {what} of its own: the others determine "
            "it. Name others."
        )
    return ""


def _prescribed(name: str, what: str, manifest: Manifest) -> str:
    """Message about a joint whose motion is prescribed, and how to choose between positions."""
    cure = "Leave it out: its motion gives its value at the start."
    joint = next((j for j in manifest.joints if j.slot("q")[1] == 1), None)
    if what == "coordinate" and manifest.cuts and joint is not None and not manifest.absolute:
        cure += (
            " Of several positions of the loop, "
            f"q=model.assemble(branch={{'{joint.name}': '+'}}).q takes one."
        )
    return f"joint '{name}' moves as prescribed and has no {what} of its own. {cure}"


def _numbers(where: str, value: ArrayLike, entries: list[str]) -> Array:
    """The values of some entries, checked."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise ArgumentError(f"{where}: {brief(value)} is not a number")
    array = np.atleast_1d(array.astype(np.float64))
    if array.shape != (len(entries),):
        raise ArgumentError(miscounted(where, array.size, entries))
    for entry, number in zip(entries, array, strict=True):
        if not np.isfinite(number):
            raise SolveError(f"{where}: '{entry}' is {number}. Every initial value must be finite")
    return array
