"""Values of the formulas that readers see, by NumPy alone."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

Values = dict[str, Any]


def skew(v: Any) -> Any:
    x, y, z = np.asarray(v).ravel()
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _dot(a: Any, b: Any) -> float:
    return float(np.ravel(a) @ np.ravel(b))


FUNCTIONS: Values = {
    "skew": skew,
    "dot": _dot,
    "column": lambda *parts: np.vstack(parts),
    "row": lambda *parts: np.hstack(parts),
    "block": lambda a, b, c, d: np.block([[a, b], [c, d]]),
    "diagonal": lambda *entries: np.diag(entries),
    "inverse": np.linalg.inv,
    "rotation_vector": lambda r: Rotation.from_matrix(r).as_rotvec()[:, None],
    "cot": lambda x: 1 / np.tan(x),
    "sin": np.sin,
    "cos": np.cos,
    "sqrt": np.sqrt,
    "I": np.eye(3),
    "O": np.zeros((3, 3)),
    "i": np.array([[1.0], [0.0], [0.0]]),
}


def computed(lines: tuple[tuple[str, str], ...], given: Values) -> Values:
    """The left sides, one after the other."""
    values = {**FUNCTIONS, **given}
    for _, formula in lines:
        left, _, right = formula.partition(" = ")
        values[left] = eval(right, {"__builtins__": {}}, values)
        if left == "s":
            values |= {"m": values["s"][:3], "n": values["s"][3:]}
    return values


def poses(q: Any) -> Values:
    """R_k, p_k of unit quaternions, scalar first, and positions."""
    values: Values = {}
    for k, (w, x, y, z, *p) in enumerate(np.reshape(q, (-1, 7)), 1):
        values |= {f"R_{k}": Rotation.from_quat([x, y, z, w]).as_matrix(), f"p_{k}": column(p)}
    return values


def motions(u: Any, udot: Any) -> Values:
    """omega_k, v_k and their rates."""
    values: Values = {}
    for rate, entries in (("", u), ("dot", udot)):
        for k, row in enumerate(np.reshape(entries, (-1, 6)), 1):
            values |= {f"omega{rate}_{k}": column(row[:3]), f"v{rate}_{k}": column(row[3:])}
    return values


def column(entries: Any) -> Any:
    return np.array(entries, dtype=float)[:, None]
