"""Shapes of a reduced component that one looks at: modes, and static shapes of its interfaces."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array
from ..errors import ArgumentError, ModelError, brief, counted, near
from ..records import dataclass
from .record import SuperelementRecord

FIXED, FREE, STATIC = "fixed", "free", "static"
KINDS = (FIXED, FREE, STATIC)


@dataclass(frozen=True, eq=False)
class ModeShape:
    """A shape of a component.

    Attributes:
        description: What it is, such as ``"mode 1 with all interfaces fixed"``.
        z: In the reduced coordinates (n,): of unit modal mass, or by 1 m or 1 rad.
        omega: Its frequency [rad/s], 0 of static shapes.
    """

    description: str
    z: Array
    omega: float


def mode_shape(
    record: SuperelementRecord,
    mode: int | str,
    which: str = FIXED,
    locked: Sequence[str] | None = None,
) -> ModeShape:
    """A shape by its number.

    Args:
        record: The component.
        mode: Number from 1; of static shapes also the motion, such as ``"hinge.rx"``.
        which: ``"fixed"``, ``"free"`` or ``"static"``.
        locked: Interfaces, or motions of them, that are fixed; all by default.

    Raises:
        ArgumentError: another kind, or what is locked where nothing is.
        ModelError: there is no such mode, or no such interface.
        SolveError: as :meth:`.SuperelementRecord.modes`.
    """
    if which not in KINDS:
        raise ArgumentError(f"which={brief(which)}: there are no such shapes.{near(which, KINDS)}")
    if locked is not None and which != FIXED:
        raise ArgumentError(f"locked={brief(locked)}: of which='{FIXED}' only; leave it out")
    if which == STATIC:
        return _static(record, mode)
    every = [frame.name for frame in record.interfaces]
    names = [] if which == FREE else every if locked is None else locked
    modes = record.modes(names)
    if not len(modes.frequencies):
        raise ModelError(
            f"which='{which}': '{record.method}' left no mode; which='{STATIC}' shows its shapes"
        )
    k = _number(mode, len(modes.frequencies), "mode")
    omega = float(modes.frequencies[k])
    where = _fixed_text(names, every)
    return ModeShape(f"mode {k + 1}, {where}, {omega:.6g} rad/s", modes.shapes[:, k], omega)


def _fixed_text(names: Sequence[str], every: Sequence[str]) -> str:
    """What is fixed, for people."""
    if not names:
        return "all interfaces free"
    if [*names] == [*every]:
        return "all interfaces fixed"
    return f"{names if isinstance(names, str) else ', '.join(names)} fixed"


def _static(record: SuperelementRecord, mode: int | str) -> ModeShape:
    """The shape by a unit motion of an interface, the others being fixed."""
    labels = record.labels[: record.n_boundary]
    if isinstance(mode, str):
        if mode not in labels:
            raise ModelError(f"there is no static shape {brief(mode)}.{near(mode, labels)}")
        k = labels.index(mode)
    else:
        k = _number(mode, len(labels), "static shape")
    unit = "rad" if labels[k].rpartition(".")[2].startswith("r") else "m"
    return ModeShape(f"static shape by 1 {unit} of {labels[k]}", np.eye(record.n)[k], 0.0)


def _number(mode: int | str, count: int, noun: str) -> int:
    """Place of a shape by its number from 1."""
    if isinstance(mode, str) or not 1 <= mode <= count:
        raise ModelError(
            f"mode={brief(mode)}: the component has {counted(count, noun)}; give a number from 1 "
            f"to {count}, then the file"
        )
    return mode - 1
