"""Energy and momentum that a run cannot account for, against the error its tolerance allows.

A tolerance bounds the error of a step, and errors of steps add up over the periods that a run
resolves. So a tolerance rtol is worth

    energy     rtol (K + W) N       K: largest kinetic energy, W: work exchanged
    momentum   rtol P N             P: largest momentum exchanged
    closure    atol + rtol L        L: size of the scene; 1 of angles; times speeds of speeds

with N = max(1, duration / fastest period resolved). W is what potential energies and sources have
gone up and down by, P what single speeds have carried. A run that misses more than :data:`EXCESS`
times as much, or more than :data:`CEILING` of the whole, says so whatever its status. Methods of
order 2 take rtol^(2/3) for rtol, which their error in the end follows; atol counts beside rtol by
its part of the largest speed, and speeds below it are rest. Given steps name no tolerance: theirs
is taken as :data:`FIXED_STEP_RTOL`. What rounding adds is never an excess.
"""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...runtime.build.kernels import library as kernel_library
from ...runtime.models.constraint_projection import CLOSED, size_of
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.energy_balance import impacts
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.short_run_records import Account as Sums
from .run_record import kernels
from .settings import Settings

EXCESS = 100.0  # times what the tolerance is worth
CEILING = 0.1  # of what moves: more than that no tolerance is worth
FIXED_STEP_RTOL = 1e-4  # tolerance that a given step stands for
LOOKED = 256  # rows of a run that are looked at
PERIOD = 10.0  # steps that the fastest period resolved takes at least
FEW, PARTS = 9, 64  # rows, and groups of speeds, of which the momenta they carry are summed
MOMENTA = (("angular momentum", "N m s"), ("momentum", "N s"))
MIN_AMPLITUDE = 1e-3  # of the speed that varies most: those that vary by less show no period
ROUNDING = 64 * float(np.finfo(np.float64).eps)
"""of all that was added up, for every step's rounding"""


class Account(NamedTuple):
    """One quantity of a run.

    Attributes:
        what: Its name, for messages.
        missed: What is unaccounted for.
        worth: What the tolerance is worth.
        total: All that moved.
        noise: What rounding may add up to.
        unit: Of the four.
    """

    what: str
    missed: float
    worth: float
    total: float
    noise: float
    unit: str

    @property
    def most(self) -> float:
        """Largest error that counts as within tolerance."""
        return min(EXCESS * self.worth, CEILING * self.total) + self.noise

    @property
    def excessive(self) -> bool:
        """True when more is missed than the tolerance is worth many times over."""
        return not self.missed <= self.most

    def __str__(self) -> str:
        unit = self.unit
        sentence = f"{self.missed:.2g} {unit} of {self.what} unaccounted for"
        if EXCESS * self.worth < CEILING * self.total:
            return f"{sentence}, where the tolerance is worth {self.worth:.2g} {unit}"
        return f"{sentence}, where {self.total:.2g} {unit} was exchanged"


def accounts(
    motion: TrajectoryRecord,
    how: Settings,
    closure_tol: float = 0.0,
    library: ctypes.CDLL | None = None,
) -> list[Account]:
    """Every quantity of a run that can be accounted for.

    Args:
        motion: The run.
        how: Its tolerances.
        closure_tol: Residual, in sizes of the scene, up to which its start was taken as closed.
        library: The kernels, where they are at hand.
    """
    if len(motion) < 2:
        return []
    rows = _some(len(motion), LOOKED)
    summed = _summed(motion, rows, kernels(library or kernel_library()))
    fastest, periods = summed.fastest, _periods(motion, summed)
    atol, relative = (how.atol, how.rtol) if how.method.adaptive else (0.0, FIXED_STEP_RTOL)
    closures = _closure(motion, relative, atol, closure_tol, fastest)
    if fastest <= max(atol, ROUNDING):
        # at rest, as far as the tolerance tells: what is left of speeds is rounding
        return closures
    rtol = in_the_end(how, fastest)
    listed = [_energy(motion, summed, rtol, periods)] if summed.looked else []
    if isolated(motion):
        # speeds that stay at 0 are uncertain by this all the same
        doubt = atol + _rounded(motion, fastest)
        listed += _momentum(motion, rows, rtol, periods, doubt)
    return listed + closures


def excess(
    motion: TrajectoryRecord,
    how: Settings,
    closure_tol: float = 0.0,
    library: ctypes.CDLL | None = None,
) -> str:
    """Sentence about conservation errors beyond the tolerance; "" where there are none."""
    listed = accounts(motion, how, closure_tol, library)
    some = [account for account in listed if account.excessive]
    if not some:
        return ""
    cure = "rtol= and atol= smaller" if how.method.adaptive else "step= shorter"
    return f"{'; '.join(str(account) for account in some)}. Take {cure}, or another method"


def in_the_end(how: Settings, fastest: float) -> float:
    """The relative tolerance of a run: that of a step, over the steps that a period takes.

    Args:
        how: The tolerances.
        fastest: The largest speed, against which atol counts.
    """
    if not how.method.adaptive:
        return FIXED_STEP_RTOL
    relative = min(how.rtol + how.atol / fastest, 1.0) if fastest > 0 else 1.0
    # of order 2 a tighter tolerance takes more steps by its cube root
    return relative ** (2 / 3) if how.method.order == 2 else relative


def tolerated(how: Settings, fastest: Array, total: Array, rounded: Array, steps: Array) -> Array:
    """Conservation error to expect (runs,), where only the steps taken are known.

    Args:
        how: The tolerances.
        fastest: Their largest speeds.
        total: What moves.
        rounded: The largest amounts that are added up.
        steps: Of every run.
    """
    relative = np.array([in_the_end(how, speed) for speed in fastest.tolist()])
    worth = EXCESS * relative * np.maximum(1.0, steps / PERIOD)
    return np.minimum(worth, CEILING) * total + ROUNDING * rounded * np.maximum(10.0, steps)


