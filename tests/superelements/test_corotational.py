"""The corotational reference itself: against all nodes of a mesh, and conservation laws."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import cardan as cd
from superelements.components import brick, brick_matrices, faces
from superelements.corotational import STEP, Corotational, Hub, frequencies_at_rest
from superelements.corotational_motion import accelerations, forces, simulate
from superelements.rotations import cross, exponential, product, rotation, skew
from table import each

FRAMES = ("mean", "node", "chord")
RNG = np.random.default_rng(3)
SPIN, TURN = RNG.normal(size=3), exponential(RNG.normal(size=3))
Z_AXIS = np.array([0.0, 0.0, 1.0])


@cache
def soft_brick(modes: int = 2) -> Any:
    """The brick with its stiffness times 1e-4: frequencies of some rad/s and up."""
    M, K, nodes = brick_matrices()
    return cd.superelement.reduce(M, 1e-4 * K, nodes, faces(), modes=modes)


def some_state(element: Corotational, size: float = 0.05) -> tuple[Any, Any]:
    """A turned, moved and deformed configuration, and speeds."""
    rng = np.random.default_rng(5)
    q = element.start(TURN, rng.normal(size=3))
    q = element.moved(q, size * rng.normal(size=element.n_speeds))
    return q, rng.normal(size=element.n_speeds)


def rate(element: Corotational, q: Any, u: Any, of: Any) -> Any:
    """Rate of something along speeds, by a complex step."""
    return of(element.moved(q.astype(complex), 1j * STEP * u)).imag / STEP


@each("frame", FRAMES)
def test_rates_of_the_frame_and_of_local_coordinates(frame: str) -> None:
    element = Corotational.of(soft_brick(), frame, weights=np.array([0.3, 0.7]))
    if frame == "node":
        element = Corotational.of(soft_brick(), frame, node=1)
    q, u = some_state(element)
    k = element.kinematics(q)
    v, w, z = np.split(k.rates @ u, [3, 6])
    np.testing.assert_allclose(
        rate(element, q, u, lambda x: element.kinematics(x).z), z, atol=1e-13
    )
    moving = rate(element, q, u, lambda x: element.kinematics(x).origin)
    np.testing.assert_allclose(k.turn.T @ moving, v, atol=1e-13)
    turning = rate(element, q, u, lambda x: element.kinematics(x).turn)
    np.testing.assert_allclose(k.turn.T @ turning, skew(w), atol=1e-13)


@each("frame", FRAMES)
def test_energy_and_momenta_are_those_of_all_nodes(frame: str) -> None:
    """Of the mesh, in ground axes: no frame, no constants of the inertia."""
    record, (M, _, nodes) = soft_brick(), brick_matrices()
    element = Corotational.of(record, frame)
    q, u = some_state(element)

    def places(x: Any) -> Any:
        k = element.kinematics(x)
        moved = nodes + (record.basis @ k.z).reshape(-1, 3)
        return k.origin + moved @ k.turn.T

    at, velocity = places(q), rate(element, q, u, places)
    impulse = (M @ velocity.ravel()).reshape(-1, 3)
    np.testing.assert_allclose(element.kinetic(q, u), 0.5 * (velocity * impulse).sum(), rtol=1e-12)
    momenta = np.concatenate([impulse.sum(0), cross(at, impulse).sum(0)])
    np.testing.assert_allclose(element.momentum(q, u), momenta, rtol=1e-11, atol=1e-11)


@each("frame", FRAMES)
def test_strain_forces_are_the_slopes_of_the_energy(frame: str) -> None:
    element = Corotational.of(soft_brick(), frame)
    q, u = some_state(element)
    loads = element.strain_forces(q)
    np.testing.assert_allclose(loads @ u, rate(element, q, u, element.potential), rtol=1e-12)
    turning = np.concatenate([RNG.normal(size=3)] * 2)
    rigid = element.rigid(q, turning[:3], turning[3:])
    # rigid motions change no energy, and forces turn with the component
    assert abs(loads @ rigid) < 1e-12 * np.abs(loads).max()
    after = np.zeros(element.n_speeds)
    for i in (3, 9):
        after[i : i + 3] = np.cross(turning[:3], loads[i : i + 3])
    tangent = element.strain_tangent(q)
    np.testing.assert_allclose(tangent @ rigid, after, atol=1e-12 * np.abs(tangent).max())


def stiffening(n: int) -> Any:
    """Some symmetric geometric stiffness by products of angular velocities."""
    A = np.random.default_rng(7).normal(size=(3, 3, n, n))
    A = A + A.transpose(1, 0, 2, 3)
    return A + A.transpose(0, 1, 3, 2)


@each("options", ({}, {"book": True}, {"stiffening": stiffening(14)}, {"hubs": True}))
def test_a_free_motion_keeps_energy_and_momenta(options: dict[str, Any]) -> None:
    if "hubs" in options:
        options = {"hubs": {1: Hub(20.0, np.diag([1.0, 2.0, 2.5]), np.array([0.2, 0.1, -0.1]))}}
    element = Corotational.of(soft_brick(), **options)
    q = element.start(TURN, SPIN)
    u = element.rigid(q, 2 * SPIN, SPIN[::-1]) + 0.1 * some_state(element)[1]
    states = simulate(element, q, u, [0.02, 0.04], rtol=1e-10)
    energy, momentum = element.energy(q, u), element.momentum(q, u)
    for late, speeds in zip(*states, strict=True):
        np.testing.assert_allclose(element.energy(late, speeds), energy, rtol=1e-9)
        np.testing.assert_allclose(element.momentum(late, speeds), momentum, rtol=1e-9, atol=1e-8)
        assert np.abs(speeds - u).max() > 0.05


def boosted(element: Corotational, u: Any, velocity: Any) -> Any:
    """Speeds with the same velocity added everywhere."""
    faster = u.copy()
    for i in range(len(element.places)):
        faster[6 * i + 3 : 6 * i + 6] += velocity
    return faster


@each("frame", FRAMES)
def test_accelerations_do_not_depend_on_a_common_velocity_or_on_axes(frame: str) -> None:
    element = Corotational.of(soft_brick(), frame)
    q, u = some_state(element)
    expected = accelerations(element, q, u)
    scale = np.abs(expected).max()
    fast = accelerations(element, q, boosted(element, u, 100 * SPIN))
    np.testing.assert_allclose(fast, expected, atol=1e-10 * scale)
    R, turned, ahead, after = rotation(TURN), q.copy(), u.copy(), expected.copy()
    for i in range(2):
        at, pose = 6 * i + 3, 7 * i
        turned[pose : pose + 4] = product(TURN, q[pose : pose + 4])
        turned[pose + 4 : pose + 7] = R @ q[pose + 4 : pose + 7] + SPIN
        ahead[at : at + 3] = R @ u[at : at + 3]
        after[at : at + 3] = R @ expected[at : at + 3]
    np.testing.assert_allclose(accelerations(element, turned, ahead), after, atol=1e-11 * scale)


def test_the_form_of_the_book_depends_on_a_common_velocity() -> None:
    """An option to compare with: first order in the deformation and in modal coordinates."""
    element = Corotational.of(soft_brick(), book=True)
    q = element.start()
    u = element.rigid(q, Z_AXIS, np.zeros(3))
    slow, fast = (accelerations(element, q, boosted(element, u, c * SPIN)) for c in (0.0, 10.0))
    assert np.abs(fast - slow).max() > 0.1 * np.abs(slow).max()


def test_frames_agree_where_deformations_are_small() -> None:
    """Forces differ by the second order of the deformation."""
    differences = []
    for size in (1e-3, 1e-4):
        each_frame = []
        for frame in FRAMES:
            element = Corotational.of(soft_brick(), frame)
            q, _ = some_state(element, size)
            each_frame.append(forces(element, q, np.zeros(element.n_speeds))[1])
        differences.append(max(np.abs(f - each_frame[0]).max() for f in each_frame[1:]))
        assert differences[-1] < 30 * size * np.abs(each_frame[0]).max()
    assert 80 < differences[0] / differences[1] < 125


@each("frame", FRAMES)
def test_small_motions_have_the_frequencies_of_the_component(frame: str) -> None:
    element = Corotational.of(brick(modes=6), frame)
    expected = brick(modes=6).modes().frequencies
    np.testing.assert_allclose(frequencies_at_rest(element), expected, rtol=1e-8)


@each("frame", FRAMES)
def test_rigid_motions_are_among_the_shapes(frame: str) -> None:
    """So energy needs no velocity of the frame, and its turning only where there is deformation.

    With y = R0^T x_i' + u_i x w, th_i' + w, eta': T = y M y / 2 + y N w + w B w / 2, where column k
    of N is (S_k Psi z) seen by the shapes and B is of second order in z.
    """
    record = soft_brick()
    element, n = Corotational.of(record, frame), record.n
    q, u = some_state(element)
    k = element.kinematics(q)
    v, w, rates = np.split(k.rates @ u, [3, 6])
    y = rates + record.rigid_motions() @ np.concatenate([v, w])
    across = record.inertia.spin_modal
    both = np.einsum("klab,a,b->kl", record.inertia.spin_spin, k.z, k.z)
    kinetic = y @ record.M @ y / 2 + np.einsum("kab,k,a,b", across, w, k.z, y) + w @ both @ w / 2
    np.testing.assert_allclose(kinetic, element.kinetic(q, u), rtol=1e-12)
    for i in range(2):
        velocity = k.turn.T @ u[6 * i + 3 : 6 * i + 6] + np.cross(k.z[6 * i : 6 * i + 3], w)
        np.testing.assert_allclose(y[6 * i : 6 * i + 3], velocity, atol=1e-13)
    np.testing.assert_allclose(y[12:], u[12:], atol=1e-13)
    assert len(y) == n
