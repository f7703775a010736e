"""A run on one screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from itertools import islice
from textwrap import wrap
from typing import TYPE_CHECKING

import numpy as np

from ...errors import CardanError, counted
from ..models.node_names import of_node
from .event_log import Event, one_line

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord

LISTED = 12
STILL = 1e-9  # kinetic energy below this part of the others is that of rounding
WIDTH = 80  # of a line behind its word
Rows = list[tuple[str, str]]


def summary(motion: TrajectoryRecord) -> str:
    """Summary of a run: method, start, events, and conservation of energy."""
    return "\n".join([headline(motion), *(f"  {word:<9} {text}" for word, text in rows(motion))])


def headline(motion: TrajectoryRecord) -> str:
    """First line of the summary: the model and the outcome."""
    span = f"{motion.t[0]:g} s to {motion.t[-1]:g} s" if len(motion) else "no time"
    return f"motion of '{motion.manifest.name}', {span}: {motion.message}"


def rows(motion: TrajectoryRecord) -> Rows:
    """Rows of the summary: a label and text, in lines of which later ones have no label."""
    solver_info, count = motion.solver_info, motion.solver_info.statistics
    lines = [("method", f"{solver_info.method}, {solver_info.settings}")]
    for word, text in (("warning", solver_info.warning), ("note", solver_info.reason)):
        lines += _labelled(word, wrap(text, 88))
    lines += [
        ("rows", f"{counted(len(motion), 'time')}, {counted(motion.q.shape[1], 'coordinate')}, "
         f"{counted(motion.u.shape[1], 'speed')}{_state_sizes(motion)}"),
        ("steps", f"{count['steps']:.0f}, {count['rejections']:.0f} rejected, "
         f"{count['evaluations']:.0f} evaluations{_factors(count)} in "
         f"{count['milliseconds']:.3g} ms"),
    ]  # fmt: skip
    if count.get("passed"):
        lines.append(("", f"over {counted(int(count['passed']), 'singular position')}"))
    defaulted = set(solver_info.defaulted)
    named_values = {n: v for n, v in solver_info.initial.items() if n not in defaulted}
    lines += _values("start", "given", named_values)
    defaults = {n: v for n, v in solver_info.initial.items() if n in defaulted}
    inputs = {row.name for row in motion.manifest.inputs}
    if any(not row.switched for row in motion.manifest.multipliers):
        # loops determine coordinates and speeds; inputs keep what the scene says
        lines += _values(
            "start", "assembled", {n: v for n, v in defaults.items() if n not in inputs}
        )
        defaults = {n: v for n, v in defaults.items() if n in inputs}
    nodes = [name for name in defaults if of_node(motion.manifest, name)]
    lines += _values("start", "by default", {n: v for n, v in defaults.items() if n not in nodes})
    if nodes:
        lines.append(("start", f"of nodes of beams: {len(nodes)} entries, see motion.x[0]"))
    return [*lines, *_events(motion), *_samples(motion), *_energy(motion), *_constraints(motion)]


def _labelled(word: str, lines: list[str]) -> Rows:
    """Lines below one word."""
    return [(word if k == 0 else "", line) for k, line in enumerate(lines)]


def _values(label: str, origin: str, values: dict[str, float]) -> Rows:
    """Named values, a few lines at most; equal zeros are counted rather than listed."""
    if not values:
        return []
    entries = [f"{name} = {value:.6g}" for name, value in islice(values.items(), LISTED)]
    if len(values) > LISTED:
        remaining = list(values.values())[LISTED:]
        zeros = "all 0" if not any(remaining) else f"{sum(v != 0 for v in remaining)} of them not 0"
        entries.append(f"and {len(remaining)} more ({zeros})")
    lines, line = [], f"{origin}: "
    for k, text in enumerate(entries):
        text_part = text + (", " if k + 1 < len(entries) else "")
        if len(line) + len(text_part) > WIDTH:
            lines.append(line.rstrip())
            line = ""
        line += text_part
    return _labelled(label, [*lines, line.rstrip()])


def _factors(count: Mapping[str, float]) -> str:
    """Counts of Jacobians and factorizations of implicit methods."""
    factorizations = count.get("factorizations", 0)
    jacobians = count.get("jacobians", 0)
    return (
        f", {jacobians:.0f} Jacobians, {factorizations:.0f} factorizations"
        if factorizations
        else ""
    )


def _state_sizes(motion: TrajectoryRecord) -> str:
    """Number of states of elements, if there are any."""
    counts = ((motion.z.shape[1], "internal state"), (motion.s.shape[1], "mode"))
    return "".join(f", {counted(count, what)}" for count, what in counts if count)


def _events(motion: TrajectoryRecord) -> Rows:
    """Counts and first times of the events, a few lines at most."""
    if all(row["kind"] == "tick" for row in motion.event_log.rows):
        return []
    groups: dict[str, list[Event]] = {}
    for event in motion.events:
        groups.setdefault(f"{event.name} ({event.kind})", []).append(event)
    lines = [
        f"{name}{f', {len(some)} times' if len(some) > 1 else ''}: {one_line(some)}"
        for name, some in groups.items()
    ]
    left = len(lines) - LISTED
    printed = [*lines[:LISTED], *([f"and {left} more"] if left > 0 else [])] or ["none"]
    return _labelled("events", printed)


def _samples(motion: TrajectoryRecord) -> Rows:
    """Sample counts of the controllers."""
    counts = Counter(event.name for event in motion.ticks)
    counts_text = [f"{name} {count} times" for name, count in counts.items()]
    left = len(counts_text) - LISTED
    text = ", ".join([*counts_text[:LISTED], *([f"and {left} more"] if left > 0 else [])])
    return [("samples", text)] if counts_text else []


def _energy(motion: TrajectoryRecord) -> Rows:
    # a mode that is played keeps no ledger
    if not len(motion) or not motion.solver_info.statistics["steps"]:
        return []
    try:
        energy, residual = motion.energy, motion.energy_residual
    except CardanError as error:
        return [("energy", f"not known: {error}")]
    worst, scale = float(np.abs(residual).max()), float(np.abs(energy.kinetic).max())
    scale_of_energy = max(
        float(np.abs(energy.potential).max()), *(abs(g).max() for g in motion.work_done.T), 0.0
    )
    # what hardly moves has no kinetic energy to compare with
    moving = scale > STILL * scale_of_energy
    relative = f" ({worst / scale:.1e} of the largest kinetic energy)" if moving else " (at rest)"
    lines = [("energy", f"{worst:.1e} J unaccounted for{relative}")]
    if motion.work:
        work = {name: float(supplied[-1]) for name, supplied in motion.work.items()}
        lines += _values("work", "in J", work)
        lines.append(("balance", str(motion.balance)))
    return lines


def _constraints(motion: TrajectoryRecord) -> Rows:
    """The worst residuals of a system with loops, and where they were."""
    lines: list[str] = []
    if motion.ledger is None and len(motion):
        return _open(motion)
    for level in ("position", "velocity"):
        largest = motion.ledger.worst(level) if motion.ledger is not None else None
        if largest is not None:
            name, worst = largest
            lines.append(f"{level} of '{name}' to {worst}")
    return _labelled("closed", lines)


def _open(motion: TrajectoryRecord) -> Rows:
    """The worst residual of a system whose constraints give way, as penalties do."""
    try:
        worst = {name: float(np.abs(r).max()) for name, r in motion.constraints.items()}
    except CardanError:
        # a file, or a model without that function, does not say
        return []
    name = max(worst, key=worst.__getitem__, default=None)
    return [("open", f"'{name}' up to {worst[name]:.1e}: not projected")] if name else []
