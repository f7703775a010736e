"""The motion that forces of a model make, and what balances in it."""

from __future__ import annotations

import numpy as np

from .bodies import canonical, kinetic, weight
from .closed_states import RANK
from .differences import missing, relative, ways, worst_of
from .evaluation import ELSEWHERE, Trial
from .joint_motion import Array, times
from .loops import accelerations, singular
from .reference_values import push
from .user_constraints import written, yields


def rates(trial: Trial, udot: Array) -> dict[str, Array]:
    """Rates of all blocks in a motion; inputs stay where they are."""
    n = len(trial.reference.q)
    derivatives = {"t": np.ones((n, 1)), "q": trial.call("qdot"), "u": udot}
    if trial.model.nz:
        derivatives["z"] = trial.model.parts_of(trial.call("rhs"))[2]
    return derivatives


def moves_alone(trial: Trial) -> str:
    """Why the motion cannot be followed; "" where it can."""
    reference = trial.reference
    if trial.adrift:
        return trial.adrift
    if reference.f is None or reference.M is None:
        return "its own motion is not known"
    if singular(reference):
        return "the mass matrix is singular"
    if why := yields(trial.model):
        return why
    if "scene_motion" in trial.model.saved and trial.model.nr:
        return "inputs move joints"
    if not trial.knows("qdot", *(["rhs"] if trial.model.nz else [])):
        return "qdot is not compiled"
    return ""


def energy(trial: Trial, of: str | None) -> float | str:
    """Kinetic and potential energy; what the model gains is what its powers give."""
    value, expected, falls = trial.call("energy"), kinetic(trial), weight(trial)
    error = relative((value[:, 0] - expected)[:, None], expected[:, None])
    error = max(error, relative(value[:, 2] - value[:, :2].sum(axis=-1), value))
    if trial.model.manifest.scene.forces == []:
        height = np.abs(falls)[:, None]
        return max(error, relative((value[:, 1] - falls)[:, None], height, expected[:, None]))
    gained = ledger(trial, of)
    # of forces the potential is known by what it does
    return gained if isinstance(gained, str) or np.isnan(gained) else max(error, gained)


def ledger(trial: Trial, of: str | None) -> float | str:
    """Rate of the energy in a motion against the sum of all powers."""
    why = moves_alone(trial) or ("" if trial.knows("energy", "power") else ELSEWHERE)
    if why:
        return why
    udot = accelerations(trial, np.asarray(trial.reference.f))
    total, off = trial.slope("energy", None, rates(trial, udot))
    powers, drifting = trial.call("power"), _drifting(trial, udot)
    if drifting is None:
        return ELSEWHERE
    terms = [np.asarray(x) * trial.reference.u for x in (trial.reference.h, trial.reference.f)]
    expected = powers.sum(axis=-1) + drifting
    return missing(total[:, 2:], off, expected, total, powers, drifting[:, None], *terms)


def _drifting(trial: Trial, udot: Array) -> Array | None:
    """Power (n,) of constraints of the user's own at states that do not fulfil them; None: unknown.

    What the model counts is their power where their rates vanish.
    """
    rows, reference = written(trial.model), trial.reference
    if not rows or reference.bound is None:
        return np.zeros(len(udot))
    if not trial.knows("constraint_rates"):
        return None
    G, M = reference.bound.G, np.asarray(reference.M)
    force = np.zeros((len(udot), G.shape[-1]))
    force[:, : udot.shape[-1]] = times(M, udot) + reference.h - np.asarray(reference.f)
    lam = times(np.linalg.pinv(np.swapaxes(G, -1, -2), rcond=RANK), force)[:, -len(rows) :]
    lost: Array = (lam * trial.call("constraint_rates")[:, rows]).sum(axis=-1)
    return lost


def momentum_rates(trial: Trial, of: str | None) -> float | str:
    """Rates of the momenta in a motion under tau."""
    why = moves_alone(trial) or ("" if trial.knows("momenta") else ELSEWHERE)
    if why:
        return why
    reference = trial.reference
    udot = accelerations(trial, reference.under(reference.tau) + reference.tau)
    slope, off = trial.slope("momenta", None, rates(trial, udot))
    return missing(slope, off, trial.call("momentum_rates"), reference.h, reference.f)


