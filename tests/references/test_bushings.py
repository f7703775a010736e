"""Bodies on bushings against published values, in every kind of coordinates."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import cardan as cd
from table import each

HERE = Path(__file__).parent
COORDINATES = ("relative", "absolute")


def reference(name: str) -> dict[str, Any]:
    return dict(json.loads((HERE / f"{name}.json").read_text()))


@each("name", ["bushing_body_A", "bushing_body_B"])
def test_frequencies_of_a_body_on_bushings(name: str) -> None:
    case = reference(name)
    data = case["parameters"]
    scene = cd.Scene("block", gravity=(0, 0, 0))
    block = scene.body("block", mass=data["m"], inertia=data["I"])
    scene.joint("floating", cd.Free(), scene.ground, block)
    stiffness = (*data["k_rotation"], *data["k_translation"])
    for k, point in enumerate(data["points"]):
        mount = cd.Bushing(scene.ground.at(*point), block.at(*point), stiffness=stiffness)
        scene.force(f"mount{k}", mount)
    for coordinates in COORDINATES:
        modes = cd.compile(scene, coordinates=coordinates).modes()
        assert np.allclose(2 * np.pi * modes.frequencies, case["reference"]["omega"], rtol=1e-11)


@each("coordinates", COORDINATES)
def test_large_rotations_on_a_bushing(coordinates: str) -> None:
    case = reference("bushing_large_rotation_A")
    data, start, known = (case[key] for key in ("parameters", "initial_state", "reference"))
    scene = cd.Scene("top", gravity=(0, 0, 0))
    top = scene.body("top", mass=1.0, inertia=data["J"])
    scene.joint("ball", cd.Spherical(), scene.ground, top)
    scene.force("mount", cd.Bushing(scene.ground, top, stiffness=(*data["k"], 0, 0, 0)))
    turned = np.roll(Rotation.from_rotvec(start["psi"]).as_quat(), 1)
    motion = cd.compile(scene, coordinates=coordinates).simulate(
        np.array([0.0, *known["t"]]),
        q={"ball": turned},
        u={"ball": start["Omega_body"]},
        method="DOP853",
        rtol=1e-11,
        atol=1e-12,
    )
    psi = Rotation.from_matrix(motion.pose("top")[1:, :3, :3]).as_rotvec()
    assert np.allclose(psi, known["psi"], atol=1e-9)
    assert np.allclose(motion["ball.u"][1:], known["Omega_body"], atol=1e-9)
    assert np.allclose(motion.energy.total, known["energy"], rtol=1e-10)


def _coupled() -> Any:
    root = np.random.default_rng(5).uniform(-1, 1, (6, 6))
    return root @ root.T + np.diag((4.0, 5.0, 6.0, 40.0, 50.0, 60.0))


def _two_bodies() -> cd.Scene:
    """Two free bodies with a coupled, damped bushing between frames that are turned."""
    scene = cd.Scene("pair", gravity=(0, 0, -1.0))
    bodies = [
        scene.body("first", mass=2.0, com=(0.1, 0, 0.2), inertia=(0.3, 0.4, 0.5)),
        scene.body("second", mass=1.0, com=(0, -0.1, 0), inertia=(0.2, 0.1, 0.25)),
    ]
    for body in bodies:
        scene.joint(f"{body.name}_free", cd.Free(), scene.ground, body)
    ends = [
        body.at(0.1 * k, 0.2, -0.1, rotation=("XYZ", 0.3, k, -0.5)) for k, body in enumerate(bodies)
    ]
    mount = cd.Bushing(
        *ends, stiffness=_coupled(), damping=0.02 * _coupled(), rest=(0, 0.1, 0, 0.05, 0, 0)
    )
    scene.force("mount", mount)
    return scene


def test_a_bushing_between_bodies_is_objective() -> None:
    """A motion seen from elsewhere is the same motion, far turned, with damping and coupling."""
    model = cd.compile(_two_bodies())
    rng = np.random.default_rng(1)
    turn, shift = Rotation.from_rotvec([1.0, -2.0, 0.5]), rng.normal(size=3)
    q = {"first_free": [1, 0, 0, 0, 0, 0, 0], "second_free": [0.8, 0.6, 0, 0, 0.1, 0.2, 0]}
    u = {"first_free": rng.normal(size=6), "second_free": rng.normal(size=6)}

    def moved(which: dict[str, Any], velocity: bool) -> dict[str, Any]:
        entries = {}
        for name, x in which.items():
            x = np.asarray(x, dtype=float)
            if velocity:
                entries[name] = np.concatenate([x[:3], turn.apply(x[3:])])
            else:
                pose = turn * Rotation.from_quat(np.roll(x[:4], -1))
                entries[name] = np.concatenate(
                    [np.roll(pose.as_quat(), 1), turn.apply(x[4:]) + shift]
                )
        return entries

    forces = []
    for at, rates in ((q, u), (moved(q, False), moved(u, True))):
        states = model.split(model.initial(at, rates))
        forces.append(model.element_forces(*states).reshape(2, 3))
    assert np.allclose(turn.apply(forces[0]), forces[1], atol=1e-12)


def test_damping_and_coupling_against_hand_written_equations() -> None:
    """A body on a coupled, damped bushing at the ground, by SciPy on the rotation vector."""
    stiffness, mass, inertia = _coupled(), 1.5, np.array([0.3, 0.2, 0.4])
    scene = cd.Scene("mounted", gravity=(0, 0, 0))
    body = scene.body("block", mass=mass, inertia=inertia)
    scene.joint("floating", cd.Free(), scene.ground, body)
    scene.force(
        "mount", cd.Bushing(scene.ground, body, stiffness=stiffness, damping=0.03 * stiffness)
    )
    start = np.array([0.9, -0.4, 0.3, 0.2, -0.1, 0.3])

    def skew(v: Any) -> Any:
        return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])

    def jacobian(theta: Any) -> Any:
        """theta' by the angular velocity in body axes."""
        x = float(np.linalg.norm(theta))
        a = (1 - x / 2 / np.tan(x / 2)) / x**2
        return np.eye(3) + skew(theta) / 2 + a * skew(theta) @ skew(theta)

    def strain(theta: Any, p: Any) -> Any:
        return np.concatenate([theta, Rotation.from_rotvec(-theta / 2).apply(p)])

    def slopes(theta: Any, p: Any) -> Any:
        """Of the strain, by differences of fourth order."""
        x, h = np.concatenate([theta, p]), 1e-3
        columns = []
        for step in h * np.eye(6):
            at = [strain(*np.split(x + k * step, 2)) for k in (-2, -1, 1, 2)]
            columns.append((at[0] - 8 * at[1] + 8 * at[2] - at[3]) / (12 * h))
        return np.transpose(columns)

    def rates(_: float, x: Any) -> Any:
        theta, p, omega, v = np.split(x, 4)
        D, B = jacobian(theta), slopes(theta, p)
        thetadot = D @ omega
        stress = stiffness @ (strain(theta, p) + 0.03 * B @ np.concatenate([thetadot, v]))
        along = B.T @ stress
        moment = -D.T @ along[:3]
        return np.concatenate(
            [thetadot, v, (moment - np.cross(omega, inertia * omega)) / inertia, -along[3:] / mass]
        )

    solution = solve_ivp(rates, (0, 1.5), [*start, *np.zeros(6)], rtol=1e-10, atol=1e-11)
    theta, p = np.split(start, 2)
    q = [*np.roll(Rotation.from_rotvec(theta).as_quat(), 1), *p]
    for coordinates in COORDINATES:
        model = cd.compile(scene, coordinates=coordinates)
        motion = model.simulate(1.5, q={"floating": q}, method="DOP853", rtol=1e-10, atol=1e-11)
        pose = motion.pose("block")[-1]
        assert np.allclose(pose[:3, 3], solution.y[3:6, -1], atol=1e-8)
        found = Rotation.from_matrix(pose[:3, :3]).as_rotvec()
        assert np.allclose(found, solution.y[:3, -1], atol=1e-8)
        assert np.abs(motion.energy_residual).max() < 1e-8


