"""Formulas that readers see of forces are what the forces are."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import Akima1DInterpolator, PchipInterpolator
from scipy.spatial.transform import Rotation

from cardan.elements.forces.force import ForceElement, Places
from cardan.elements.forces.relative_springs import DIRECTIONS
from cardan.elements.formulas import Lines
from elements.force_bench import FRAMES, INSTANCES, JOINTS, RATES, STATE, Bench
from elements.formula_values import column, computed, skew
from spatial.numbers_of import block

# letters of quantities; of drives the damping is that of the shaft
LETTERS = {
    **{"force": "f", "torque": "m", "stiffness": "k", "damping": "c", "rest_length": "ell_0"},
    **{"rest": "q_0", "ratio": "n", "inertia": "J", "friction": "c", "momentum": "H", "mu": "mu"},
    **{"axis": "a", "radius": "r", "other_radius": "r_o", "exponent": "N", "normal": "n_0"},
    **{"transition_velocity": "epsilon", "mass": "m", "com": "c"},
}
# of springs in six directions; the hinge names its stiffnesses by kind
SPRINGS = {
    "bushing": {"rest": "y_0"},
    "flexible_hinge": {"axis": "axis", "turn": "t", "tilt": "s_0", "axial": "a_0", "radial": "r_0"}
    | {"damping": "eta"},
    "cable": {"EA": "EA", "length": "L", "damping": "eta"},
}
DRIVE = {"damping": "d"}
# they have states or modes of their own that decide, or act by elements of the beam
UNREAD = {
    *("line load", "dry friction", "smooth friction", "actuator", "controller", "stop", "lock"),
    *("sampled controller", "event", "rotor of constant speed"),
    *("flattened planet", "flattened planet, extended body"),
}
ROLES = {"sphere": "s", "other": "o", "in_": "in"}


@pytest.mark.parametrize("name", INSTANCES)
def test_forces(name: str) -> None:
    """Forces and moments on frames, forces along joints, energies; by NumPy alone."""
    bench = Bench(INSTANCES[name])
    at = _places(bench)
    lines = bench.element.formulas(at)
    assert bool(lines) != (name in UNREAD)
    if not lines:
        return
    given = _given(bench.element, bench, at)
    shown = computed(lines, given | _measured(bench.element, lines, given))
    loads, along, energy = _acted(bench, at)
    for role, frame in at.frames.items():
        if role == "in_":
            continue
        index = f"_{ROLES.get(role, role)}" if len(set(at.frames) - {"in_"}) > 1 else ""
        for letter, value in zip("MF", loads[frame], strict=True):
            found = np.ravel(shown.get(f"{letter}{index}", np.zeros(3)))
            assert np.allclose(found, value, rtol=1e-12, atol=1e-12), (letter, role)
    for role, joint in at.joints.items():
        index = "_rotor" if role == "rotor" and "joint" in at.joints else ""
        found = np.ravel(shown.get(f"tau{index}", 0.0))
        assert np.allclose(found, along[joint], rtol=1e-12, atol=1e-14)
    assert np.isclose(np.squeeze(shown.get("V", 0.0)), energy, rtol=1e-12, atol=0)
    rates = bench.element.rates(at)
    if rates.rows:
        wanted = [float(x) for x in np.ravel(bench.value(rates))]
        assert np.allclose(_flow_rates(bench.element, shown), wanted, rtol=1e-12)


def _measured(element: ForceElement, lines: Lines, given: dict[str, Any]) -> dict[str, Any]:
    """Stress t and energy W of the tables of a bushing, by SciPy."""
    if not getattr(element, "tables", ()):
        return {}
    last = [formula.startswith("y = ") for _, formula in lines].index(True)
    y = np.ravel(computed(lines[: last + 1], given)["y"])
    stress, energy = np.zeros(6), 0.0
    for direction, points in element.tables:  # type: ignore[attr-defined]
        method = {"akima": Akima1DInterpolator, "pchip": PchipInterpolator}[points.kind]
        curve, k = method(points.data.breaks, points.y), DIRECTIONS.index(direction)
        stress[k] = curve(y[k])
        # piece by piece: the breaks are corners of a derivative
        ends = sorted({0.0, y[k], *(x for x in points.data.breaks if 0 < x / y[k] < 1)})
        energy += np.sign(y[k]) * sum(quad(curve, a, b)[0] for a, b in pairwise(ends))
    return {"t": column(stress), "W": energy}


def _flow_rates(element: ForceElement, shown: dict[str, Any]) -> list[float]:
    """Rates of the states in their order."""
    if element.kind != "bushing":
        return [shown["zdot"]]
    rates = []
    for state in element.internals():
        _, branch, direction = state.name.split(".")
        rates.append(float(shown[f"zdot_{branch}"][DIRECTIONS.index(direction), 0]))
    return rates


def _places(bench: Bench) -> Places:
    element = bench.element
    frames = {role: FRAMES[name] for role, name in element.frames().items()}
    joints = {role: JOINTS[name] for role, name in element.joints().items()}
    rotor = element.rotor()
    if rotor is not None and rotor.ratio is None:
        joints["rotor"] = JOINTS["rotor"]
    if element.masses():
        frames["body"] = FRAMES["B"]
    graph = bench.motion.graph
    z, s = block(graph, "z", len(element.internals())), block(graph, "s", len(element.modes()))
    return Places(bench.motion, bench.data, frames, joints, z, s)


def _given(element: ForceElement, bench: Bench, at: Places) -> dict[str, Any]:
    """Names that formulas use without defining them."""
    letters = LETTERS | (DRIVE if element.kind == "drive" else {})
    given: dict[str, Any] = {}
    for name, matrix in bench.data.items():
        values = np.array([float(x) for x in np.ravel(bench.value(matrix))])
        if name == "inertia" and element.masses():
            given["I_body"] = values.reshape(3, 3)
        elif name.startswith("branches."):
            _, branch, what = name.split(".")
            letter = {"stiffness": "K", "time": "tau"}[what]
            given[f"{letter}_{branch}"] = _spring_data(what, values)
            given[f"z_{branch}"] = column(np.full(6, 0.4))
        elif element.kind in SPRINGS:
            given[SPRINGS[element.kind].get(name) or LETTERS[name]] = _spring_data(name, values)
        else:
            given[letters[name]] = values[0] if len(values) == 1 else column(values)
    if "I_body" in given:
        given["I"] = given.pop("I_body")
    several = len(set(at.frames) - {"in_"}) > 1
    for role, frame in at.frames.items():
        index = f"_{ROLES.get(role, role)}" if several or role == "in_" else ""
        R, rate = _rotation(STATE[f"r{frame}"], RATES[f"r{frame}"])
        given |= {f"R{index}": R, f"omega{index}": column(R.T @ rate)}
        given |= {f"p{index}": column(STATE[f"x{frame}"]), f"v{index}": column(RATES[f"x{frame}"])}
    for role, joint in at.joints.items():
        index = "_rotor" if role == "rotor" and "joint" in at.joints else ""
        for letter, values in (("q", STATE), ("u", RATES)):
            entries = values[f"q{joint}"]
            given[f"{letter}{index}"] = entries[0] if len(entries) == 1 else column(entries)
    given["z"] = 0.4
    return given


def _spring_data(name: str, values: Any) -> Any:
    """Six or 21 numbers as a symmetric matrix, a vector, or a number."""
    if name in ("axis", "rest"):
        return column(values)
    if len(values) == 1:
        return values[0]
    k = np.diag(values) if len(values) == 6 else np.zeros((6, 6))
    if len(values) == 21:
        k[np.triu_indices(6)] = values
        k = np.triu(k) + np.triu(k, 1).T
    return k


def _rotation(r: list[float], rate: list[float]) -> tuple[Any, Any]:
    """R and angular velocity in ground axes of a rotation vector and its rate."""
    x, angle = skew(r), np.linalg.norm(r)
    left = np.eye(3)
    if angle:
        left += (1 - np.cos(angle)) / angle**2 * x + (angle - np.sin(angle)) / angle**3 * x @ x
    return Rotation.from_rotvec(r).as_matrix(), left @ rate


def _acted(bench: Bench, at: Places) -> tuple[dict[int, Any], dict[int, Any], float]:
    """(moment, force) by frame, force by joint, energy."""
    loads = {frame: np.zeros((2, 3)) for frame in FRAMES.values()}
    along: dict[int, Any] = dict.fromkeys(JOINTS.values(), 0.0)
    energy = 0.0
    for action in map(bench.in_ground, bench.element.act(at)):
        for load in action.loads:
            loads[load.frame] += [_floats(bench, load.torque), _floats(bench, load.force)]
        for joint_load in action.joint_loads:
            along[joint_load.joint] = along[joint_load.joint] + _floats(bench, joint_load.force)
        if action.potential is not None:
            energy += float(bench.value(action.potential))
    return loads, along, energy


def _floats(bench: Bench, x: Any) -> Any:
    return np.array([float(v) for v in np.ravel(bench.value(x))])