def hamiltonian(trial: Trial, of: str | None) -> float | str:
    """p . u - T + V."""
    if not trial.knows("energy"):
        return ELSEWHERE
    energies, T = trial.call("energy"), kinetic(trial)
    along = (canonical(trial) * trial.reference.u).sum(axis=-1)
    expected = (along - T + energies[:, 1])[:, None]
    return relative(trial.call("hamiltonian")[:, None] - expected, expected, T[:, None], energies)


def balance(trial: Trial, of: str | None) -> float | str:
    """M udot + h - f - Gᵀ lam."""
    reference, model = trial.reference, trial.model
    nu, udot = model.nu, reference.udot
    inertia = (
        push(trial.scene, reference, udot) if reference.M is None else times(reference.M, udot)
    )
    # with friction from reactions it is that of the model's own motion
    f = np.zeros_like(reference.h) if reference.f is None else reference.f
    lam = np.random.default_rng(2).uniform(-1, 1, (len(udot), len(model.manifest.multipliers)))
    expected = inertia + reference.h - f
    value = trial.call("balance", None, {"lam": lam})
    if lam.shape[-1]:
        if not trial.knows("constraint_jacobian", "constraints", "constraint_rates"):
            return ELSEWHERE
        expected = expected - times(np.swapaxes(trial.call("constraint_jacobian"), -1, -2), lam)
        residuals = [trial.call(name) for name in ("constraints", "constraint_rates")]
        gap = value[:, nu:] - np.concatenate(residuals, axis=-1)
        fastest = max(1.0, float(np.abs(reference.u).max(initial=0.0)))
        if not np.abs(gap).max(initial=0.0) <= 1e-9 * fastest:
            return 1.0
    return relative(value[:, :nu] - expected, inertia, reference.h, f, value[:, :nu])


def balance_tangent(trial: Trial, of: str | None) -> float | str:
    """K, C and M of the balance, R and G of its rates."""
    model = trial.model
    if not trial.knows("balance", "qdot"):
        return ELSEWHERE
    n, nu, m = len(trial.reference.q), model.nu, len(model.manifest.multipliers)
    lam = np.random.default_rng(2).uniform(-1, 1, (n, m))
    inputs = {"lam": lam}
    flat, worst = trial.call("balance_tangent", None, inputs), np.nan
    ends = np.cumsum([nu * nu] * 3 + [m * nu])
    parts = np.split(flat, ends if m else ends[:2], axis=-1)
    matrices = [part.reshape(n, -1, nu) for part in parts if part.size]
    for way in ways(n, nu):
        for letter, at in (("q", trial.along_speeds(way)), ("u", way), ("udot", way)):
            slope, off = trial.slope("balance", None, {letter: at}, inputs)
            which = ("q", "u", "udot").index(letter)
            scale = np.abs(matrices[which]).max(axis=(1, 2), initial=0.0)
            column = times(matrices[which], way)
            worst = worst_of(worst, missing(slope[:, :nu], off, column, scale))
            if m and letter != "udot":
                column = times(matrices[3 if letter == "q" else 4], way)
                sizes = np.abs(column).max(axis=-1), np.abs(trial.reference.u).max(axis=-1)
                worst = worst_of(worst, missing(slope[:, -m:], off, column, *sizes))
    return worst


def internal_rates(trial: Trial, of: str | None) -> float | str:
    """Rates of internal states are those of the state."""
    if not trial.knows("rhs"):
        return ELSEWHERE
    z = trial.model.parts_of(trial.call("rhs"))[2]
    return relative(trial.call("internal_rates") - z, z)


JUDGES = {
    "internal_rates": internal_rates,
    "energy": energy,
    "power": ledger,
    "momentum_rates": momentum_rates,
    "hamiltonian": hamiltonian,
    "balance": balance,
    "balance_tangent": balance_tangent,
}
