"""Independent values of what names in the C of a beam say."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from codegen.named_values import CELLS, Array, Values, factors, skew

STRAINS, STRESSES = ("K1", "K2", "K3", "E1", "E2", "E3"), ("m1", "m2", "m3", "n1", "n2", "n3")
STIFFNESS = ("GJ", "EI2", "EI3", "EA", "GA2", "GA3")
BLOCKS = [f"{i}_{j}" for i in range(1, 7) for j in range(1, 7)]


@dataclass(frozen=True)
class Beam:
    """Energy of :class:`.HellingerReissner` as a function of theta and d.

    Attributes:
        c: Compliance of the element (6,).
        free: Strain without stress (6,).
    """

    c: Array
    free: Array

    @staticmethod
    def carried(theta: Array) -> Array:
        """U: e = U d."""
        half = np.sqrt(theta @ theta) / 2
        a = (1 - half / np.tan(half)) / (theta @ theta)
        return np.eye(3) - skew(theta) / 2 + a * skew(theta) @ skew(theta)

    @staticmethod
    def change(theta: Array, e: Array) -> Array:
        """A: what the stress loses from end to end, by the stress (6, 6)."""
        return np.block([[skew(theta), skew(e)], [np.zeros((3, 3)), skew(theta)]])

    def flexibility(self, theta: Array, e: Array) -> Array:
        A = self.change(theta, e)
        return np.diag(self.c) + A.T @ np.diag(self.c / 12) @ A

    def strain(self, theta: Array, e: Array) -> Array:
        return np.concatenate([theta, e]) - self.free

    def energy(self, theta: Array, e: Array) -> complex:
        y = self.strain(theta, e)
        return complex(y @ np.linalg.solve(self.flexibility(theta, e), y) / 2)


def slope(f: Callable[[Array], complex], x: Array) -> Array:
    """By complex steps."""
    return np.array([f(x + 1e-20j * unit).imag for unit in np.eye(3)]) / 1e-20


def beam(q: Array, data: dict[str, float]) -> Values:
    """What names say at the poses q (14,) of the ends."""
    length = data["length"]
    free = length * np.array([data[k] + data[f"strain_{i + 1}"] for i, k in enumerate(STRAINS)])
    law = Beam(length / np.array([data[k] for k in STIFFNESS]), free)
    (R1, p1), (R2, p2) = ((_turned(x[:4]), x[4:]) for x in (q[:7], q[7:]))
    relative = Rotation.from_matrix(R1.T @ R2)
    theta, d, short = relative.as_rotvec(), R1.T @ (p2 - p1), np.roll(relative.as_quat(), 1)
    rows = [
        ("start_R", R1, CELLS),
        ("end_R", R2, CELLS),
        ("r", R1.T @ R2, CELLS),
        ("short", short * np.sign(short[0]), "wxyz"),
        ("theta", theta, "xyz"),
        ("apart", p2 - p1, "xyz"),
        ("d", d, "xyz"),
        ("theta_cross_d", np.cross(theta, d), "xyz"),
        ("theta_cross_theta_cross_d", np.cross(theta, np.cross(theta, d)), "xyz"),
        ("theta_skew_squared", skew(theta) @ skew(theta), CELLS),
        ("theta", np.array([theta @ theta]), ["squared"]),
        ("theta_dot", np.array([theta @ d]), "d"),
        ("free", free, STRAINS),
        ("c", np.diag(law.c), BLOCKS),
        ("twelfth", np.diag(law.c) / 12, BLOCKS),
        *_stress(law, theta, d),
        *_loads(law, theta, d, R1, R1.T @ R2),
    ]
    found = {("", f"{name}_{k}"): v for name, x, ks in rows for k, v in _entries(x, ks)}
    F = law.flexibility(theta, law.carried(theta) @ d)
    return found | dict(factors("F", F, STRESSES))


def _stress(law: Beam, theta: Array, d: Array) -> list[tuple[str, Array, Sequence[str]]]:
    """Strain of the element and the stress of its middle."""
    U = law.carried(theta)
    e = U @ d
    F, y = law.flexibility(theta, e), law.strain(theta, e)
    s = np.linalg.solve(F, y)
    t = law.change(theta, e) @ s
    bent = [slope(lambda x, i=i: (law.carried(x) @ d)[i], theta) for i in range(3)]  # type: ignore[misc]
    return [
        ("D", U.T, CELLS),
        ("U", U, CELLS),
        ("e", e, "xyz"),
        ("e_by_theta", np.array(bent), CELLS),
        ("y", y, STRAINS),
        ("F", F, BLOCKS),
        ("s", s, STRESSES),
        ("t", t, STRESSES),
        ("tau", law.c / 12 * t, STRAINS),
    ]


def _loads(
    law: Beam, theta: Array, d: Array, R: Array, r: Array
) -> list[tuple[str, Array, Sequence[str]]]:
    """Slopes of the energy, and what the ends must be held with."""
    U = law.carried(theta)
    by_theta = slope(lambda x: law.energy(x, law.carried(x) @ d), theta)
    by_d = slope(lambda x: law.energy(theta, U @ x), d)
    return [
        ("m", slope(lambda x: law.energy(x, U @ d), theta), "xyz"),
        ("n", slope(lambda x: law.energy(theta, x), U @ d), "xyz"),
        ("by_theta", by_theta, "xyz"),
        ("by_d", by_d, "xyz"),
        ("by_rho", U @ by_theta, "xyz"),
        ("force_on_end", R @ by_d, "xyz"),
        ("moment_on_start", np.cross(by_d, d) - r @ U @ by_theta, "xyz"),
    ]


def _entries(x: Array, components: Sequence[str]) -> list[tuple[str, float]]:
    return list(zip(components, np.ravel(x).tolist(), strict=True))


def _turned(quaternion: Array) -> Array:
    return np.asarray(Rotation.from_quat(np.roll(quaternion, -1)).as_matrix())
