"""Energies and stresses of flexible elements, by quadrature along their shapes.

Everything here is written down once more, in plain numbers and by another route than in the
catalogue: poses between the ends by exponentials of matrices, strains by differences of these,
masses as a fine row of points.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapter 6; Sonneville, Cardona and
Brüls, CMAME 268 (2014) for the helix between two poses.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ..differences import REACH, central
from ..joint_motion import Array
from ..rotations import axial, cross_matrix, quaternion, rotation_vector, vector_of

Data = Mapping[str, Array]
STIFFNESS = ("GJ", "EI2", "EI3", "EA", "GA2", "GA3")
SHAPE = ("K1", "K2", "K3", "E1", "E2", "E3")
# of the rule of Gauss and Legendre along an element; exact for masses, whose shape is cubic
POINTS, WEIGHTS = (np.asarray(x) / 2 for x in np.polynomial.legendre.leggauss(6))
GAUSS = list(zip(*(x / 2 for x in np.polynomial.legendre.leggauss(10)), strict=True))


def _poses(q: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Rotations and positions of both ends of one element."""
    both = quaternion(np.stack([q[:4], q[7:11]]))
    return (both[0], q[4:7]), (both[1], q[11:14])


def _helix(q: Array, length: float) -> Array:
    """Strain (6,) of the helix between two poses, from differences of poses along it."""
    (R1, x1), (R2, x2) = _poses(q)
    relative = np.eye(4)
    relative[:3, :3], relative[:3, 3] = R1.T @ R2, R1.T @ (x2 - x1)
    turn = vector_of(relative[:3, :3])
    # the screw whose exponential leads from one end to the other
    angle = float(np.linalg.norm(turn))
    a = cross_matrix(turn)
    square = 1 / 12 if angle < 1e-4 else (1 - angle / 2 / np.tan(angle / 2)) / angle**2
    along = (np.eye(3) - a / 2 + square * a @ a) @ relative[:3, 3]

    def pose(s: float) -> tuple[Array, Array]:
        # the place is the integral of the axes along the way
        steps = [rotation_vector(s * (a + 0.5) * turn) @ along * w for a, w in GAUSS]
        return rotation_vector(s * turn), np.sum(steps, axis=0) * s

    # strain measures at one place, by differences of eighth order
    h = 0.05
    ahead, behind = ([pose(0.4 + side * h * k) for k in REACH] for side in (1, -1))
    dR, dx = (
        central(np.array([one[part] for one in ahead]), np.array([one[part] for one in behind])) / h
        for part in (0, 1)
    )
    R = pose(0.4)[0]
    return np.concatenate([axial(R.T @ dR), R.T @ dx]) / length


def _mean(q: Array, length: float) -> Array:
    """Strain (6,) in axes halfway between the ends."""
    (R1, x1), (R2, x2) = _poses(q)
    turn = vector_of(R1.T @ R2)
    halfway = R1 @ rotation_vector(turn / 2)
    return np.asarray(np.concatenate([turn, halfway.T @ (x2 - x1)]) / length)


def _free(data: Data, k: int) -> Array:
    """Strain without stress."""
    measures = [data[name][k] for name in SHAPE]
    thermal = [data[f"strain_{i}"][k] for i in range(1, 7)]
    return np.asarray(np.array(measures) + np.array(thermal))


def _each(q: Array, of: Callable[[int], Array]) -> Array:
    return np.stack([of(k) for k in range(len(q))])


def _uniform(strain: Callable[[Array, float], Array], soft: bool) -> Callable[..., Array]:
    """Energy of a strain that is the same all along."""

    def energy(q: Array, u: Array, data: Data) -> Array:
        def one(k: int) -> Array:
            length = float(data["length"][k])
            y = strain(q[k], length) - _free(data, k)
            stored = WEIGHTS.sum() * length * y @ (_stiffness(data, k, soft) * y) / 2
            return np.array([0.0, stored])

        return _each(q, one)

    return energy


def _stiffness(data: Data, k: int, soft: bool) -> Array:
    diagonal = np.array([data[name][k] for name in STIFFNESS])
    if soft:
        square = float(data["length"][k]) ** 2
        diagonal[4] = 1 / (1 / diagonal[4] + square / 12 / diagonal[2])
        diagonal[5] = 1 / (1 / diagonal[5] + square / 12 / diagonal[1])
    return diagonal


