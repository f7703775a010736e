"""docs/translations.md is true: both sides of every line run, and agree where the page says so."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "docs" / "translations.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| ([^|]+) \| ([^|]+) \| ([^|]+) \| ?(=|runs)? ?\|$", re.MULTILINE)
# of a run with fixed steps on the other side
ROUGH = {"a run", "run, position of the tip"}
ARM = """<mujoco><compiler angle="radian"/><option><flag energy="enable"/></option><worldbody>
<body name="upper" pos="0 0 1"><joint name="shoulder" axis="0 1 0" damping="0.2"/>
<inertial mass="1.5" pos="0.2 0 0" diaginertia="0.002 0.02 0.02"/>
<body name="forearm" pos="0.4 0 0"><joint name="elbow" axis="0 1 0.2" stiffness="0.5"/>
<inertial mass="0.8" pos="0.15 0.01 0" diaginertia="0.001 0.006 0.006"/>
<site name="hand" pos="0.3 0 0"/></body></body></worldbody></mujoco>
"""
URDF = """<robot name="arm"><link name="base"/>
<link name="upper"><inertial><origin xyz="0.2 0 0"/><mass value="1.5"/>
<inertia ixx="0.002" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="hand"><inertial><origin xyz="0.15 0.01 0"/><mass value="0.8"/>
<inertia ixx="0.001" iyy="0.006" izz="0.006" ixy="0" ixz="0.0002" iyz="0"/></inertial></link>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
<origin xyz="0 0 0.3"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="9" velocity="9"/>
<dynamics damping="0.2"/></joint>
<joint name="elbow" type="revolute"><parent link="upper"/><child link="hand"/>
<origin xyz="0.4 0 0" rpy="0.3 0 0"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="9" velocity="9"/></joint></robot>
"""


def table(title: str) -> list[tuple[str, str, str, str]]:
    """Lines of one table: subject, both sides, and what is compared."""
    (section,) = re.findall(rf"^## {title}\n(.*?)(?=^## |\Z)", TEXT, re.MULTILINE | re.DOTALL)
    return [tuple(map(str.strip, row)) for row in ROW.findall(section)]


def pendulum() -> dict[str, Any]:
    """A pendulum of one rod, and what the lines about scenes need."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -1.0))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    tip = rod.at(0, 0, -1, name="tip")
    model, equations = cd.compile(scene), cd.derive(scene)
    q, u = np.array([0.3]), np.array([0.2])
    names = {"scene": scene, "rod": rod, "tip": tip, "model": model, "equations": equations}
    names |= {"anchor": scene.ground.at(1, 0, 0), "v": cd.vectors(equations)}
    names["other"] = cd.Scene("other")
    return {**names, "cd": cd, "q": q, "u": u, "x": np.concatenate([q, u])}


def sympy_side() -> tuple[dict[str, Any], dict[str, Any]]:
    from sympy.physics import mechanics as me

    theta, omega = me.dynamicsymbols("theta omega")
    N, frame = me.ReferenceFrame("N"), me.ReferenceFrame("B")
    l, m, g = 1, 1, sympy.Float("9.81")
    frame.orient_axis(N, theta, N.y)
    frame.set_ang_vel(N, omega * N.y)
    origin = me.Point("O")
    point = origin.locatenew("P", -l * frame.z)
    origin.set_vel(N, 0)
    point.v2pt_theory(origin, N, frame)
    bob = me.Particle("bob", point, m)
    kane = me.KanesMethod(N, [theta], [omega], kd_eqs=[theta.diff() - omega])
    kane.kanes_equations([bob], [(point, -m * g * N.z)])
    turned = me.ReferenceFrame("C")
    turned.orient_axis(N, theta, N.y)
    swung = me.Point("S")
    swung.set_vel(N, (-l * turned.z).dt(N))
    L = me.Lagrangian(N, me.Particle("swung", swung, m)) + m * g * l * sympy.cos(theta)
    lagrange = me.LagrangesMethod(L, [theta])
    lagrange.form_lagranges_equations()
    names = {"me": me, "sympy": sympy, "N": N, "frame": frame, "origin": origin, "point": point}
    names |= {"l": l, "kane": kane, "omega": omega, "lagrange": lagrange}
    names |= {"rest": {theta: 0, omega: 0}, "q_": theta, "u_": omega}
    names["state"] = {theta.diff(): 0.2, omega: 0.2, theta: 0.3}
    names["bodies"] = [me.RigidBody("a"), me.RigidBody("b")]
    return pendulum(), names


def pinocchio_side() -> tuple[dict[str, Any], dict[str, Any]]:
    pin = pytest.importorskip("pinocchio")
    Path("arm.urdf").write_text(URDF)
    model = cd.compile(cd.load("arm.urdf"))
    robot = pin.buildModelFromUrdf("arm.urdf")
    data = robot.createData()
    q, u, a = np.array([0.4, -0.7]), np.array([0.5, 1.2]), np.array([2.0, -1.0])
    q2, tau, hand = np.array([0.1, 0.2]), np.array([0.3, -0.2]), robot.getFrameId("hand")
    q_pin, v = cd.convert.to_pinocchio(model, q, u)

    def placed(robot: Any, data: Any, q_pin: Any) -> Any:
        pin.framesForwardKinematics(robot, data, q_pin)
        return data.oMf[hand].homogeneous

    ours = {"cd": cd, "model": model, "q": q, "u": u, "a": a, "q2": q2, "tau": tau}
    theirs = {"pin": pin, "robot": robot, "data": data, "q_pin": q_pin, "v": v, "a": a, "q2": q2}
    return ours, theirs | {"tau": tau, "hand": hand, "placed": placed}


