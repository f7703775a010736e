"""The judge is judged: power balance, symmetry, closed forms, coupled and prescribed joints."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.runtime.trajectory.joint_poses import POSES, Curve, KindNumbers, pose_of
from cardan.runtime.verification.joint_motion import CIRCLES, REVERSED, joint_data, joint_motion
from cardan.runtime.verification.newton_euler import Scene, inverse_dynamics, mass_matrix
from cardan.runtime.verification.rotations import PARAMETERS, about
from cardan.spatial.rotations import ROTATIONS
from table import each

SIZES = {
    "revolute": (1, 1),
    "prismatic": (1, 1),
    "cylindrical": (2, 2),
    "screw": (1, 1),
    "universal": (2, 2),
    "spherical": (4, 3),
    "planar": (3, 3),
    "translation": (3, 3),
    "free": (7, 6),
    "gear": (1, 1),
    "constant_velocity": (2, 2),
    "point_on_plane": (6, 5),
    "point_on_curve": (5, 4),
    "distance": (6, 5),
    "wheel": (5, 5),
    "rolling_disk": (5, 5),
    "fixed": (0, 0),
    "custom": (2, 2),
}
SIZES |= {REVERSED + kind: size for kind, size in SIZES.items()}
TURNING = {k for k in SIZES if k.split()[-1] in ("spherical", "free", "distance")} | {
    k for k in SIZES if "point_on" in k
}


def pose(q):
    """A joint of the user's own: two rotations about axes at right angles, along a twisted path."""
    a, b = q[:, 0], q[:, 1]
    turned = about(np.array([0.0, 0.0, 1.0]), a) @ about(np.array([1.0, 0.0, 0.0]), b)
    return turned, np.stack([np.sin(a), a * b, np.cos(b)], axis=-1)


ALL = [*SIZES]


def scene(kinds, parents=None, leaders=None, prescribed=None, gravity=(0.0, 0.0, 0.0)):
    """A tree with random numbers; coupled and prescribed joints have no slots."""
    n = len(kinds)
    rng = np.random.default_rng(4)
    leaders = leaders or [-1] * n
    prescribed = prescribed or [False] * n
    q, u, nq, nu = [], [], 0, 0
    for kind, leader, moved in zip(kinds, leaders, prescribed, strict=True):
        a, b = (0, 0) if leader >= 0 or moved else SIZES[kind]
        q.append((nq, a))
        u.append((nu, b))
        nq, nu = nq + a, nu + b
    mass, com = rng.uniform(1, 2, n), rng.uniform(-0.3, 0.3, (n, 3))
    root = rng.uniform(-0.3, 0.3, (n, 3, 3))
    own = root @ np.swapaxes(root, -1, -2) + 0.2 * np.eye(3)
    steiner = (com * com).sum(-1)[:, None, None] * np.eye(3) - com[:, :, None] * com[:, None, :]
    axis = rng.normal(size=(n, 3))
    axis2 = np.cross(axis, rng.normal(size=(n, 3)))
    numbers = {
        "gravity": np.array(gravity),
        "mass": mass,
        "first_moment": mass[:, None] * com,
        "inertia": own + mass[:, None, None] * steiner,
        "rotation": about(np.array([0.6, 0.0, 0.8]), rng.uniform(-1, 1, n)),
        "position": rng.uniform(-0.5, 0.5, (n, 3)),
        "axis": axis,
        "axis2": axis2,
        "pitch": rng.uniform(0.1, 0.3, n),
        "ratio": rng.uniform(0.5, 1.5, n),
        "offset": rng.uniform(-0.5, 0.5, n),
    }
    curve = Curve(np.array([-2.0, 0.3, 2.0]), rng.uniform(-0.1, 0.1, (3, 2, 4)))
    rotations = tuple("quaternion" if k in TURNING else None for k in kinds)
    joints = []
    for i, (kind, rotation) in enumerate(zip(kinds, rotations, strict=True)):
        own = KindNumbers(rotation, axis[i], axis2[i], numbers["pitch"][i], (0.9, 0.2), curve)
        declared = kind.removeprefix(REVERSED)
        of_kind = pose_of(declared, own) if declared in POSES else pose
        joints.append(joint_data(of_kind, kind, rotation))
    return Scene(
        parents=tuple(parents or range(-1, n - 1)),
        kinds=tuple(kinds),
        rotations=rotations,
        q=tuple(q),
        u=tuple(u),
        leaders=tuple(leaders),
        prescribed=tuple(prescribed),
        numbers=numbers,
        nu=nu,
        joints=tuple(joints),
    )


def sizes(s):
    return sum(n for _, n in s.q), s.nu


def random_state(s, seed=0):
    rng = np.random.default_rng(seed)
    nq, nu = sizes(s)
    q = rng.uniform(-1, 1, nq)
    for kind, (start, size) in zip(s.kinds, s.q, strict=True):
        if kind in TURNING and size:
            q[start : start + 4] /= np.linalg.norm(q[start : start + 4])
    return q, rng.uniform(-1, 1, nu), rng.uniform(-1, 1, nu)


def moved(s, q, u, h):
    """q after a small time h at constant speeds, second order in the middle of the step."""
    q = q.copy()
    for kind, (start, size), (begin, length) in zip(s.kinds, s.q, s.u, strict=True):
        own = u[begin : begin + length]
        if kind in TURNING and size:
            w, v = q[start], q[start + 1 : start + 4]
            half = own[:3] * h / 2
            angle = np.linalg.norm(half)
            c, d = np.cos(angle), half * np.sinc(angle / np.pi)
            q[start], q[start + 1 : start + 4] = w * c - v @ d, w * d + c * v + np.cross(v, d)
            q[start + 4 : start + size] += h * own[3:]
        else:
            q[start : start + size] += h * own
    return q