@lru_cache(maxsize=64)
def _some(count: int, most: int) -> NDArray[np.intp]:
    """Rows of a table, evenly from its first to its last."""
    rows = np.arange(count) if count <= most else (np.arange(most) * (count - 1)) // (most - 1)
    rows.flags.writeable = False
    return rows


def _summed(motion: TrajectoryRecord, rows: NDArray[np.intp], library: ctypes.CDLL) -> Sums:
    """Sums over the rows of a run; of energies over some of them, where it has them."""
    model, x, sums = motion.model, np.ascontiguousarray(motion.x, dtype=np.float64), Sums()
    nq, nu = len(motion.manifest.coordinates), len(motion.manifest.speeds)
    sums.u, sums.count, sums.nu = x.ctypes.data + x.itemsize * nq, len(x), nu
    sums.stride, sums.every_step, sums.least = x.shape[1], motion.dense is not None, MIN_AMPLITUDE
    if model is not None and motion.sources is not None and "energy" in motion.manifest.available:
        energy, supplied = _energies(motion, model, rows)
        sums.energy, sums.supplied = energy.ctypes.data, supplied.ctypes.data
        sums.looked, sums.sources = supplied.shape
    library.cardan_account_of(sums)
    return sums


def _energies(
    motion: TrajectoryRecord, model: LoadedModel, rows: NDArray[np.intp]
) -> tuple[Array, Array]:
    """Energies (rows, 3) and what sources have given (rows, sources), impacts last."""
    x, nq = motion.x[rows], model.nq
    q, u = x[:, :nq].copy(), x[:, nq : nq + model.nu].copy()
    r = motion.r[rows] if motion.r.shape[1] else None
    energy = model._evaluate(("energy", None), (motion.t[rows], q, u, r), None, None)
    supplied = motion.work_done[rows]
    if len(motion.event_log.log):
        columns = [history[rows] for history in impacts(motion).values()]
        supplied = np.column_stack([supplied, *columns])
    # as the kernels read them
    return np.ascontiguousarray(energy), np.ascontiguousarray(supplied)


def _periods(motion: TrajectoryRecord, sums: Sums) -> float:
    """N: duration over the fastest period resolved."""
    count = motion.statistics["steps"] / PERIOD
    if motion.dense is not None and count > 1:
        # every step is there: periods are seen where speeds turn back
        count = min(count, sums.turns / 2)
    return max(1.0, count)


def _rounded(motion: TrajectoryRecord, size: float) -> float:
    """Bound on the accumulated rounding."""
    return ROUNDING * size * max(10.0, motion.statistics["steps"])


def _energy(motion: TrajectoryRecord, sums: Sums, rtol: float, periods: float) -> Account:
    """The energy of a run."""
    scale = float(sums.kinetic + sums.exchanged)
    noise = _rounded(motion, scale + float(sums.potential))
    return Account("energy", float(sums.missed), rtol * scale * periods, scale, noise, "J")


def _momentum(
    motion: TrajectoryRecord, rows: NDArray[np.intp], rtol: float, periods: float, doubt: float
) -> list[Account]:
    """Both momenta of a run where nothing acts from outside; all speeds are in doubt by so much."""
    model = motion.model
    if model is None or "momentum" not in motion.manifest.available or not model.nu:
        return []
    t, x = motion.t[rows], motion.x[rows]
    q, u = model.split(x)[:2]
    values = model.momentum(q, u, t=t)
    some = _some(len(rows), FEW)
    groups = np.array_split(np.arange(model.nu), min(model.nu, PARTS))
    magnitudes, noise = np.zeros((2, 2, len(some)))
    for group in groups:
        for total, speeds in ((magnitudes, u[some]), (noise, np.full_like(u[some], doubt))):
            alone = np.zeros_like(speeds)
            alone[:, group] = speeds[:, group]
            part = model.momentum(q[some], alone, t=t[some]).reshape(-1, 2, 3)
            total += np.linalg.norm(part, axis=2).T
    listed = []
    for k, (what, unit) in enumerate(MOMENTA):
        history = values[:, 3 * k : 3 * k + 3]
        missed = float(np.linalg.norm(history - history[0], axis=1).max())
        magnitude = float(magnitudes[k].max())
        worth = rtol * magnitude * periods
        listed.append(Account(what, missed, worth, magnitude, float(noise[k].max()), unit))
    return listed


def isolated(motion: TrajectoryRecord) -> bool:
    """True when nothing acts on the scene from outside, gravity included."""
    if not motion.manifest.isolated or motion.model is None:
        return False
    fixed: Mapping[str, float] = motion.manifest.structural
    free = motion.model.parameters
    names = [f"gravity.{axis}" for axis in "xyz"]
    return not any(free[name] if name in free else fixed.get(name, 0.0) for name in names)


def _closure(
    motion: TrajectoryRecord, rtol: float, atol: float, closure_tol: float, fastest: float
) -> list[Account]:
    """Closure errors of the loops."""
    model, ledger = motion.model, motion.ledger
    if model is None or ledger is None:
        return []
    size = size_of(model)
    fastest = max(1.0, fastest)
    noise, listed = 2 * max(closure_tol, CLOSED), list[Account]()
    for level, rate in (("position", 1.0), ("velocity", fastest)):
        scales = {True: rate, False: size * rate}
        limits = {k: (atol + rtol * x, x, noise * x) for k, x in scales.items()}
        listed += [
            Account(f"closure of '{name}'", w.after, *limits[w.unit.startswith("rad")], w.unit)
            for name, w in getattr(ledger, level).items()
        ]
    return listed