def mujoco_side() -> tuple[dict[str, Any], dict[str, Any]]:
    mujoco = pytest.importorskip("mujoco")
    Path("arm.xml").write_text(ARM)
    scene = cd.load("arm.xml")
    model, robot = cd.compile(scene), mujoco.MjModel.from_xml_path("arm.xml")
    q, u, a = np.array([0.4, -0.7]), np.array([0.5, 1.2]), np.array([2.0, -1.0])

    def at_start() -> Any:
        data = mujoco.MjData(robot)
        data.qpos[:], data.qvel[:] = q, u
        mujoco.mj_forward(robot, data)
        return data

    def full_mass_matrix(robot: Any, data: Any) -> Any:
        M = np.zeros((robot.nv, robot.nv))
        mujoco.mj_fullM(robot, data, M)
        return M

    def inverse(robot: Any, data: Any, a: Any) -> Any:
        data = at_start()
        data.qacc[:] = a
        mujoco.mj_inverse(robot, data)
        return data.qfrc_inverse.copy()

    def site_jacobian(robot: Any, data: Any) -> Any:
        J = np.zeros((3, robot.nv))
        mujoco.mj_jacSite(robot, data, J, None, robot.site("hand").id)
        return J

    def stepped(robot: Any, data: Any, time: float) -> Any:
        data = at_start()
        robot.opt.timestep = 1e-4
        robot.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
        for _ in range(round(time / 1e-4)):
            mujoco.mj_step(robot, data)
        return data.qpos.copy()

    ours = {"cd": cd, "scene": scene, "model": model, "q": q, "u": u, "a": a}
    theirs = {"mujoco": mujoco, "robot": robot, "data": at_start(), "a": a}
    helpers = (full_mass_matrix, inverse, site_jacobian, stepped)
    return ours, theirs | {one.__name__: one for one in helpers}


def exudyn_side() -> tuple[dict[str, Any], dict[str, Any]]:
    exu = pytest.importorskip("exudyn")
    import exudyn.utilities as eu

    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    inertia = eu.InertiaCuboid(1000, [0.1, 0.1, 0.1])
    ground, body = mbs.CreateGround(), mbs.CreateRigidBody(inertia=inertia)

    def solved(_: Any) -> Any:
        mbs = SC.AddSystem()
        angle, ground = 0.5, mbs.CreateGround()
        point = eu.RigidBodyInertia(1.0, np.eye(3) * 1e-9)
        R = eu.RotationMatrixY(angle)
        place = R @ [0, 0, -1.0]
        bob = mbs.CreateRigidBody(
            inertia=point, referencePosition=place, referenceRotationMatrix=R,
            gravity=[0, 0, -9.81],
        )  # fmt: skip
        mbs.CreateRevoluteJoint(itemNumbers=[ground, bob], position=[0, 0, 0], axis=[0, 1, 0])
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = 2000
        settings.timeIntegration.endTime = 0.5
        settings.solution.file.write = False
        settings.timeIntegration.verboseMode = 0
        mbs.SolveDynamic(settings)
        return mbs.GetObjectOutputBody(bob, exu.OutputVariableType.Position, [0, 0, 0])

    theirs = {"exu": exu, "SC": SC, "mbs": mbs, "inertia": inertia, "ground": ground}
    return pendulum(), theirs | {"body": body, "solved": solved}


SIDES: dict[str, Callable[[], tuple[dict[str, Any], dict[str, Any]]]] = {
    "SymPy mechanics": sympy_side,
    "Pinocchio": pinocchio_side,
    "MuJoCo": mujoco_side,
    "Exudyn": exudyn_side,
}


def numbers(value: Any, names: dict[str, Any]) -> np.ndarray[Any, Any]:
    """A result as numbers at one state of the pendulum."""
    if isinstance(value, sympy.Basic | sympy.MatrixBase):
        values = dict(names["model"].parameters) if "model" in names else names["state"]
        values = {**values, "pivot": 0.3, "pivot.u": 0.2}
        value = np.array(sympy.Matrix(value).subs(values).evalf(), dtype=float)
    return np.squeeze(np.asarray(value, dtype=float))


def lines(title: str) -> Iterator[tuple[str, str, str, str]]:
    for subject, ours, theirs, compared in table(title):
        if compared:
            yield subject, ours.strip("`"), theirs.strip("`"), compared


@pytest.mark.parametrize("title", SIDES)
def test_both_sides_run_and_agree(
    title: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ours, theirs = SIDES[title]()
    wrong = []
    for subject, here, there, compared in lines(title):
        try:
            a, b = eval(here, ours), eval(there, theirs)
            if compared == "=":
                a, b = numbers(a, ours), numbers(b, theirs)
                tolerance = 1e-5 if subject in ROUGH else 1e-10 * (1 + abs(b).max())
                assert a.shape == b.shape, f"shapes {a.shape} and {b.shape}"
                assert abs(a - b).max() <= tolerance, f"{a} and {b}"
        except Exception as problem:
            wrong.append(f"{subject}: {type(problem).__name__}: {problem}")
    assert not wrong, "\n".join(wrong)


def test_every_table_compares_numbers() -> None:
    for title in SIDES:
        assert sum(row[3] == "=" for row in table(title)) >= 1, title
        assert len(table(title)) >= 8, title