@each("kind", ALL)
@each("place", ["first", "last", "between"])
def test_power_balance(kind, place):
    # without gravity uᵀ tau is the rate of the kinetic energy 1/2 uᵀ M u
    chain = {"first": [kind, "revolute"], "last": ["revolute", kind]}
    s = scene(chain.get(place, ["universal", kind, "revolute"]))
    q, u, udot = random_state(s)
    h = 1e-5

    def kinetic(t):
        speed = u + t * udot
        M = mass_matrix(s, moved(s, q, u + t / 2 * udot, t))
        return 0.5 * speed @ M @ speed

    rate = (kinetic(h) - kinetic(-h)) / (2 * h)
    tau = inverse_dynamics(s, q, u, udot)
    # differences: h² times a third derivative of some tens, and rounding eps / h
    assert abs(u @ tau - rate) < 100 * h**2 + 100 * np.finfo(float).eps / h


@each("kind", ALL)
def test_mass_matrix_is_symmetric_and_positive(kind):
    s = scene(["revolute", kind, kind])
    M = mass_matrix(s, random_state(s)[0])
    # slopes of a pose are differences over a circle: rounding over its radius
    bound = 100 * np.finfo(float).eps / CIRCLES[0]
    assert np.abs(M - M.T).max() < bound * np.abs(M).max()
    assert np.linalg.eigvalsh(M).min() > 0


def test_gravity_is_the_gradient_of_the_potential():
    s = scene(["revolute", "universal", "prismatic"], gravity=(1.0, -2.0, -9.0))
    q, u, _ = random_state(s)
    still = np.zeros(s.nu)
    force = inverse_dynamics(s, q, still, still)
    # the same numbers without gravity but with the base pushed up: nothing is left at rest
    assert np.abs(inverse_dynamics(s, q, still, still, pull=0.0)).max() == 0
    doubled = inverse_dynamics(s, q, still, still, pull=2.0)
    assert np.allclose(doubled, 2 * force, rtol=1e-14)
    h = inverse_dynamics(s, q, u, still) - inverse_dynamics(s, q, u, still, pull=0.0)
    assert np.allclose(h, force, rtol=1e-12)


def test_batch_is_state_by_state():
    s = scene(["free", "spherical", "planar"])
    states = [random_state(s, seed) for seed in range(5)]
    q, u, udot = (np.array(x) for x in zip(*states, strict=True))
    together = inverse_dynamics(s, q, u, udot)
    for i, (a, b, c) in enumerate(states):
        assert np.allclose(together[i], inverse_dynamics(s, a, b, c), rtol=1e-13, atol=1e-13)


def test_free_body_falls_and_spins_as_euler_says():
    s = scene(["free"], gravity=(0.0, 0.0, -9.81))
    s.numbers["first_moment"][:] = 0
    s.numbers["rotation"][:] = np.eye(3)
    q, u, udot = random_state(s)
    tau = inverse_dynamics(s, q, u, udot)
    inertia, m, w = s.numbers["inertia"][0], s.numbers["mass"][0], u[:3]
    assert np.allclose(tau[:3], inertia @ udot[:3] + np.cross(w, inertia @ w), rtol=1e-13)
    assert np.allclose(tau[3:], m * (udot[3:] + np.array([0, 0, 9.81])), rtol=1e-13)


def test_coupled_joint_adds_to_its_leader():
    free = scene(["revolute", "revolute", "prismatic"])
    tied = scene(["revolute", "revolute", "prismatic"], leaders=[-1, 0, -1])
    k, c = tied.numbers["ratio"][1], tied.numbers["offset"][1]
    E = np.array([[1.0, 0.0], [k, 0.0], [0.0, 1.0]])
    q, u, udot = random_state(tied)
    whole = inverse_dynamics(free, E @ q + [0, c, 0], E @ u, E @ udot)
    assert np.allclose(inverse_dynamics(tied, q, u, udot), E.T @ whole, rtol=1e-13)
    M = mass_matrix(free, E @ q + [0, c, 0])
    assert np.allclose(mass_matrix(tied, q), E.T @ M @ E, rtol=1e-13)


def test_prescribed_joint_moves_as_told():
    free = scene(["prismatic", "revolute"])
    told = scene(["prismatic", "revolute"], prescribed=[True, False])
    q, u, udot = random_state(free)
    motion = np.zeros((2, 3))
    motion[0] = q[0], u[0], udot[0]
    whole = inverse_dynamics(free, q, u, udot)
    assert np.allclose(
        inverse_dynamics(told, q[1:], u[1:], udot[1:], motion), whole[1:], rtol=1e-13
    )
    assert np.allclose(mass_matrix(told, q[1:], motion), mass_matrix(free, q)[1:, 1:], rtol=1e-13)
    with pytest.raises(ValueError, match="needs their motion"):
        inverse_dynamics(told, q[1:], u[1:], udot[1:])


@each("kind", ALL)
def test_speeds_are_the_derivative_of_the_pose(kind):
    s = scene([kind])
    q, u, _ = random_state(s)
    h = 1e-5
    now = joint_motion(s.joints[0], q, u)
    ahead, back = (joint_motion(s.joints[0], moved(s, q, u, t), u) for t in (h, -h))
    turning = now.rotation.T @ (ahead.rotation - back.rotation) / (2 * h)
    spin = now.turn @ u
    assert np.abs([turning[2, 1], turning[0, 2], turning[1, 0]] - spin).max() < 10 * h**2
    shift = (ahead.position - back.position) / (2 * h)
    assert np.abs(shift - now.shift @ u).max() < 10 * h**2


def test_every_parametrization_is_known():
    assert set(PARAMETERS) == set(ROTATIONS)
