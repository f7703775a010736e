"""Motion of the coordinates by finite increments along the speeds."""

from __future__ import annotations

import numpy as np

from .differences import missing, relative, ways, worst_of
from .evaluation import ELSEWHERE, Trial
from .joint_motion import Array, times

# of a finite increment, in radians or sizes of the scene
STEP = 0.4


def _increment(trial: Trial) -> Array:
    rng = np.random.default_rng(3)
    return STEP * rng.uniform(-1, 1, (len(trial.reference.q), trial.model.nu))


def integrate(trial: Trial, of: str | None, name: str = "integrate") -> float | str:
    """Small increments lead where speeds lead, halves of one lead to where it leads."""
    if not trial.knows("qdot"):
        return ELSEWHERE
    nq, du = trial.model.nq, _increment(trial)
    n, none = len(du), np.zeros_like(du)
    slope, off = trial.slope(name, None, {"du": du}, {"du": none})
    expected = trial.along_speeds(du)
    worst = missing(slope[:, :nq], off, expected, np.ones((n, 1)))
    full_step, half = (trial.call(name, None, {"du": part * du})[:, :nq] for part in (1.0, 0.5))
    # while it goes on, the rate is that of the increment all the way
    for part in (0.5, 1.0):
        slope, off = trial.slope(name, None, {"du": du}, {"du": part * du})
        there = full_step if part == 1.0 else half
        error = missing(slope[:, :nq], off, trial.along_speeds(du, there), np.ones((n, 1)))
        worst = worst_of(worst, error)
    return worst


def move(trial: Trial, of: str | None) -> float | str:
    """Same as :func:`integrate`; and T, by which a change of the increment moves the result."""
    worst = integrate(trial, of, "move")
    if isinstance(worst, str):
        return worst
    nq, nu, du = trial.model.nq, trial.model.nu, _increment(trial)
    value = trial.call("move", None, {"du": du})
    there, T = value[:, :nq], value[:, nq:].reshape(len(du), nu, nu)
    for way in ways(len(du), nu):
        slope, off = trial.slope("move", None, {"du": way}, {"du": du})
        expected = trial.along_speeds(times(T, way), there)
        worst = worst_of(worst, missing(slope[:, :nq], off, expected, np.ones((len(du), 1))))
    return worst


def difference(trial: Trial, of: str | None) -> float | str:
    """The increment that leads from one position to another."""
    if not trial.knows("integrate"):
        return ELSEWHERE
    du = _increment(trial)
    there = trial.call("integrate", None, {"du": du})
    increment = trial.call("difference", None, {"q0": trial.reference.q, "q": there})
    return relative(increment - du, np.ones_like(du))


def _away(trial: Trial) -> Array:
    """Positions near those where the loops are closed."""
    rng = np.random.default_rng(4)
    return 1e-2 * rng.uniform(-1, 1, (len(trial.reference.q), trial.model.nu))


def _shortest(trial: Trial, inputs: dict[str, Array], rows: slice, missed: Array) -> Array:
    """The step that closes G step = -missed at the least M."""
    G = trial.call("constraint_jacobian", None, inputs)
    G = np.broadcast_to(G, (len(missed), *G.shape[-2:]))[:, rows]
    M = trial.call("mass_matrix", None, inputs)
    back = np.linalg.solve(np.broadcast_to(M, (len(missed), *M.shape[-2:])), np.swapaxes(G, -1, -2))
    pushes = np.linalg.pinv(G @ back, rcond=1e-10, hermitian=True)
    return -times(back @ pushes, missed)


def close_position(trial: Trial, of: str | None) -> float | str:
    """One step onto the constraints, the shortest in terms of M."""
    if not trial.knows("integrate", "mass_matrix", "constraint_jacobian", "constraints"):
        return ELSEWHERE
    nq = trial.model.nq
    q = trial.call("integrate", None, {"du": _away(trial)})
    value, missed = (trial.call(f, None, {"q": q}) for f in ("close_position", "constraints"))
    first = relative(value[:, nq:] - missed, missed)
    if not _regular(trial, q):
        return first
    step = _shortest(trial, {"q": q}, slice(missed.shape[-1]), missed)
    expected = trial.call("integrate", None, {"q": q, "du": step})
    return max(first, _iteration_error(value[:, :nq] - expected, expected, np.abs(step)))


def close_velocity(trial: Trial, of: str | None) -> float | str:
    """Speeds on the constraints, by the least M."""
    if not trial.knows("mass_matrix", "constraint_jacobian", "constraint_rates"):
        return ELSEWHERE
    nu, u = trial.model.nu, trial.reference.u + _away(trial)
    inputs = {"u": u}
    value, missed = (trial.call(f, None, inputs) for f in ("close_velocity", "constraint_rates"))
    first = relative(value[:, nu:] - missed, missed, np.abs(u))
    if not _regular(trial, trial.reference.q):
        return first
    expected = u + _shortest(trial, inputs, slice(None), missed)
    # where loops allow no motion nothing is left of the speeds but their rounding
    return max(first, _iteration_error(value[:, :nu] - expected, expected, u))


def _regular(trial: Trial, q: Array) -> bool:
    """True when no rows depend on others, and masses are regular: one step is the shortest then."""
    G, M = (trial.call(name, None, {"q": q}) for name in ("constraint_jacobian", "mass_matrix"))
    rows = G.shape[-2]
    ranks = np.linalg.matrix_rank(G, tol=1e-6 * float(np.abs(G).max(initial=1e-300)))
    return bool((np.asarray(ranks) == rows).all()) and bool((np.linalg.cond(M) < 1e8).all())


def _iteration_error(difference: Array, *terms: Array) -> float:
    """Relative to terms of a solve in which some digits are lost."""
    return relative(difference, *terms) / LOST


def closure(trial: Trial, of: str | None) -> float | str:
    """Check the function against the constraints, near closed loops, row by row of the same
    name.
    """
    if not trial.knows("constraints", "integrate"):
        return ELSEWHERE
    model = trial.model
    du = 0.1 * np.random.default_rng(9).uniform(-1, 1, (len(trial.reference.q), model.nu))
    inputs = {"q": trial.call("integrate", None, {"du": du})}
    closure_rows, constraint_rows = (
        {name: k for k, name in enumerate(model._function(f, None).caller.entries)}
        for f in ("closure", "constraints")
    )
    both = [name for name in closure_rows if name in constraint_rows]
    if not both:
        return ELSEWHERE
    value, g = (trial.call(f, None, inputs) for f in ("closure", "constraints"))
    a, b = value[:, [closure_rows[n] for n in both]], g[:, [constraint_rows[n] for n in both]]
    if trial.adrift:
        # no state was found at which it would have to vanish
        return relative(a - b, b)
    closed = trial.call("closure")
    return max(relative(a - b, b), relative(closed, np.full_like(closed, trial.length)))


# digits that solving with matrices of a condition up to 1e8 may lose
LOST = 1e2

JUDGES = {
    "closure": closure,
    "integrate": integrate,
    "move": move,
    "difference": difference,
    "close_position": close_position,
    "close_velocity": close_velocity,
}
