"""The motion that forces of a model make, and what balances in it."""

from __future__ import annotations

import numpy as np

from .bodies import canonical, kinetic, weight
from .closed_states import RANK
from .differences import missing, relative, ways, worst_of
from .evaluation import ELSEWHERE, Asked
from .joint_motion import Array, times
from .loops import accelerations, singular
from .reference_values import push
from .user_constraints import written


def rates(asked: Asked, udot: Array) -> dict[str, Array]:
    """Rates of all blocks in a motion; inputs stay where they are."""
    n = len(asked.truth.q)
    found = {"t": np.ones((n, 1)), "q": asked.call("qdot"), "u": udot}
    if asked.model.nz:
        found["z"] = asked.model.parts_of(asked.call("rhs"))[2]
    return found


def moves_alone(asked: Asked) -> str:
    """Why the motion cannot be followed; "" where it can."""
    truth, manifest = asked.truth, asked.model.manifest
    treatment = manifest.scene.treatment
    if asked.adrift:
        return asked.adrift
    if truth.f is None or truth.M is None:
        return "its own motion is not known"
    if singular(truth):
        return "the mass matrix is singular"
    if treatment and not treatment.exact:
        return f"constraints treated by '{treatment.name}' give way"
    if "scene_motion" in asked.model.saved and asked.model.nr:
        return "inputs move joints"
    if not asked.knows("qdot", *(["rhs"] if asked.model.nz else [])):
        return "qdot is not compiled"
    return ""


def energy(asked: Asked, of: str | None) -> float | str:
    """Kinetic and potential energy; what the model gains is what its powers give."""
    value, known, falls = asked.call("energy"), kinetic(asked), weight(asked)
    error = relative((value[:, 0] - known)[:, None], known[:, None])
    error = max(error, relative(value[:, 2] - value[:, :2].sum(axis=-1), value))
    if asked.model.manifest.scene.forces == []:
        height = np.abs(falls)[:, None]
        return max(error, relative((value[:, 1] - falls)[:, None], height, known[:, None]))
    gained = ledger(asked, of)
    # of forces the potential is known by what it does
    return gained if isinstance(gained, str) or np.isnan(gained) else max(error, gained)


def ledger(asked: Asked, of: str | None) -> float | str:
    """Rate of the energy in a motion against the sum of all powers."""
    why = moves_alone(asked) or ("" if asked.knows("energy", "power") else ELSEWHERE)
    if why:
        return why
    udot = accelerations(asked, np.asarray(asked.truth.f))
    total, off = asked.slope("energy", None, rates(asked, udot))
    given, drifting = asked.call("power"), _drifting(asked, udot)
    if drifting is None:
        return ELSEWHERE
    terms = [np.asarray(x) * asked.truth.u for x in (asked.truth.h, asked.truth.f)]
    known = given.sum(axis=-1) + drifting
    return missing(total[:, 2:], off, known, total, given, drifting[:, None], *terms)


def _drifting(asked: Asked, udot: Array) -> Array | None:
    """Power (n,) of constraints of the user's own at states that do not fulfil them; None: unknown.

    What the model counts is their power where their rates vanish.
    """
    rows, truth = written(asked.model), asked.truth
    if not rows or truth.bound is None:
        return np.zeros(len(udot))
    if not asked.knows("constraint_rates"):
        return None
    G, M = truth.bound.G, np.asarray(truth.M)
    force = np.zeros((len(udot), G.shape[-1]))
    force[:, : udot.shape[-1]] = times(M, udot) + truth.h - np.asarray(truth.f)
    lam = times(np.linalg.pinv(np.swapaxes(G, -1, -2), rcond=RANK), force)[:, -len(rows) :]
    found: Array = (lam * asked.call("constraint_rates")[:, rows]).sum(axis=-1)
    return found


def momentum_rates(asked: Asked, of: str | None) -> float | str:
    """Rates of the momenta in a motion under tau."""
    why = moves_alone(asked) or ("" if asked.knows("momenta") else ELSEWHERE)
    if why:
        return why
    truth = asked.truth
    udot = accelerations(asked, truth.under(truth.tau) + truth.tau)
    found, off = asked.slope("momenta", None, rates(asked, udot))
    return missing(found, off, asked.call("momentum_rates"), truth.h, truth.f)


def hamiltonian(asked: Asked, of: str | None) -> float | str:
    """p . u - T + V."""
    if not asked.knows("energy"):
        return ELSEWHERE
    energies, T = asked.call("energy"), kinetic(asked)
    along = (canonical(asked) * asked.truth.u).sum(axis=-1)
    known = (along - T + energies[:, 1])[:, None]
    return relative(asked.call("hamiltonian")[:, None] - known, known, T[:, None], energies)


def balance(asked: Asked, of: str | None) -> float | str:
    """M udot + h - f - Gᵀ lam."""
    truth, model = asked.truth, asked.model
    nu, udot = model.nu, truth.udot
    inertia = push(asked.scene, truth, udot) if truth.M is None else times(truth.M, udot)
    # with friction from reactions it is that of the model's own motion
    f = np.zeros_like(truth.h) if truth.f is None else truth.f
    lam = np.random.default_rng(2).uniform(-1, 1, (len(udot), len(model.manifest.multipliers)))
    known = inertia + truth.h - f
    value = asked.call("balance", None, {"lam": lam})
    if lam.shape[-1]:
        if not asked.knows("constraint_jacobian", "constraints", "constraint_rates"):
            return ELSEWHERE
        known = known - times(np.swapaxes(asked.call("constraint_jacobian"), -1, -2), lam)
        rest = [asked.call(name) for name in ("constraints", "constraint_rates")]
        found = value[:, nu:] - np.concatenate(rest, axis=-1)
        fastest = max(1.0, float(np.abs(truth.u).max(initial=0.0)))
        if not np.abs(found).max(initial=0.0) <= 1e-9 * fastest:
            return 1.0
    return relative(value[:, :nu] - known, inertia, truth.h, f, value[:, :nu])


def balance_tangent(asked: Asked, of: str | None) -> float | str:
    """K, C and M of the balance, R and G of its rates."""
    model = asked.model
    if not asked.knows("balance", "qdot"):
        return ELSEWHERE
    n, nu, m = len(asked.truth.q), model.nu, len(model.manifest.multipliers)
    lam = np.random.default_rng(2).uniform(-1, 1, (n, m))
    given = {"lam": lam}
    flat, worst = asked.call("balance_tangent", None, given), np.nan
    ends = np.cumsum([nu * nu] * 3 + [m * nu])
    parts = np.split(flat, ends if m else ends[:2], axis=-1)
    matrices = [part.reshape(n, -1, nu) for part in parts if part.size]
    for way in ways(n, nu):
        for letter, at in (("q", asked.along_speeds(way)), ("u", way), ("udot", way)):
            found, off = asked.slope("balance", None, {letter: at}, given)
            which = ("q", "u", "udot").index(letter)
            scale = np.abs(matrices[which]).max(axis=(1, 2), initial=0.0)
            column = times(matrices[which], way)
            worst = worst_of(worst, missing(found[:, :nu], off, column, scale))
            if m and letter != "udot":
                column = times(matrices[3 if letter == "q" else 4], way)
                sizes = np.abs(column).max(axis=-1), np.abs(asked.truth.u).max(axis=-1)
                worst = worst_of(worst, missing(found[:, -m:], off, column, *sizes))
    return worst


JUDGES = {
    "energy": energy,
    "power": ledger,
    "momentum_rates": momentum_rates,
    "hamiltonian": hamiltonian,
    "balance": balance,
    "balance_tangent": balance_tangent,
}
