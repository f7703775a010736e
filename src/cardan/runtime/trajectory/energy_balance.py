"""Balance of the energy of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING, final

import numpy as np

from ...arrays import Array
from ...records import dataclass
from .interpolation import inputs_at

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord

# of what a source has given, by which it may go up and yet be said to take energy only
LEVEL = 1e-9
ROUNDING = 1e-14


@final
@dataclass(frozen=True)
class Balance:
    """The energy of a run [J], from its first to its last row.

    Attributes:
        before, after: Total energy at the start and at the end.
        supplied: What sources and inputs gave, where they gave any.
        taken: What they took back.
        dissipated: What went into sources that only take, by name.
        impacts: What impacts and other jumps took, by element.
        residual: Largest amount along the run that none of it accounts for.
    """

    before: float
    after: float
    supplied: float
    taken: float
    dissipated: dict[str, float]
    impacts: dict[str, float]
    residual: float

    def __str__(self) -> str:
        parts = [f"{self.before:.6g} J, then {self.after:.6g} J"]
        parts += [f"supplied {self.supplied:.4g}"] if self.supplied else []
        parts += [f"taken {self.taken:.4g}"] if self.taken else []
        for label, some in (("dissipated", self.dissipated), ("impacts", self.impacts)):
            parts += [f"{label} {sum(some.values()):.4g}"] if some else []
        return ", ".join(parts)


def balance(motion: TrajectoryRecord) -> Balance:
    """The balance of a run.

    Raises:
        ModelError: the model has no function ``energy`` or ``power``.
    """
    total = motion.energy.total
    supplied, taken, dissipated = 0.0, 0.0, dict[str, float]()
    jumps = impacts(motion)
    for name, history in motion.work.items():
        if name in jumps:
            continue
        change = np.diff(history)
        up, down = float(change[change > 0].sum()), float(-change[change < 0].sum())
        if down > 0 and up <= LEVEL * down:
            dissipated[name] = down - up
        else:
            supplied, taken = supplied + up, taken + down
    lost = {name: -float(history[-1]) for name, history in jumps.items()}
    worst = float(np.abs(motion.energy_residual).max())
    return Balance(float(total[0]), float(total[-1]), supplied, taken, dissipated, lost, worst)


def losses(motion: TrajectoryRecord) -> Array:
    """Change of the energy in everything that happened (count,) [J]; empty where not known."""
    if "losses" in motion.stored:
        return motion.stored["losses"]
    log = motion.event_log.log
    available = "energy" in motion.manifest.available
    if motion.model is None or not len(log) or not available:
        return np.zeros(0)
    before, after = motion.event_log.states(motion.x.shape[1])
    jumped = np.flatnonzero((before != after).any(axis=1))
    changes = np.zeros(len(log))
    if len(jumped):
        t = log[jumped, 0]
        r = inputs_at(motion, t) if motion.r.shape[1] else None
        totals = []
        for states in (before[jumped], after[jumped]):
            q, u = motion.model.split(states)
            totals.append(motion.model.energy(q, u, t=t, r=r).total)
        change = totals[1] - totals[0]
        # what a projection rounds is no loss
        small = np.abs(change) <= ROUNDING * np.abs(totals).max()
        changes[jumped] = np.where(small, 0.0, change)
    motion.stored["losses"] = changes
    return changes


def impacts(motion: TrajectoryRecord) -> dict[str, Array]:
    """Energy that jumps have given since the start (nt,), negative, by element [J]."""
    changes, event_log = losses(motion), motion.event_log
    gains: dict[str, Array] = {}
    sign = 1.0 if len(motion) < 2 or motion.t[-1] >= motion.t[0] else -1.0
    # the first of two rows of one time stands before what happened
    first = np.append(motion.t[1:] == motion.t[:-1], False)
    for line, change in zip(event_log.log, changes, strict=False):
        if change == 0:
            continue
        fired = np.flatnonzero(line[1 : 1 + len(event_log.rows)])
        owners = dict.fromkeys(event_log.rows[k]["element"] for k in fired)
        late = sign * (motion.t - line[0])
        behind = (late > 0) | ((late == 0) & ~first)
        name = f"{' + '.join(owners)}.impact"
        gains[name] = gains.get(name, 0.0) + np.where(behind, change, 0.0)
    return gains
