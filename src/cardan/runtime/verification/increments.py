"""How coordinates move by finite increments along the speeds."""

from __future__ import annotations

import numpy as np

from .differences import missing, relative, ways, worst_of
from .evaluation import ELSEWHERE, Asked
from .joint_motion import Array, times

# of a finite increment, in radians or sizes of the scene
STEP = 0.4


def _increment(asked: Asked) -> Array:
    rng = np.random.default_rng(3)
    return STEP * rng.uniform(-1, 1, (len(asked.truth.q), asked.model.nu))


def integrate(asked: Asked, of: str | None, name: str = "integrate") -> float | str:
    """Small increments lead where speeds lead, halves of one lead to where it leads."""
    if not asked.knows("qdot"):
        return ELSEWHERE
    nq, du = asked.model.nq, _increment(asked)
    n, none = len(du), np.zeros_like(du)
    found, off = asked.slope(name, None, {"du": du}, {"du": none})
    known = asked.along_speeds(du)
    worst = missing(found[:, :nq], off, known, np.ones((n, 1)))
    whole, half = (asked.call(name, None, {"du": part * du})[:, :nq] for part in (1.0, 0.5))
    # while it goes on, the rate is that of the increment all the way
    for part in (0.5, 1.0):
        found, off = asked.slope(name, None, {"du": du}, {"du": part * du})
        there = whole if part == 1.0 else half
        error = missing(found[:, :nq], off, asked.along_speeds(du, there), np.ones((n, 1)))
        worst = worst_of(worst, error)
    return worst


def move(asked: Asked, of: str | None) -> float | str:
    """As :func:`integrate`; and T, by which a change of the increment moves the result."""
    worst = integrate(asked, of, "move")
    if isinstance(worst, str):
        return worst
    nq, nu, du = asked.model.nq, asked.model.nu, _increment(asked)
    value = asked.call("move", None, {"du": du})
    there, T = value[:, :nq], value[:, nq:].reshape(len(du), nu, nu)
    for way in ways(len(du), nu):
        found, off = asked.slope("move", None, {"du": way}, {"du": du})
        known = asked.along_speeds(times(T, way), there)
        worst = worst_of(worst, missing(found[:, :nq], off, known, np.ones((len(du), 1))))
    return worst


def difference(asked: Asked, of: str | None) -> float | str:
    """The increment that leads from one position to another."""
    if not asked.knows("integrate"):
        return ELSEWHERE
    du = _increment(asked)
    there = asked.call("integrate", None, {"du": du})
    found = asked.call("difference", None, {"q0": asked.truth.q, "q": there})
    return relative(found - du, np.ones_like(du))


def _away(asked: Asked) -> Array:
    """Positions near those where the circuits are closed."""
    rng = np.random.default_rng(4)
    return 1e-2 * rng.uniform(-1, 1, (len(asked.truth.q), asked.model.nu))


def _shortest(asked: Asked, given: dict[str, Array], rows: slice, missed: Array) -> Array:
    """The step that closes G step = -missed at the least M."""
    G = asked.call("constraint_jacobian", None, given)
    G = np.broadcast_to(G, (len(missed), *G.shape[-2:]))[:, rows]
    M = asked.call("mass_matrix", None, given)
    back = np.linalg.solve(np.broadcast_to(M, (len(missed), *M.shape[-2:])), np.swapaxes(G, -1, -2))
    pushes = np.linalg.pinv(G @ back, rcond=1e-10, hermitian=True)
    return -times(back @ pushes, missed)


def close_position(asked: Asked, of: str | None) -> float | str:
    """One step onto the constraints, the shortest in terms of M."""
    if not asked.knows("integrate", "mass_matrix", "constraint_jacobian", "constraints"):
        return ELSEWHERE
    nq = asked.model.nq
    q = asked.call("integrate", None, {"du": _away(asked)})
    value, missed = (asked.call(f, None, {"q": q}) for f in ("close_position", "constraints"))
    first = relative(value[:, nq:] - missed, missed)
    if not _regular(asked, q):
        return first
    step = _shortest(asked, {"q": q}, slice(missed.shape[-1]), missed)
    known = asked.call("integrate", None, {"q": q, "du": step})
    return max(first, _loose(value[:, :nq] - known, known, np.abs(step)))


def close_velocity(asked: Asked, of: str | None) -> float | str:
    """Speeds on the constraints, by the least M."""
    if not asked.knows("mass_matrix", "constraint_jacobian", "constraint_rates"):
        return ELSEWHERE
    nu, u = asked.model.nu, asked.truth.u + _away(asked)
    given = {"u": u}
    value, missed = (asked.call(f, None, given) for f in ("close_velocity", "constraint_rates"))
    first = relative(value[:, nu:] - missed, missed, np.abs(u))
    if not _regular(asked, asked.truth.q):
        return first
    known = u + _shortest(asked, given, slice(None), missed)
    # where circuits allow no motion nothing is left of the speeds but their rounding
    return max(first, _loose(value[:, :nu] - known, known, u))


def _regular(asked: Asked, q: Array) -> bool:
    """Whether no rows depend on others, and masses are regular: one step is the shortest then."""
    G, M = (asked.call(name, None, {"q": q}) for name in ("constraint_jacobian", "mass_matrix"))
    rows = G.shape[-2]
    found = np.linalg.matrix_rank(G, tol=1e-6 * float(np.abs(G).max(initial=1e-300)))
    return bool((np.asarray(found) == rows).all()) and bool((np.linalg.cond(M) < 1e8).all())


def _loose(difference: Array, *terms: Array) -> float:
    """Relative to terms of a solve in which some digits are lost."""
    return relative(difference, *terms) / LOST


def closure(asked: Asked, of: str | None) -> float | str:
    """As the constraints say, near where circuits close, row by row of the same name."""
    if not asked.knows("constraints", "integrate"):
        return ELSEWHERE
    model = asked.model
    du = 0.1 * np.random.default_rng(9).uniform(-1, 1, (len(asked.truth.q), model.nu))
    given = {"q": asked.call("integrate", None, {"du": du})}
    own, known = (
        {name: k for k, name in enumerate(model._function(f, None).caller.entries)}
        for f in ("closure", "constraints")
    )
    both = [name for name in own if name in known]
    if not both:
        return ELSEWHERE
    value, g = (asked.call(f, None, given) for f in ("closure", "constraints"))
    a, b = value[:, [own[n] for n in both]], g[:, [known[n] for n in both]]
    if asked.adrift:
        # no state was found at which it would have to vanish
        return relative(a - b, b)
    closed = asked.call("closure")
    return max(relative(a - b, b), relative(closed, np.full_like(closed, asked.length)))


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
