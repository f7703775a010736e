"""The corotational reference against values that were computed elsewhere."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from scipy.optimize import root

import cardan as cd
from superelements.components import (
    bar,
    beam,
    brick,
    brick_matrices,
    faces,
    planar_beam,
    reference,
    spatial_beam,
)
from superelements.corotational import Corotational, Hub, frequencies_at_rest
from superelements.corotational_motion import accelerations, simulate
from table import each

FRAMES = ("mean", "node", "chord")
Z_AXIS = np.array([0.0, 0.0, 1.0])


@each("modes", (0, 4, 10))
def test_a_hub_with_a_brick_has_known_frequencies(modes: int) -> None:
    given = reference("hub_brick_A")
    data, expected = given["parameters"], given["reference"][f"cb_{modes}_omega"]
    hub = Hub(data["hub_mass"], np.diag(data["hub_inertia"]), np.array(data["hub_com_from_node0"]))
    element = Corotational.of(brick(modes=modes), hubs={0: hub})
    np.testing.assert_allclose(frequencies_at_rest(element)[: len(expected)], expected, rtol=1e-7)


# beams and bars that spin in their plane


def plane(element: Corotational) -> Any:
    """Numbers of the speeds in the plane z = 0."""
    modes = 12 + np.arange(element.n_modes)
    return np.concatenate([[2, 3, 4, 8, 9, 10], modes])


def spun(element: Corotational, spin: float, velocity: Any) -> tuple[Any, Any]:
    """The state in which a bar along x spins about its center without vibrating."""
    middle = element.places.mean(0)

    def state(unknown: Any) -> tuple[Any, Any]:
        q = element.start(origin=-middle)
        q[4] -= unknown[0]
        q[11] += unknown[0]
        q[14:] = unknown[1:]
        return q, element.rigid(q, spin * Z_AXIS, velocity)

    def vibration(unknown: Any) -> Any:
        q, u = state(unknown)
        after = accelerations(element, q, u, plane(element))
        center = -(spin**2) * q[11]
        return np.concatenate([[after[9] - center], after[12:]]) / spin**2

    solution = root(vibration, np.zeros(1 + element.n_modes), tol=1e-14)
    assert np.abs(vibration(solution.x)).max() < 1e-10
    return state(solution.x)


@each("frame, modes", [("mean", 0), ("chord", 3), ("node", 8)])
def test_a_beam_that_spins_has_the_known_length(frame: str, modes: int) -> None:
    given = reference("se_spin_translate_16")
    element = Corotational.of(beam(method="craig_bampton", modes=modes), frame)
    q, _ = spun(element, given["parameters"]["spin"], np.zeros(3))
    expected = given["reference"][f"elongation_cb_{modes}"]
    np.testing.assert_allclose(q[11] - q[4] - 1.0, expected, rtol=1e-9)


@each("frame", FRAMES)
def test_a_bar_that_spins_and_translates_has_the_known_length(frame: str) -> None:
    given = reference("se_spin_translate_16")
    data, expected = given["parameters"], given["reference"]["elongation_isotropic_linear_mass"]
    element = Corotational.of(bar(1.0, 16, 4194304.0, 3.28125), frame)
    for speed in (0.0, data["translation_velocity"]):
        q, u = spun(element, data["spin"], speed * np.array([1.0, 0.0, 0.0]))
        np.testing.assert_allclose(q[11] - q[4] - 1.0, expected, rtol=1e-9)
        after = accelerations(element, q, u, plane(element))
        assert np.abs(after[[2, 4, 8, 10]]).max() < 1e-9 * data["spin"] ** 2


def test_a_bar_that_spins_has_the_known_length() -> None:
    given = reference("spinning_bar_A")
    data = given["parameters"]
    half, count = data["half_length"], 2 * data["elements_per_half"]
    element = Corotational.of(bar(2 * half, count, data["E"], data["rho"]))
    q, _ = spun(element, data["Omega"], np.zeros(3))
    np.testing.assert_allclose(q[11] - half, given["reference"]["u_tip_fe"], rtol=1e-9)
    # the form of the book leaves the centrifugal force of modal coordinates out
    book, _ = spun(replace(element, book=True), data["Omega"], np.zeros(3))
    assert book[11] - half > 1.1 * given["reference"]["u_tip_fe"]


def flap_stiffness(length: float, elements: int, rhoA: float) -> Any:
    """Geometric stiffness of a clamped planar beam by a unit spin across its axis."""
    h, size = length / elements, 3 * (elements + 1)
    total = np.zeros((size, size))
    points, weights = np.polynomial.legendre.leggauss(4)
    for e in range(elements):
        rows = [3 * e + 1, 3 * e + 2, 3 * e + 4, 3 * e + 5]
        for s, weight in zip((points + 1) / 2, weights / 2, strict=True):
            slope = [
                6 * s * (s - 1) / h,
                (1 - s) * (1 - 3 * s),
                6 * s * (1 - s) / h,
                s * (3 * s - 2),
            ]
            tension = rhoA * (length**2 - (h * (e + s)) ** 2) / 2
            total[np.ix_(rows, rows)] += weight * h * tension * np.outer(slope, slope)
    return total


@each("spin", (0.0, 3.0, 6.0, 12.0))
def test_geometric_stiffness_raises_the_frequencies_of_a_blade(spin: float) -> None:
    """Flap of a blade with its frame on the hub, which spins about an axis in its plane."""
    given = reference("rotating_blade_superelement_A")["reference"][f"Om{spin:.0f}"]
    M, K, nodes = planar_beam(1.0, 24, 1e4, 1.0, 1.0)
    record = cd.superelement.reduce(
        M,
        K,
        nodes,
        {"root": 0, "tip": 24},
        node_dofs="x y rz",
        modes=10,
        geometric={"spin": flap_stiffness(1.0, 24, 1.0)},
    )
    by_spin = np.zeros((3, 3, record.n, record.n))
    by_spin[1, 1] = record.geometric["spin"]
    plain = Corotational.of(record, "node")
    stiff = replace(plain, stiffening=by_spin)
    flaps = [_flap(element, spin) for element in (plain, stiff)]
    np.testing.assert_allclose(
        flaps[0], given["ffrf_clamped_frame_no_stiffening"]["flap"][:2], rtol=2e-5
    )
    np.testing.assert_allclose(flaps[1], given["exact_inextensible"][:2], rtol=6e-5)


def _flap(element: Corotational, spin: float) -> Any:
    """First two frequencies of motions across the blade, by differences of accelerations."""
    free = np.array([8, 10, *(12 + np.arange(element.n_modes))])
    u = np.zeros(element.n_speeds)
    u[[1, 7]] = spin
    u[11] = -spin
    columns = []
    for k in free:
        step = np.zeros(element.n_speeds)
        step[k] = 1e-5
        both = [element.moved(element.start(), sign * step) for sign in (1, -1)]
        after = [
            accelerations(element, q, element.rigid(q, np.array([0, spin, 0]), np.zeros(3)), free)
            for q in both
        ]
        columns.append((after[0] - after[1])[free] / 2e-5)
    squares = np.sort(np.linalg.eigvals(-np.array(columns).T).real)
    return np.sqrt(squares[:2])


@each("modes, name", [(0, "se1_int0"), (4, "se1_int2")])
def test_a_chord_frame_stiffens_a_blade_that_is_one_component(modes: int, name: str) -> None:
    """By its geometry alone; the values are of one other implementation."""
    spin, elements = 3.0, 48
    M, K, nodes = spatial_beam(1.0, elements, 1e4, 1.0, 1.0, twisting=1e-4)
    ends = {"root": 0, "tip": elements}
    record = cd.superelement.reduce(M, K, nodes, ends, node_dofs="x y z rx ry rz", modes=modes)
    element, free = Corotational.of(record, "chord"), np.arange(6, 12 + modes)

    def after(stretch: float, step: Any = 0.0) -> Any:
        q = element.start()
        q[11] += stretch
        q = element.moved(q, step * np.ones(12 + modes))
        return accelerations(element, q, element.rigid(q, spin * Z_AXIS, np.zeros(3)), free)

    # the blade stretches until the tip goes around in a circle
    stretch = root(lambda x: after(x[0])[9] + spin**2 * (1 + x[0]), [0.0], tol=1e-13).x[0]
    units = np.eye(12 + modes)[free] * 1e-5
    rows = [(after(stretch, one) - after(stretch, -one))[free] for one in units]
    squares, shapes = np.linalg.eig(-np.array(rows).T / 2e-5)
    across = np.abs(shapes[[1, 5]]).max(0) > 1e-6  # the tip leaves the plane of the spin
    expected = reference("rotating_blade_superelement_A")["reference"]["Om3"][name]
    flaps = np.sqrt(np.sort(squares[across].real))[: len(expected)]
    np.testing.assert_allclose(flaps, expected, rtol=1e-4)


# long motions


def test_a_brick_on_a_spherical_joint_moves_as_known() -> None:
    given = reference("se_spherical_joint_A")
    M, K, nodes = brick_matrices()
    scale, modes = given["parameters"]["K_scale"], given["parameters"]["cb_modes"]
    record = cd.superelement.reduce(M, scale * K, nodes, faces(), modes=modes)
    element = Corotational.of(record, "node", gravity=-given["parameters"]["gravity"] * Z_AXIS)
    q = element.start(origin=-element.places[0])
    u = element.rigid(q, np.array(given["initial_state"]["w0"]), np.zeros(3))
    row = given["reference"]["rows"][0]
    free = np.setdiff1d(np.arange(element.n_speeds), [3, 4, 5])
    late, speeds = (x[-1] for x in simulate(element, q, u, [row["t"]], free, rtol=1e-9))
    k = element.kinematics(late)
    np.testing.assert_allclose(late[11:14], row["tip"], atol=1e-9)
    np.testing.assert_allclose(k.z[6:9], row["local_tip_displacement"], atol=1e-9)
    np.testing.assert_allclose(k.z[9:12], row["local_tip_rotation"], atol=1e-9)
    np.testing.assert_allclose(k.turn, row["R0"], atol=1e-8)
    np.testing.assert_allclose(np.abs(k.z[12:]), np.abs(row["eta"]), atol=1e-9)
    np.testing.assert_allclose(element.energy(late, speeds), element.energy(q, u), atol=1e-6)


def test_a_slider_crank_with_a_flexible_rod_moves_as_known() -> None:
    given = reference("slider_crank_superelement_A")
    data, row = given["parameters"], given["reference"]["rows"][0]
    crank, rod, rate_of_crank = data["crank"], data["rod"], data["Omega"]
    M, K, nodes = planar_beam(rod, data["elements"], data["EA"], data["EI"], data["rhoA"])
    record = cd.superelement.reduce(
        M, K, nodes, {"pin": 0, "slider": 16}, node_dofs="x y rz", modes=data["cb_modes"]
    )
    slider = Hub(data["slider_mass"], np.zeros((3, 3)), np.zeros(3))
    element = Corotational.of(record, "chord", hubs={1: slider})
    q = element.start(origin=np.array([crank, 0.0, 0.0]))
    # the pin moves across the rod, which turns about the slider
    u = element.rigid(
        q, -crank * rate_of_crank / rod * Z_AXIS, np.array([0.0, crank * rate_of_crank, 0.0])
    )
    u[3:6] = 0.0, crank * rate_of_crank, 0.0
    u[9:12] = 0.0
    free = np.array([2, 8, 9, 12, 13])

    def driven(t: float) -> Any:
        result = np.zeros(element.n_speeds)
        result[3:5] = (
            -crank
            * rate_of_crank**2
            * np.array([np.cos(rate_of_crank * t), np.sin(rate_of_crank * t)])
        )
        return result

    late, _ = simulate(element, q, u, [row["t"]], free, driven, rtol=1e-9)
    z = element.kinematics(late[-1]).z
    np.testing.assert_allclose(z[[2, 5]], [row["theta1"], row["theta2"]], atol=1e-6)
    np.testing.assert_allclose(z[3] - z[0], row["elongation"], atol=1e-8)
    np.testing.assert_allclose(np.abs(z[6:]), np.abs(row["eta"]), atol=1e-8)
    np.testing.assert_allclose(late[-1][11], row["slider"], atol=1e-8)
