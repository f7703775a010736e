"""Bushings with springs and dampers in series: closed forms in all six directions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import simpson
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

import cardan as cd
from table import each

COORDINATES = ("relative", "absolute")
DIRECTIONS = ("rx", "ry", "rz", "x", "y", "z")
K = (2.0, 3.0, 4.0, 20.0, 30.0, 50.0)
FAST = ((1.0, 2.0, 0.5, 7.0, 3.0, 9.0), 0.03)
SLOW = ((4.0, 0.0, 1.0, 0.0, 8.0, 2.0), 0.5)
TIGHT: dict[str, Any] = {"rtol": 1e-11, "atol": 1e-13}


def joint(direction: str) -> Any:
    kind = cd.Revolute if direction[0] == "r" else cd.Prismatic
    return kind(direction[-1])


def coupled(seed: int) -> Any:
    root = np.random.default_rng(seed).uniform(-1, 1, (6, 6))
    return root @ root.T + np.diag((4.0, 5.0, 6.0, 40.0, 50.0, 60.0))


def modulus(k: int, t: Any) -> Any:
    """Stress per strain that was put on at t = 0."""
    return K[k] + sum(stiffness[k] * np.exp(-t / tau) for stiffness, tau in (FAST, SLOW))


@each("coordinates", COORDINATES)
def test_relaxation_in_six_directions(coordinates: str) -> None:
    """A body is held where it is; the stress falls by two exponentials, and so does the power."""
    scene = cd.Scene("held", gravity=(0, 0, 0))
    strain = 0.3
    for direction in DIRECTIONS:
        body = scene.body(direction, mass=1.0, inertia=(1, 1, 1))
        scene.joint(f"to_{direction}", joint(direction), scene.ground, body, prescribed=strain)
        mount = cd.Bushing(scene.ground, body, stiffness=K, branches=[FAST, SLOW])
        scene.force(f"on_{direction}", mount)
    # something that moves
    free = scene.body("free", mass=1.0)
    scene.joint("rail", cd.Prismatic("x"), scene.ground, free)
    model = cd.compile(scene, coordinates=coordinates)
    motion = model.simulate(np.linspace(0, 1, 21), method="DOP853", **TIGHT)
    for k, direction in enumerate(DIRECTIONS):
        part = "moment" if k < 3 else "force"
        stress = motion[f"on_{direction}.{part}"][:, k % 3]
        assert np.allclose(stress, strain * modulus(k, motion.t), rtol=1e-10)
    flow = strain * (1 - np.exp(-motion.t / FAST[1]))
    assert np.allclose(motion["on_z.branches.0.z"], flow, atol=1e-11)
    # a direction without stiffness has no state
    names = [entry.name for entry in model.manifest.z]
    assert "on_ry.branches.1.rx" in names
    assert "on_ry.branches.1.ry" not in names


def test_creep_in_six_directions() -> None:
    """Under a constant load, beside the exact solution of mass, spring and branch.

    With little mass the strain is that of a standard linear solid.
    """
    scene, loads = cd.Scene("creeping", gravity=(0, 0, 0)), []
    mass, (stiffness, tau), load = 1e-4, FAST, 0.4
    for k, direction in enumerate(DIRECTIONS):
        body = scene.body(direction, mass=mass, inertia=(mass, mass, mass))
        scene.joint(f"to_{direction}", joint(direction), scene.ground, body)
        mount = cd.Bushing(scene.ground, body, stiffness=K, branches=FAST)
        scene.force(f"on_{direction}", mount)
        at = load * np.eye(3)[k % 3]
        act = cd.Torque(body, at) if k < 3 else cd.Force(body, at)
        scene.force(f"load_{direction}", act)
        late = tau * (K[k] + stiffness[k]) / K[k]
        loads.append((load / (K[k] + stiffness[k]), late))
    q = {f"to_{d}": loads[k][0] for k, d in enumerate(DIRECTIONS)}
    u = {
        f"to_{d}": stiffness[k] / (K[k] + stiffness[k]) * load / K[k] / loads[k][1]
        for k, d in enumerate(DIRECTIONS)
    }
    motion = cd.compile(scene).simulate(
        np.linspace(0, 0.2, 9), q=q, u=u, method="Radau", rtol=1e-10, atol=1e-12
    )
    for k, direction in enumerate(DIRECTIONS):
        late = loads[k][1]
        # x, its rate and the strain of the damper about where they end
        A = [
            [0, 1, 0],
            [-(K[k] + stiffness[k]) / mass, 0, stiffness[k] / mass],
            [1 / tau, 0, -1 / tau],
        ]
        end = load / K[k]
        start = np.array([q[f"to_{direction}"] - end, u[f"to_{direction}"], -end])
        exact = [end + (expm(np.array(A) * t) @ start)[0] for t in motion.t]
        assert np.allclose(motion[f"to_{direction}"], exact, atol=1e-8)
        share = stiffness[k] / (K[k] + stiffness[k])
        creep = end * (1 - share * np.exp(-motion.t / late))
        assert np.allclose(motion[f"to_{direction}"], creep, rtol=0.02)


@each("coordinates", COORDINATES)
def test_complex_dynamic_stiffness(coordinates: str) -> None:
    """k + sum of K i w tau / (1 + i w tau), all matrices full, from inputs to displacements."""
    stiffness, fast, slow = coupled(1), coupled(2), coupled(3)
    scene = cd.Scene("shaker", gravity=(0, 0, 0))
    inertia = np.diag((0.3, 0.2, 0.4, 1.5, 1.5, 1.5))
    body = scene.body("block", mass=1.5, inertia=(0.3, 0.2, 0.4))
    scene.joint("floating", cd.Free(), scene.ground, body)
    mount = cd.Bushing(scene.ground, body, stiffness, branches=[(fast, 0.1), (slow, 2.0)])
    scene.force("mount", mount)
    inputs = [scene.input(name) for name in ("mx", "my", "mz", "fx", "fy", "fz")]
    scene.force("shaken", cd.Force(body, inputs[3:]))
    scene.force("twisted", cd.Torque(body, inputs[:3]))
    for k, rate in enumerate((*body.angular_velocity(), *body.velocity())):
        scene.output(f"rate_{DIRECTIONS[k]}", rate)
    linear = cd.compile(scene, coordinates=coordinates).linearize()
    for omega in (0.05, 1.0, 7.0, 30.0, 400.0):
        s = 1j * omega
        transfer = linear.C @ np.linalg.solve(s * np.eye(len(linear.A)) - linear.A, linear.B)
        closed = stiffness - omega**2 * inertia
        for branch, tau in ((fast, 0.1), (slow, 2.0)):
            closed = closed + branch * (s * tau / (1 + s * tau))
        assert np.allclose((transfer + linear.D) / s @ closed, np.eye(6), atol=1e-10)


def test_modes_are_the_roots_of_the_characteristic_polynomial() -> None:
    mass, k, branch, tau = 2.0, 30.0, 12.0, 0.2
    scene = cd.Scene("one", gravity=(0, 0, 0))
    body = scene.body("block", mass=mass)
    scene.joint("rail", cd.Prismatic("y"), scene.ground, body)
    stiffness = (0, 0, 0, 0, k, 0)
    mount = cd.Bushing(scene.ground, body, stiffness, branches=((0, 0, 0, 0, branch, 0), tau))
    scene.force("mount", mount)
    roots = np.roots([mass * tau, mass, (k + branch) * tau, k])
    for coordinates in COORDINATES:
        values = cd.compile(scene, coordinates=coordinates).linearize().eigenvalues
        assert np.allclose(np.sort_complex(values), np.sort_complex(roots), rtol=1e-11)


def test_an_equilibrium_is_relaxed() -> None:
    """Branches bear nothing, and their dampers have the strain."""
    scene = cd.Scene("hung", gravity=(0, 0, -9.81))
    body = scene.body("block", mass=2.0, inertia=(1, 1, 1))
    scene.joint("floating", cd.Free(), scene.ground, body)
    mount = cd.Bushing(scene.ground, body, stiffness=K, branches=[FAST, SLOW])
    scene.force("mount", mount)
    for coordinates in COORDINATES:
        model = cd.compile(scene, coordinates=coordinates)
        hung = model.equilibrium()
        assert hung["floating.pz"] == pytest.approx(-2.0 * 9.81 / K[5], rel=1e-11)
        assert hung.stable
        for n in range(2):
            assert hung[f"mount.branches.{n}.z"] == pytest.approx(hung["floating.pz"], rel=1e-10)
        # it stays where it is
        motion = model.simulate(1.0, x0=hung)
        assert np.ptp(motion["floating.pz"]) < 1e-9


def far_turned(scene: cd.Scene) -> list[Any]:
    """Two free bodies and coupled branches between frames that are turned."""
    bodies = [
        scene.body("first", mass=2.0, com=(0.1, 0, 0.2), inertia=(0.3, 0.4, 0.5)),
        scene.body("second", mass=1.0, com=(0, -0.1, 0), inertia=(0.2, 0.1, 0.25)),
    ]
    for body in bodies:
        scene.joint(f"{body.name}_free", cd.Free(), scene.ground, body)
    ends = [
        body.at(0.1 * k, 0.2, -0.1, rotation=("XYZ", 0.3, k, -0.5)) for k, body in enumerate(bodies)
    ]
    table = cd.table(np.linspace(-2, 2, 9), np.linspace(-2, 2, 9) ** 3 * 20, "cubic")
    mount = cd.Bushing(
        *ends,
        stiffness=0.5 * coupled(4),
        rest=(0, 0.1, 0, 0.05, 0, 0),
        tables={"y": table},
        branches=[(coupled(5), 0.2), (SLOW[0], 1.5)],
    )
    scene.force("mount", mount)
    return bodies


Q = {"first_free": [1.0, 0, 0, 0, 0, 0, 0], "second_free": [0.8, 0.6, 0, 0, 0.1, 0.2, 0]}
U = {"first_free": [1.0, 0.5, -0.3, 0.2, 0, 0], "second_free": [-0.5, 0.2, 0.9, 0, -0.4, 0.3]}


def test_what_branches_store_and_lose() -> None:
    """Their work is the energy in their springs and the heat of their dampers, far turned."""
    scene = cd.Scene("pair", gravity=(0, 0, 0))
    far_turned(scene)
    model = cd.compile(scene)
    motion = model.simulate(
        np.linspace(0, 2, 4001), q=Q, u=U, method="DOP853", rtol=1e-11, atol=1e-12
    )
    # the strain anew from poses
    ends = [motion.pose(name) for name in ("first", "second")]
    frames = []
    for k, pose in enumerate(ends):
        local = np.eye(4)
        local[:3, :3] = Rotation.from_euler("XYZ", (0.3, k, -0.5)).as_matrix()
        local[:3, 3] = (0.1 * k, 0.2, -0.1)
        frames.append(pose @ local)
    a, b = frames
    turn = Rotation.from_matrix(np.swapaxes(a[:, :3, :3], 1, 2) @ b[:, :3, :3])
    d = np.einsum("nji,nj->ni", a[:, :3, :3], b[:, :3, 3] - a[:, :3, 3])
    halfway = Rotation.from_rotvec(turn.as_rotvec() / 2)
    y = np.hstack([turn.as_rotvec(), halfway.inv().apply(d)]) - (0, 0.1, 0, 0.05, 0, 0)
    stored, heat = np.zeros(len(motion.t)), np.zeros(len(motion.t))
    for n, (stiffness, tau) in enumerate(((coupled(5), 0.2), (np.diag(SLOW[0]), 1.5))):
        flow = np.zeros_like(y)
        for k, direction in enumerate(DIRECTIONS):
            if stiffness[k].any():
                flow[:, k] = motion[f"mount.branches.{n}.{direction}"]
        density = np.einsum("ni,ij,nj->n", y - flow, stiffness, y - flow)
        stored, heat = stored + density / 2, heat + density / tau
    lost = np.array([simpson(heat[: i + 1], x=motion.t[: i + 1]) for i in (1000, 2000, 4000)])
    work = motion.work["mount"][[1000, 2000, 4000]]
    assert np.all(heat >= 0)
    assert np.all(lost > 0.5)
    assert np.allclose(-work, (stored - stored[0])[[1000, 2000, 4000]] + lost, atol=1e-8)
    assert np.abs(motion.energy_residual).max() < 1e-7


def test_branches_are_objective() -> None:
    """A motion seen from elsewhere is the same motion: poses turn, states stay."""
    turn, shift = Rotation.from_rotvec([1.0, -2.0, 0.5]), np.array([0.3, -1.0, 2.0])
    ends = []
    for seen in (False, True):
        q, u = dict(Q), dict(U)
        for name in q if seen else ():
            pose = turn * Rotation.from_quat(np.roll(q[name][:4], -1))
            at = turn.apply(q[name][4:]) + shift
            q[name] = [*np.roll(pose.as_quat(), 1), *at]
            u[name] = [*u[name][:3], *turn.apply(u[name][3:])]
        scene = cd.Scene("pair", gravity=(0, 0, 0))
        far_turned(scene)
        for coordinates in COORDINATES:
            model = cd.compile(scene, coordinates=coordinates)
            motion = model.simulate([0.0, 0.3], q=q, u=u, method="DOP853", rtol=1e-11, atol=1e-12)
            force, at = motion["mount.force"][-1], motion.pose("second")[-1][:3, 3]
            if seen:
                force, at = turn.inv().apply(force), turn.inv().apply(at - shift)
            states = [motion[entry.name][-1] for entry in model.manifest.z]
            ends.append(np.concatenate([force, at, states]))
    assert np.abs(ends[0][6:]).max() > 0.1
    for end in ends[1:]:
        assert np.allclose(end, ends[0], atol=1e-8)


@each("coordinates", ("auto", "absolute"))
def test_branches_at_the_tip_of_a_beam(coordinates: str) -> None:
    """Along the line of a bar, against elements that act along a line."""
    histories = []
    for along in (False, True):
        scene = cd.Scene("bar", gravity=(0, 0, 0))
        section = cd.section.general(EA=50.0, GA=1e3, GJ=1e3, EI=1e3, rhoA=0.5, rhoI=1e-2)
        beam = scene.beam("bar", scene.ground, (1, 0, 0), section, elements=3)
        block = scene.body("block", mass=0.4, inertia=(1, 1, 1))
        scene.joint("rail", cd.Prismatic("x"), scene.ground.at(1, 0, 0), block)
        if along:
            ends = beam.end, block.at(2, 0, 0)
            scene.force("spring", cd.SpringDamper(*ends, 20.0, 0.1, rest_length=2.0))
            scene.force("branch", cd.Maxwell(*ends, 30.0, 30.0 * 0.3, rest_length=2.0))
        else:
            mount = cd.Bushing(
                beam.end,
                block,
                (0, 0, 0, 20.0, 0, 0),
                (0, 0, 0, 0.1, 0, 0),
                branches=((0, 0, 0, 30.0, 0, 0), 0.3),
            )
            scene.force("mount", mount)
        model = cd.compile(scene, coordinates=coordinates)
        motion = model.simulate(
            np.linspace(0, 0.5, 51), q={"rail": 0.1}, step=1e-3, method="GeneralizedAlpha"
        )
        state = "branch.flow" if along else "mount.branches.0.x"
        histories.append(np.array([motion["rail"], motion[state]]))
    assert np.ptp(histories[0][1]) > 0.02
    assert np.allclose(*histories, atol=1e-10)


def test_numbers_of_branches_are_parameters() -> None:
    scene = cd.Scene("pair", gravity=(0, 0, 0))
    far_turned(scene)
    model = cd.compile(scene)
    assert model.parameters["mount.branches.0.stiffness.rx_z"] == coupled(5)[0, 5]
    assert model.parameters["mount.branches.1.time"] == 1.5
    x = model.initial(Q, U)
    q, u = model.split(x)
    z = np.linspace(-0.1, 0.1, len(x) - len(q) - len(u))
    slower = model.with_parameters({"mount.branches.1.time": 3.0})
    states = model.rhs(0.0, np.concatenate([q, u, z])), slower.rhs(0.0, np.concatenate([q, u, z]))
    assert np.allclose(states[0][-4:], 2 * states[1][-4:], rtol=1e-14)
    assert np.array_equal(states[0][:-4], states[1][:-4])
    with pytest.raises(cd.ModelError, match=r"branches.1.time is -1; give more than 0"):
        model.with_parameters({"mount.branches.1.time": -1.0})


def test_members_that_differ_by_numbers_share_their_functions() -> None:
    scene = cd.Scene("many", gravity=(0, 0, 0))
    for n in range(3):
        body = scene.body(f"b{n}", mass=1.0, inertia=(1, 1, 1))
        scene.joint(f"j{n}", cd.Free(), scene.ground, body)
        branch = ((0, 0, 0, 2.0 + n, 3.0, 4.0), 0.1 + n)
        scene.force(f"m{n}", cd.Bushing(scene.ground, body, branches=branch))
    kinds = cd.derive(scene, coordinates="absolute").kinds
    assert [kind.name for kind in kinds].count("bushing") == 1


@each("form", ("torque", "energy"))
def test_data_with_internal_states_tell_the_rest(form: str) -> None:
    """Stiffness, damping and mass of a run are estimated exactly beside a curve and branches."""
    scene = cd.Scene("known", gravity=(0, 0, -9.81))
    body = scene.body("block", mass=2.0, inertia=(1, 2, 3))
    scene.joint("floating", cd.Free(), scene.ground, body)
    table = cd.table(np.linspace(-2, 2, 9), np.linspace(-2, 2, 9) ** 3 * 20, "cubic")
    arguments = {"tables": {"z": table}, "branches": [FAST, SLOW]}
    mount = cd.Bushing(scene.ground, body, K, (0.1,) * 6, **arguments)
    scene.force("mount", mount)
    model = cd.compile(scene)
    start = {"floating": [1, 0, 0, 0, 0.1, 0.05, -0.6]}, {"floating": [0.3, 0.6, 0.1, 0, 0, 0]}
    motion = model.simulate(np.linspace(0, 2, 801), q=start[0], u=start[1], rtol=1e-10, atol=1e-12)
    # nothing but the elements of the model drove it
    assert np.abs(motion.torques().forces).max() < 1e-9
    found = model.identify(motion, form=form, stretch=4)
    nominal = found.base.of(list(model.inertial_parameters().values()))
    # energies of one short run tell a free body with six springs poorly
    assert np.allclose(found.estimates, nominal, atol=1e-8 if form == "torque" else 0.02)
    assert found.noise.max() < 1e-6


SIX = (1.0,) * 6


@each(
    "branches, message",
    [
        ((SIX, -1.0), r"branches.0.time is -1; give more than 0"),
        ([(SIX, 1.0), (SIX, 0)], r"branches.1.time is 0; give more than 0"),
        ((SIX, np.nan), r"branches\[0\].time is nan; give a finite number"),
        ((SIX, "fast"), r"branches\[0\].time is 'fast'; give a finite number"),
        (((1, 2, 3), 1.0), r"branches\[0\].stiffness has 3 entries; give 6"),
        (((1, 1, 1, np.inf, 1, 1), 1.0), r"branches\[0\].stiffness\[3\] is inf; give a finite"),
        (((1, 1, 1, -2, 1, 1), 1.0), r"branches\[0\].stiffness has the eigenvalue -2; give a"),
        ((np.eye(6) - 0.5, 1.0), r"branches\[0\].stiffness has the eigenvalue -2; give a"),
        ((np.triu(np.ones((6, 6))), 1.0), r"branches\[0\].stiffness\[1\]\[0\] is 0.0 and .*symm"),
        (((0,) * 6, 1.0), r"branches\[0\] has no stiffness; leave it out"),
        ([(SIX, 1.0, 2.0)], r"branches\[0\] is .*; give a pair of a stiffness and a relaxation"),
        ([3.0], r"branches\[0\] is 3.0; give a pair"),
        (3.0, r"branches is 3.0; give a pair"),
        ({"z": SIX}, r"branches is .*; give a pair"),
    ],
)
def test_what_is_not_a_branch_is_named(branches: Any, message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        cd.Bushing("a", "b", branches=branches)


def test_a_direction_written_as_zero_has_no_state() -> None:
    scene = cd.Scene("late", gravity=(0, 0, 0))
    body = scene.body("block", mass=1.0, inertia=(1, 1, 1))
    scene.joint("floating", cd.Free(), scene.ground, body)
    scene.force("mount", cd.Bushing(scene.ground, body, branches=((0, 0, 0, 1, 1, 0), 0.1)))
    scene.values["mount.branches.0.stiffness.z"] = 3.0
    with pytest.raises(cd.ModelError, match=r"branches\[0\].stiffness is 0 in direction z as writ"):
        cd.derive(scene).function("forward_dynamics")