def _field(q: Array, data: Data, k: int) -> tuple[Array, Array, Array]:
    """Strain, stress of the middle and its change along an element whose stress is in equilibrium.

    The complementary energy is stationary in the stress of the middle: six equations.
    """
    length = float(data["length"][k])
    strain = _helix(q[k], length)
    K, E = strain[:3], strain[3:]
    c = 1 / np.array([data[name][k] for name in STIFFNESS])
    # m' = -K x m - E x n, n' = -K x n at the stress of the middle
    A = (
        np.block([[cross_matrix(K), cross_matrix(E)], [np.zeros((3, 3)), cross_matrix(K)]])
        * -length
    )
    F = np.zeros((6, 6))
    for x, w in zip(POINTS, WEIGHTS, strict=True):
        along = np.eye(6) + x * A
        F += w * along.T @ (c[:, None] * along)
    y = strain - _free(data, k)
    s = np.linalg.solve(F, y)
    return y, s, A @ s


def _energy_hellinger_reissner(q: Array, u: Array, data: Data) -> Array | None:
    """Energy of a stress in equilibrium along the helix; None with loads."""
    if any(name.startswith("dead_force") for name in data):
        return None

    def one(k: int) -> Array:
        _, s, change = _field(q, data, k)
        c = 1 / np.array([data[name][k] for name in STIFFNESS])
        stored = sum(
            w * (s + x * change) @ (c * (s + x * change))
            for x, w in zip(POINTS, WEIGHTS, strict=True)
        )
        return np.array([0.0, float(data["length"][k]) * stored / 2])

    return _each(q, one)


def _stress_hellinger_reissner(q: Array, data: Data) -> Array | None:
    """Stress and strain at both ends."""
    if any(name.startswith("dead_force") for name in data):
        return None

    def one(k: int) -> Array:
        _, s, change = _field(q, data, k)
        c = 1 / np.array([data[name][k] for name in STIFFNESS])
        ends = np.stack([s - change / 2, s + change / 2])
        return np.concatenate([ends, ends * c])

    return _each(q, one)


def _stress_uniform(strain: Callable[[Array, float], Array], soft: bool) -> Callable[..., Array]:
    def stress(q: Array, data: Data) -> Array:
        def one(k: int) -> Array:
            y = strain(q[k], float(data["length"][k])) - _free(data, k)
            s = _stiffness(data, k, soft) * y
            return np.stack([s, s, y, y])

        return _each(q, one)

    return stress


# masses


def _ends(q: Array, u: Array, k: int) -> tuple[Array, ...]:
    """Positions, velocities, rotations and angular velocities of both ends."""
    (R1, x1), (R2, x2) = _poses(q[k])
    parts = u[k].reshape(2, 2, 3)
    return np.stack([x1, x2]), parts[:, 1], np.stack([R1, R2]), parts[:, 0]


def quaternion_of(r: Array) -> Array:
    """Unit quaternions (n, 4) of rotations (n, 3, 3)."""

    def one(m: Array) -> Array:
        # the eigenvector of the largest eigenvalue, after Bar-Itzhack
        K = np.zeros((4, 4))
        K[0, 0], K[1:, 1:] = np.trace(m), m + m.T - np.trace(m) * np.eye(3)
        K[0, 1:] = K[1:, 0] = 2 * axial(m)
        vector = np.linalg.eigh(K)[1][:, -1]
        return np.asarray(vector if vector[0] >= 0 else -vector)

    return np.stack([one(m) for m in r])


Lump = tuple[float, Array, Array, Array, Array]


def _mass_points(q: Array, u: Array, data: Data, k: int) -> list[Lump]:
    """Points along the cubic with turning sections.

    Mass, place and velocity, twice the energy of the turning by axes, its angular momentum.
    """
    (x, v, R, w), length = _ends(q, u, k), float(data["length"][k])
    tangents = length * R[:, :, 0]
    end_rates = length * np.stack([R[i] @ np.cross(w[i], [1.0, 0, 0]) for i in range(2)])
    share, spin, points = _share(data, k), _spin(data, k), list[Lump]()
    for z, weight in zip(POINTS, WEIGHTS, strict=True):
        place, rate = (_cubic(z, a, b, share) for a, b in ((x, tangents), (v, end_rates)))
        near = np.array([0.5 - z, 0.5 + z])
        omega, mass = near @ w, weight * length
        # angular velocities vary in section axes, those of either end
        angular_momentum = sum(near[i] * R[i] @ (spin * omega) for i in range(2)) * mass
        points.append(
            (mass * data["rhoA"][k], place, rate, omega * spin * omega * mass, angular_momentum)
        )
    return points


