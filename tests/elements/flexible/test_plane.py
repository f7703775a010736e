"""Elements in a plane: the kernels of the plane are those of space where nothing leaves it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cardan.ir.interpreter import evaluate
from elements.flexible.states import ELEMENTS, quaternion
from table import each

# in space and in the plane
KINDS = {
    ("node", "node"): ("plane_node", "plane_node"),
    ("offset", "node"): ("plane_offset", "plane_node"),
    ("offset", "offset"): ("plane_offset", "plane_offset"),
    ("ground", "offset"): ("plane_ground", "plane_offset"),
}
BETWEEN = [1.1, 0.2, 0.0]
POSES = ((0.7, np.array([0.3, -0.2, 0.0])), (1.3, np.array([1.2, 0.5, 0.0])))
FRAMES = ((-0.4, np.array([0.1, 0.2, 0.0])), (0.5, np.array([-0.3, 0.1, 0.0])))
# x, y, angle among the speeds of a node in space
INSIDE = [3, 4, 2]
NUMBERS = {"EA": 70.0, "GA2": 30.0, "GA3": 20.0, "K3": 0.2, "E1": 1.0, "E2": 0.05}
NUMBERS |= {"strain_3": 0.1, "strain_4": 0.02, "strain_5": -0.03, "theta3": 0.2}
OUTSIDE = ("K1", "K2", "E3", "theta1", "theta2", "e3", "strain_1", "strain_2", "strain_6")


def about_z(angle: float) -> Rotation:
    return Rotation.from_rotvec([0, 0, angle])


class Pair:
    """An element at one state, in space and in the plane."""

    def __init__(self, name: str, kinds: tuple[str, str]) -> None:
        self.element, self.kinds = ELEMENTS[name], (kinds, KINDS[kinds])
        self.functions = [dict(self.element.derived(own)) for own in self.kinds]
        self.numbers = self._numbers()
        rng = np.random.default_rng(4)
        self.moving = [k for k, kind in enumerate(kinds) if kind != "ground"]
        space = [np.r_[quaternion(about_z(POSES[k][0])), POSES[k][1]] for k in self.moving]
        flat = [np.r_[POSES[k][1][:2], POSES[k][0]] for k in self.moving]
        self.at: list[dict[str, Any]] = [{"q": np.concatenate(q)} for q in (space, flat)]
        n = len(self.moving)
        for letter in ("u", "udot"):
            rates = rng.normal(size=(n, 3))
            full = np.zeros((n, 6))
            full[:, INSIDE] = rates
            self.at[0][letter], self.at[1][letter] = full.ravel(), rates.ravel()

    def _numbers(self) -> dict[str, float]:
        rng = np.random.default_rng(5)
        names = {name for kinds in self.kinds for name in self.element.data(kinds)}
        found = {name: float(rng.uniform(0.5, 1.5)) for name in sorted(names)} | NUMBERS
        found |= dict.fromkeys(OUTSIDE, 0.0)
        for end, (angle, p) in zip(("start", "end"), FRAMES, strict=True):
            R = about_z(angle).as_matrix()
            found |= {f"{end}_R{i + 1}{j + 1}": R[i, j] for i in range(3) for j in range(3)}
            found |= {f"{end}_p{x}": p[k] for k, x in enumerate("xyz")}
            found |= {f"{end}_x": p[0], f"{end}_y": p[1], f"{end}_angle": angle}
        return found

    def values(self, function: str, **more: Any) -> list[dict[str, Any]]:
        """Results in space and in the plane."""
        found = []
        for kinds, at, functions in zip(self.kinds, self.at, self.functions, strict=True):
            p = [self.numbers[name] for name in self.element.data(kinds)]
            found.append(evaluate(functions[function], {**at, "p": p, **more}))
        return found


@each("name", ELEMENTS)
@each("kinds", KINDS)
def test_the_plane_is_a_part_of_space(name: str, kinds: tuple[str, str]) -> None:
    pair = Pair(name, kinds)
    inside = [6 * k + i for k in range(len(pair.moving)) for i in INSIDE]
    n = len(pair.moving)
    space, flat = (np.array(x["balance"]) for x in pair.values("balance"))
    assert flat == pytest.approx(space[inside], abs=1e-12)
    space_of, flat_of = pair.values("balance_tangent")
    for letter in "KCM":
        whole = np.reshape(space_of.get(letter, np.zeros(36 * n * n)), (6 * n, 6 * n))
        part = np.reshape(flat_of.get(letter, np.zeros(9 * n * n)), (3 * n, 3 * n))
        assert part == pytest.approx(whole[np.ix_(inside, inside)], abs=1e-12)
    for function in ("energy", "momentum", "stress", "power"):
        if function in pair.functions[0]:
            found, wanted = (x[function] for x in pair.values(function))
            assert wanted == pytest.approx(found, abs=1e-12)


@pytest.mark.parametrize("name", ["hellinger_reissner", "helicoidal", "classical"])
def test_stress_as_unknown(name: str) -> None:
    pair = Pair(name, ("node", "node"))
    z = [0.0, 0.0, 0.3, 1.2, -0.4, 0.0]
    space, flat = pair.values("mixed", z=z)
    inside = [6 * k + i for k in range(2) for i in INSIDE]
    assert flat["balance"] == pytest.approx(np.array(space["balance"])[inside], abs=1e-12)
    K = np.reshape(space["K"], (12, 12))[np.ix_(inside, inside)]
    assert np.reshape(flat["K"], (6, 6)) == pytest.approx(K, abs=1e-12)


def test_the_plane_is_cheap() -> None:
    """A fifth of the operations of space, and no polynomial of the rotation vector."""
    pair = Pair("hellinger_reissner", ("node", "node"))
    space, flat = (functions["balance_tangent"] for functions in pair.functions)
    assert sum(flat.operations().values()) < 0.25 * sum(space.operations().values())
