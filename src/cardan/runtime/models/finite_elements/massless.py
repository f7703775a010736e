"""Motions to which nothing has mass or inertia: they are found, and told by what moves."""

from __future__ import annotations

import numpy as np

from ....arrays import Array
from .elements import Elements, State
from .tables import Tables

FULL = 1200  # speeds up to which all motions are looked at
ROUNDING, NOTHING = 1e-14, 1e-12  # of the largest inertia: of a speed, of a motion
SHARE, MOST = 0.2, 3


def massless(mesh: Elements, at: State) -> str:
    """Names of massless motions; "" where everything that can move has inertia."""
    from scipy.linalg import null_space

    tangent = mesh.tangent(State(at.q, at.u, t=at.t, r=at.r, z=at.z, s=at.s))
    M, G = tangent["M"], tangent["G"]
    if not (np.isfinite(M.data).all() and np.isfinite(G.data).all()):
        return ""
    inertias = np.abs(M.diagonal())
    there = inertias > ROUNDING * inertias.max(initial=0.0)
    if len(inertias) > FULL:
        # of very many those that have nothing of their own
        return _said(mesh.tables, (~there).astype(np.float64))
    # in the units in which kernels/finite_elements/mesh_solve.c solves
    unit = 1 / np.sqrt(
        np.where(there, inertias, inertias[there].min(initial=np.inf) if any(there) else 1.0)
    )
    allowed = null_space(G.toarray() * unit) if G.shape[0] else np.eye(len(inertias))
    if not allowed.size:
        return ""
    values, vectors = np.linalg.eigh(allowed.T @ (M.toarray() * unit * unit[:, None]) @ allowed)
    free = allowed @ vectors[:, values <= NOTHING * max(values[-1], 1.0)]
    return _said(mesh.tables, np.abs(free).max(axis=1)) if free.size else ""


def refusal(mesh: Elements, at: State) -> str:
    """Why there are no accelerations, and what to do."""
    moving = massless(mesh, at)
    if not moving:
        return "no accelerations: the masses and constraints have no solution at this state"
    return (
        f"M is singular: {moving} can move in a way that meets neither mass nor inertia. Give that "
        "body a mass and an inertia, a beam rhoA and rhoI (or a rho), or fix or prescribe a joint"
    )


def contradiction(mesh: Elements, at: State) -> str:
    """Why redundant constraints have no common accelerations, and what to do."""
    _, gaps, rates = mesh.balance(at)
    position, velocity = (float(np.abs(x).max(initial=0.0)) for x in (gaps, rates))
    return (
        "no accelerations: redundant constraints contradict each other at this state, where loops "
        f"are open by {position:.1e} (positions) and {velocity:.1e} (speeds). model.redundancy() "
        "names them: give joints that repeat others exact positions and equal motions, leave one "
        "of them out, or close the loops by model.assemble(...)"
    )


def _said(tables: Tables, moved: Array) -> str:
    """Bodies and beams at the places that move, in words."""
    largest = moved.max(initial=0.0)
    names = dict[str, None]()
    place_of = np.repeat(np.arange(len(tables.kind)), np.diff(tables.u))
    moving = set(place_of[moved >= SHARE * largest].tolist()) if largest > 0 else set[int]()
    # what is at one place is a body; then beams, then joints
    for group in sorted(tables.groups, key=lambda g: g.place.shape[1]):
        for name, places in zip(group.members, group.place.tolist(), strict=False):
            if moving & set(places):
                names[name] = None
                moving -= set(places)
    quoted = [f"'{name}'" for name in names]
    return ", ".join(quoted[:MOST]) + (", ..." if len(quoted) > MOST else "")
