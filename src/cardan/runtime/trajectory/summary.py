"""A run on one screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from itertools import islice
from textwrap import wrap
from typing import TYPE_CHECKING

import numpy as np

from ...errors import CardanError, counted
from .event_log import Event, told

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord

LISTED = 12
AT_REST = 1e-9  # kinetic energy below this part of the others is that of rounding
WIDTH = 80  # of a line behind its word
Rows = list[tuple[str, str]]


def summary(motion: TrajectoryRecord) -> str:
    """What was run, how, from where, and how well energy was kept."""
    return "\n".join([headline(motion), *(f"  {word:<9} {text}" for word, text in rows(motion))])


def headline(motion: TrajectoryRecord) -> str:
    """What was run, and how it ended."""
    span = f"{motion.t[0]:g} s to {motion.t[-1]:g} s" if len(motion) else "no time"
    return f"motion of '{motion.manifest.name}', {span}: {motion.message}"


def rows(motion: TrajectoryRecord) -> Rows:
    """How it went: a word and what there is to say, in lines of which later ones have no word."""
    conduct, count = motion.conduct, motion.conduct.statistics
    lines = [("method", f"{conduct.method}, {conduct.settings}")]
    for word, text in (("warning", conduct.warning), ("note", conduct.reason)):
        lines += _labelled(word, wrap(text, 88))
    lines += [
        ("rows", f"{counted(len(motion), 'time')}, {counted(motion.q.shape[1], 'coordinate')}, "
         f"{counted(motion.u.shape[1], 'speed')}{_own(motion)}"),
        ("steps", f"{count['steps']:.0f}, {count['rejections']:.0f} rejected, "
         f"{count['evaluations']:.0f} evaluations{_factors(count)} in "
         f"{count['milliseconds']:.3g} ms"),
    ]  # fmt: skip
    if count.get("passed"):
        lines.append(("", f"over {counted(int(count['passed']), 'singular position')}"))
    defaulted = set(conduct.defaulted)
    given = {n: v for n, v in conduct.initial.items() if n not in defaulted}
    lines += _values("start", "given", given)
    rest = {n: v for n, v in conduct.initial.items() if n in defaulted}
    inputs = {row.name for row in motion.manifest.inputs}
    if any(not row.switched for row in motion.manifest.multipliers):
        # circuits determine coordinates and speeds; inputs keep what the scene says
        lines += _values("start", "assembled", {n: v for n, v in rest.items() if n not in inputs})
        rest = {n: v for n, v in rest.items() if n in inputs}
    lines += _values("start", "by default", rest)
    return [*lines, *_events(motion), *_samples(motion), *_energy(motion), *_constraints(motion)]


def _labelled(word: str, lines: list[str]) -> Rows:
    """Lines below one word."""
    return [(word if k == 0 else "", line) for k, line in enumerate(lines)]


def _values(label: str, origin: str, values: dict[str, float]) -> Rows:
    """Named values, a few lines at most; equal zeros are counted rather than listed."""
    if not values:
        return []
    shown = [f"{name} = {value:.6g}" for name, value in islice(values.items(), LISTED)]
    if len(values) > LISTED:
        rest = list(values.values())[LISTED:]
        zeros = "all 0" if not any(rest) else f"{sum(v != 0 for v in rest)} of them not 0"
        shown.append(f"and {len(rest)} more ({zeros})")
    lines, line = [], f"{origin}: "
    for k, text in enumerate(shown):
        piece = text + (", " if k + 1 < len(shown) else "")
        if len(line) + len(piece) > WIDTH:
            lines.append(line.rstrip())
            line = ""
        line += piece
    return _labelled(label, [*lines, line.rstrip()])


def _factors(count: Mapping[str, float]) -> str:
    """What implicit methods do besides evaluations."""
    made = count.get("factorizations", 0)
    jacobians = count.get("jacobians", 0)
    return f", {jacobians:.0f} Jacobians, {made:.0f} factorizations" if made else ""


def _own(motion: TrajectoryRecord) -> str:
    """How many states elements keep, where they do."""
    counts = ((motion.z.shape[1], "internal state"), (motion.s.shape[1], "mode"))
    return "".join(f", {counted(count, what)}" for count, what in counts if count)


def _events(motion: TrajectoryRecord) -> Rows:
    """What happened how often and when first, a few lines at most."""
    if all(row["kind"] == "tick" for row in motion.happened.rows):
        return []
    groups: dict[str, list[Event]] = {}
    for event in motion.events:
        groups.setdefault(f"{event.name} ({event.kind})", []).append(event)
    lines = [
        f"{name}{f', {len(some)} times' if len(some) > 1 else ''}: {told(some)}"
        for name, some in groups.items()
    ]
    rest = len(lines) - LISTED
    shown = [*lines[:LISTED], *([f"and {rest} more"] if rest > 0 else [])] or ["none"]
    return _labelled("events", shown)


def _samples(motion: TrajectoryRecord) -> Rows:
    """How often controllers sampled."""
    counts = Counter(event.name for event in motion.ticks)
    told = [f"{name} {count} times" for name, count in counts.items()]
    rest = len(told) - LISTED
    text = ", ".join([*told[:LISTED], *([f"and {rest} more"] if rest > 0 else [])])
    return [("samples", text)] if told else []


def _energy(motion: TrajectoryRecord) -> Rows:
    # a mode that is played keeps no ledger
    if not len(motion) or not motion.conduct.statistics["steps"]:
        return []
    try:
        energy, drift = motion.energy, motion.drift
    except CardanError as error:
        return [("drift", f"not known: {error}")]
    worst, scale = float(np.abs(drift).max()), float(np.abs(energy.kinetic).max())
    whole = max(float(np.abs(energy.potential).max()), *(abs(g).max() for g in motion.given.T), 0.0)
    # what hardly moves has no kinetic energy to compare with
    moving = scale > AT_REST * whole
    relative = f" ({worst / scale:.1e} of the largest kinetic energy)" if moving else " (at rest)"
    lines = [("drift", f"{worst:.1e} J of energy unaccounted for{relative}")]
    if motion.work:
        work = {name: float(given[-1]) for name, given in motion.work.items()}
        lines += _values("work", "in J", work)
        lines.append(("balance", str(motion.balance)))
    return lines


def _constraints(motion: TrajectoryRecord) -> Rows:
    """The worst residuals of a system with circuits, and where they were."""
    lines: list[str] = []
    if motion.ledger is None and len(motion):
        return _open(motion)
    for level in ("position", "velocity"):
        found = motion.ledger.worst(level) if motion.ledger is not None else None
        if found is not None:
            name, worst = found
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
