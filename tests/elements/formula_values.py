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
    "matrix": lambda *entries: np.reshape(entries, (3, 3)),
    "rotation": lambda n, angle: rotation(n, angle),
    "unit": lambda *entries: unit(*entries),
    "max": max,
    "min": min,
    "abs": abs,
    "atan2": np.arctan2,
    "tan": np.tan,
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


def computed(lines: tuple[tuple[str, str], ...], given: Values, entries: str = "") -> Values:
    """The left sides, one after the other; of vectors and matrices ``entries`` by number too."""
    values = {**FUNCTIONS, **given}
    for _, formula in lines:
        left, _, right = formula.partition(" = ")
        values[left] = eval(right, {"__builtins__": {}}, values)
        if left in entries.split():
            values |= _numbered(left, values[left])
        if left == "s" and len(values["s"]) == 6:
            values |= {"s_m": values["s"][:3], "s_n": values["s"][3:]}
    return values


def _numbered(left: str, value: Any) -> Values:
    value = np.asarray(value)
    if value.shape[1] == 1:
        return {f"{left}_{i + 1}": x for i, x in enumerate(value.ravel())}
    return {f"{left}_{i + 1}{j + 1}": x for (i, j), x in np.ndenumerate(value)}


def rotation(n: Any, angle: float) -> Any:
    return Rotation.from_rotvec(np.ravel(n) * angle).as_matrix()


def unit(*entries: float) -> Any:
    return column(entries) / np.linalg.norm(entries)


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
