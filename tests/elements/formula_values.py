"""Values of the formulas that readers see, by NumPy alone."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from cardan.elements.flexible import FlexibleElement

Values = dict[str, Any]
STIFFNESS = ("GJ", "EI2", "EI3", "EA", "GA2", "GA3")


def skew(v: Any) -> Any:
    x, y, z = np.asarray(v).ravel()
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _dot(a: Any, b: Any) -> Any:
    return np.ravel(a) @ np.ravel(b)


FUNCTIONS: Values = {
    "skew": skew,
    "dot": _dot,
    "column": lambda *parts: np.vstack(parts),
    "row": lambda *parts: np.hstack(parts),
    "block": lambda a, b, c, d: np.block([[a, b], [c, d]]),
    "matrix": lambda *entries: np.reshape(entries, (3, 3)),
    "rotation": lambda n, angle: rotation(n, angle),
    "unit": lambda *entries: unit(*entries),
    "trace": np.trace,
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


def unit(*entries: Any) -> Any:
    """Unit vector along a vector, or along three entries."""
    vector = np.ravel(entries)
    return column(vector) / np.linalg.norm(vector)


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


def data_of(element: FlexibleElement, inputs: Values) -> Values:
    """Names that formulas of a flexible element use without defining them."""
    data = dict(zip(element.data(), inputs["p"], strict=True))
    given = poses(inputs["q"]) | motions(inputs["u"], inputs["udot"])
    given |= {"u": column(inputs["u"]), "L": data.get("length"), "eta": data.get("damping")}
    given |= {f"{name[:2]}_{name[2:]}" if name[2:] else name: data.get(name) for name in STIFFNESS}
    if "K1" in data:
        given["K"] = column([data[name] for name in ("K1", "K2", "K3", "E1", "E2", "E3")])
        given["epsilon"] = column([data[f"strain_{k}"] for k in range(1, 7)])
    if "gravity_1" in data:
        given |= {"mu": data["rhoA"], "g": column([data[f"gravity_{k}"] for k in (1, 2, 3)])}
    if "center_px" in data:
        given |= {"mu_c": data["mu"], "mu": data["rhoA"]}
        given["p_c"] = column([data[f"center_p{x}"] for x in "xyz"])
    loads = {"dead_force": "f_0", "follower_force": "n"}
    if element.kind.endswith("_load"):
        loads = {element.kind.replace("load", x): x[0] for x in ("force", "moment")}
    for name, letter in loads.items():
        if f"{name}_1" in data:
            given[letter] = column([data[f"{name}_{k}"] for k in (1, 2, 3)])
    if "rhoI2" in data:
        second, third = data["rhoI2"], data["rhoI3"]
        given["J"] = np.diag([second + third, second, third])
    return given