def test_a_flexible_hinge_is_a_bushing_of_its_axis() -> None:
    axis = np.array([1.0, 2.0, -2.0]) / 3
    line, across = np.outer(axis, axis), np.eye(3) - np.outer(axis, axis)
    stiffness = np.zeros((6, 6))
    stiffness[:3, :3], stiffness[3:, 3:] = 0.5 * line + 80 * across, 900 * line + 700 * across
    udots = []
    for element in ("hinge", "bushing"):
        scene = cd.Scene("flap", gravity=(0, 0, -9.81))
        body = scene.body("flap", mass=0.5, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.03))
        scene.joint("floating", cd.Free(), scene.ground, body)
        ends = (scene.ground, body.at(0.1, 0, 0))
        kind: Any = cd.FlexibleHinge(*ends, axis, 0.5, 80, 900, 700, damping=0.01)
        if element == "bushing":
            kind = cd.Bushing(*ends, stiffness=stiffness, damping=0.01 * stiffness)
        scene.force("hinge", kind)
        model = cd.compile(scene)
        q, u = model.split(
            model.initial({"floating": [0.8, 0.36, 0.48, 0, 0.1, 0, 0]}, {"floating": range(6)})
        )
        udots.append(model.forward_dynamics(q, u))
    assert np.allclose(*udots, rtol=1e-12)


def test_numbers_of_a_bushing_are_parameters() -> None:
    scene = _two_bodies()
    model = cd.compile(scene)
    assert model.parameters["mount.stiffness.rx_z"] == pytest.approx(_coupled()[0, 5])
    udots = []
    for one in (
        model.with_parameters({"mount.stiffness.y": 70.0}),
        cd.compile(scene, specialize={"mount.stiffness.y": 70.0}),
    ):
        q, u = one.split(one.initial({"second_free": [0.8, 0.6, 0, 0, 0.1, 0.2, 0]}))
        udots.append(one.forward_dynamics(q, u))
    assert np.allclose(*udots, rtol=1e-13)


def test_six_numbers_or_a_symmetric_matrix() -> None:
    with pytest.raises(cd.ModelError, match="stiffness has 5 entries; give 6"):
        cd.Bushing("a", "b", stiffness=range(5))
    with pytest.raises(cd.ModelError, match="stiffness has 5 rows; give six numbers or a 6x6"):
        cd.Bushing("a", "b", stiffness=np.eye(6)[:5])
    uneven = np.eye(6)
    uneven[0, 3] = 2.0
    with pytest.raises(cd.ModelError, match=r"stiffness\[3\]\[0\] is 0.0 and stiffness\[0\]\[3\]"):
        cd.Bushing("a", "b", stiffness=uneven)
