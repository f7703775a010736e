"""Components with known matrices: beams, a brick, and what is computed of them without cardan."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import mmread
from scipy.linalg import eigh

import cardan as cd

FILES = Path(__file__).parents[1] / "references"
BAR = Path(__file__).with_name("files") / "bar.sti"  # written by CalculiX 2.20


@cache
def reference(name: str) -> dict[str, Any]:
    return json.loads((FILES / f"{name}.json").read_text("utf-8"))


@cache
def beam_16() -> dict[str, np.ndarray]:
    """Planar beam of 16 elements: u, w, theta of each node."""
    return dict(np.load(FILES / "se_beam_16.npz"))


def beam(**options: Any) -> Any:
    """The reduced beam, both ends interfaces."""
    data = beam_16()
    ends = {"root": 0, "tip": 16}
    return cd.superelement.reduce(
        data["M"], data["K"], data["nodes"], ends, node_dofs="x y rz", **options
    )


@cache
def brick_matrices() -> tuple[Any, Any, np.ndarray]:
    """M, K and nodes of a brick of 10 x 3 x 2 hexahedra."""
    M, K = (mmread(FILES / f"se_brick_A_{name}.mtx").tocsc() for name in "MK")
    return M, K, np.loadtxt(FILES / "se_brick_A_nodes.csv", delimiter=",")


def faces() -> dict[str, Any]:
    x = brick_matrices()[2][:, 0]
    return {"root": np.flatnonzero(x < 1e-9), "tip": np.flatnonzero(x > 1 - 1e-9)}


def brick(**options: Any) -> Any:
    """The reduced brick, two faces interfaces."""
    return cd.superelement.reduce(*brick_matrices(), faces(), **options)


def planar_beam(
    length: float, elements: int, EA: float, EI: float, rhoA: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M, K and nodes of a straight beam of Euler and Bernoulli with consistent mass."""
    h, size = length / elements, 3 * (elements + 1)
    M, K = np.zeros((size, size)), np.zeros((size, size))
    bend = [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h]]
    bend += [[-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
    heavy = [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h]]
    heavy += [[54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]
    for e in range(elements):
        axial = np.ix_([3 * e, 3 * e + 3], [3 * e, 3 * e + 3])
        places = [3 * e + 1, 3 * e + 2, 3 * e + 4, 3 * e + 5]
        lateral = np.ix_(places, places)
        K[axial] += EA / h * np.array([[1, -1], [-1, 1]])
        M[axial] += rhoA * h / 6 * np.array([[2, 1], [1, 2]])
        K[lateral] += EI / h**3 * np.array(bend)
        M[lateral] += rhoA * h / 420 * np.array(heavy)
    nodes = np.zeros((elements + 1, 3))
    nodes[:, 0] = np.linspace(0, length, elements + 1)
    return M, K, nodes


def bar(
    length: float, count: int, EA: float, rhoA: float, ends: Any = None, modes: int | None = None
) -> Any:
    """Elements with linear displacements; bending so stiff that axial modes come first."""
    M, K, nodes = planar_beam(length, count, EA, 1e6 * EA, rhoA)
    M[1::3] = M[:, 1::3] = M[2::3] = M[:, 2::3] = 0.0
    M[1::3, 1::3] = M[::3, ::3]
    M[2::3, 2::3] = 1e-3 * M[::3, ::3]
    ends = ends or {"left": 0, "right": count}
    modes = count - 1 if modes is None else modes
    return cd.superelement.reduce(M, K, nodes, ends, node_dofs="x y rz", modes=modes)


def spatial_beam(
    length: float, elements: int, EA: float, EI: float, rhoA: float, twisting: float = 1e-8
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M, K and nodes of a beam that bends in two planes, with some stiffness of torsion.

    Args:
        twisting: Inertia of torsion by mass [m^2].
    """
    m, k, nodes = planar_beam(length, elements, EA, EI, rhoA)
    bends, flaps, twists = (np.zeros((len(m), 2 * len(m))) for _ in range(3))
    for i in range(elements + 1):
        bends[[3 * i, 3 * i + 1, 3 * i + 2], [6 * i, 6 * i + 1, 6 * i + 5]] = 1.0
        flaps[[3 * i + 1, 3 * i + 2], [6 * i + 2, 6 * i + 4]] = 1.0, -1.0
        twists[3 * i, 6 * i + 3] = 1.0
    planes = (bends, 1.0, 1.0), (flaps, 1.0, 1.0), (twists, twisting, 1e-2)
    M = sum(heavy * P.T @ m @ P for P, heavy, _ in planes)
    return M, sum(stiff * P.T @ k @ P for P, _, stiff in planes), nodes


def frequencies(M: np.ndarray, K: np.ndarray, zeros: int = 0) -> np.ndarray:
    """All finite frequencies above the zero ones, by the inverse form."""
    shift = K.trace() / M.trace() * 1e-6
    nu = eigh(M, K + shift * M, eigvals_only=True)[::-1]
    return np.sqrt(np.maximum(1 / nu[nu > 0] - shift, 0))[zeros:]