def _lumps_of(q: Array, u: Array, data: Data, k: int) -> list[Lump]:
    """Half of the mass at either end."""
    x, v, R, w = _ends(q, u, k)
    half, spin = float(data["length"][k]) / 2, _spin(data, k)
    return [
        (half * data["rhoA"][k], x[i], v[i], half * w[i] * spin * w[i], R[i] @ (half * spin * w[i]))
        for i in range(2)
    ]


def _spin(data: Data, k: int) -> Array:
    """Moments of inertia per length about the axes of the section."""
    second, third = (data[name][k] for name in ("rhoI2", "rhoI3"))
    return np.array([second + third, second, third])


def _energies(points: Callable[..., list[Lump]]) -> Callable[..., Array]:
    """Kinetic and potential energy of points."""

    def energy(q: Array, u: Array, data: Data) -> Array:
        def one(k: int) -> Array:
            energies, g = np.zeros(2), _gravity(data, k)
            for mass, place, rate, spin_energy, _ in points(q, u, data, k):
                energies += [(mass * rate @ rate + spin_energy.sum()) / 2, -mass * g @ place]
            return energies

        return _each(q, one)

    return energy


def _momenta(points: Callable[..., list[Lump]]) -> Callable[..., Array]:
    """Angular momentum about the origin of the ground and momentum of points."""

    def momentum(q: Array, u: Array, data: Data) -> Array:
        def one(k: int) -> Array:
            parts = [
                np.concatenate([np.cross(place, mass * rate) + angular_momentum, mass * rate])
                for mass, place, rate, _, angular_momentum in points(q, u, data, k)
            ]
            return np.asarray(np.sum(parts, axis=0))

        return _each(q, one)

    return momentum


def _central(points: Callable[..., tuple[Array, ...]]) -> Callable[..., Array]:
    """Potential energy of halves of the mass at points in the field of a center on the ground."""

    def energy(q: Array, u: Array, data: Data) -> Array:
        def one(k: int) -> Array:
            center = np.array([data[f"center_p{x}"][k] for x in "xyz"])
            strength = data["mu"][k] * data["rhoA"][k] * data["length"][k] / 2
            distances = [np.linalg.norm(place - center) for place in points(q, data, k)]
            return np.array([0.0, -strength * sum(1 / distance for distance in distances)])

        return _each(q, one)

    return energy


def _gauss(q: Array, data: Data, k: int) -> tuple[Array, ...]:
    """The line of :func:`_mass_points` at the two points of Gauss."""
    (x, _, R, _), length = _ends(q, np.zeros_like(q[:, :12]), k), float(data["length"][k])
    places = np.polynomial.legendre.leggauss(2)[0] / 2
    return tuple(_cubic(z, x, length * R[:, :, 0], _share(data, k)) for z in places)


def _share(data: Data, k: int) -> float:
    """Share of the cubic in the shape: less where shear is soft."""
    soft = data["EI2"][k] / data["GA3"][k] + data["EI3"][k] / data["GA2"][k]
    return float(1 / (1 + 6 * soft / data["length"][k] ** 2))


def _cubic(z: float, ends: Array, tangents: Array, share: float) -> Array:
    """Line between two ends, the parabola of their tangents, and a share of the cubic."""
    chord, mean = ends[1] - ends[0], tangents.mean(axis=0)
    line = ends.mean(axis=0) + z * chord + (z * z - 0.25) / 2 * (tangents[1] - tangents[0])
    return np.asarray(line + share * (mean - chord) * (4 * z**3 - z) / 2)


def _gravity(data: Data, k: int) -> Array:
    return np.array([data[f"gravity_{i}"][k] for i in (1, 2, 3)])


ENERGIES: dict[str, Callable[[Array, Array, Data], Array | None]] = {
    "hellinger_reissner": _energy_hellinger_reissner,
    "helicoidal": _uniform(_helix, soft=False),
    "classical": _uniform(_mean, soft=True),
    "classical_plain": _uniform(_mean, soft=False),
    "linked_inertia": _energies(_mass_points),
    "lumped_inertia": _energies(_lumps_of),
    "gravity_field_central_gravity": _central(_gauss),
    "gravity_field_central_gravity_lumped": _central(lambda q, data, k: (q[k, 4:7], q[k, 11:14])),
}
MOMENTA: dict[str, Callable[[Array, Array, Data], Array]] = {
    "linked_inertia": _momenta(_mass_points),
    "lumped_inertia": _momenta(_lumps_of),
}
STRESSES: dict[str, Callable[[Array, Data], Array | None]] = {
    "hellinger_reissner": _stress_hellinger_reissner,
    "helicoidal": _stress_uniform(_helix, soft=False),
    "classical": _stress_uniform(_mean, soft=True),
    "classical_plain": _stress_uniform(_mean, soft=False),
}
