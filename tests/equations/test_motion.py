"""Velocities, accelerations, energy and reactions against differences in 40 digits."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from cardan.equations.record import EquationRecord
from cardan.ir.interpreter import evaluate

from .trees import TREES, Tree, state

mpmath = pytest.importorskip("mpmath")
# step of central differences in 40 digits: truncation h^2, rounding 1e-40/h
STEP, BOUND = mpmath.mpf("1e-12"), mpmath.mpf("1e-20")


@pytest.fixture(autouse=True)
def forty_digits() -> Iterator[None]:
    """All arithmetic of a test, not only that of the interpreter."""
    with mpmath.workdps(40):
        yield


class Exact:
    """Functions of a tree in 40 digits, on a straight path through a state."""

    def __init__(self, tree: Tree, seed: int) -> None:
        self.tree, self.equations = tree, EquationRecord(tree.system, "composite")
        values = state(tree.system, seed)
        self.base = {name: [mpmath.mpf(x) for x in xs] for name, xs in values.items()}
        self.base["p"] = [mpmath.mpf(x.numerator) / x.denominator for x in tree.exact]
        for joint in tree.system.joints:
            if joint.element.quaternion is not None:
                self._normalize(joint.q + joint.element.quaternion)

    def _normalize(self, at: int) -> None:
        """A quaternion of doubles is a unit quaternion to 16 digits only."""
        own = self.base["q"][at : at + 4]
        norm = mpmath.sqrt(sum(x * x for x in own))
        self.base["q"][at : at + 4] = [x / norm for x in own]
        self.base["q0"] = list(self.base["q"])

    def __call__(self, name: str, of: str | None = None, **given: Any) -> list[Any]:
        function = self.equations.function(name, of)
        result = evaluate(function, {**self.base, **given}, arithmetic="mp", digits=40)
        flat: list[Any] = []
        for output in function.outputs:
            value = result[output.name]
            flat += list(value) if isinstance(value, list) else [value]
        return flat

    def rate(self, name: str, of: str | None = None, **rates: list[Any]) -> list[Any]:
        """Derivative of a function along given rates of its inputs."""
        ends = []
        for sign in (1, -1):
            moved = {
                block: [x + sign * STEP * d for x, d in zip(self.base[block], rate, strict=True)]
                for block, rate in rates.items()
            }
            ends.append(self(name, of, **moved))
        return [(a - b) / (2 * STEP) for a, b in zip(*ends, strict=True)]


def close(a: list[Any], b: list[Any]) -> bool:
    scale = max(1, *(abs(x) for x in b))
    return max(abs(x - y) for x, y in zip(a, b, strict=True)) <= BOUND * scale


def column(pose: list[Any], j: int) -> list[Any]:
    return [pose[4 * i + j] for i in range(3)]


@pytest.mark.parametrize("name", TREES)
def test_velocity_is_the_rate_of_the_pose(name: str) -> None:
    exact = Exact(TREES[name], 11)
    for i in range(len(exact.tree.system.bodies)):
        rates = exact.rate("pose", f"tip{i}", q=exact("qdot"))
        pose, velocity = exact("pose", f"tip{i}"), exact("velocity", f"tip{i}")
        assert close(column(rates, 3), velocity[3:])
        # every axis of the frame turns with omega: e' = omega x e
        wx, wy, wz = velocity[:3]
        for j in range(3):
            x, y, z = column(pose, j)
            turned = [wy * z - wz * y, wz * x - wx * z, wx * y - wy * x]
            assert close(column(rates, j), turned)


@pytest.mark.parametrize("name", TREES)
def test_acceleration_is_the_rate_of_the_velocity(name: str) -> None:
    exact = Exact(TREES[name], 12)
    for i in range(len(exact.tree.system.bodies)):
        rates = exact.rate("velocity", f"tip{i}", q=exact("qdot"), u=exact.base["udot"])
        assert close(rates, exact("acceleration", f"tip{i}"))


@pytest.mark.parametrize("name", TREES)
def test_jacobian_times_speeds_is_the_velocity(name: str) -> None:
    exact, nu = Exact(TREES[name], 13), TREES[name].system.nu
    frame = f"tip{len(TREES[name].system.bodies) - 1}"
    jacobian, u = exact("frame_jacobian", frame), exact.base["u"]
    product = [sum(jacobian[nu * i + j] * u[j] for j in range(nu)) for i in range(6)]
    assert close(product, exact("velocity", frame))


@pytest.mark.parametrize("name", TREES)
def test_energy_changes_by_the_power_of_tau(name: str) -> None:
    exact = Exact(TREES[name], 14)
    udot = exact("forward_dynamics")
    rate = exact.rate("energy", q=exact("qdot"), u=udot)
    power = sum(f * u for f, u in zip(exact.base["tau"], exact.base["u"], strict=True))
    assert close([rate[2]], [power])


@pytest.mark.parametrize("name", TREES)
def test_reactions_at_the_ground_change_the_momentum(name: str) -> None:
    """Free-body diagram of everything: ground reactions and weight against rate of momentum."""
    exact, system = Exact(TREES[name], 15), TREES[name].system
    udot = exact("forward_dynamics")
    rate = exact.rate("momentum", q=exact("qdot"), u=udot)
    mass = sum(exact.base["p"][system.graph.nodes[b.mass][2]] for b in system.bodies)
    gravity = [exact.base["p"][system.graph.nodes[n][2]] for n in system.gravity]
    com = exact("com")
    weight = [mass * g for g in gravity]
    total = [*cross(com, weight), *weight]
    for i, body in enumerate(system.bodies):
        if body.parent < 0:
            moment, force = in_ground(exact("pose", f"body{i}"), exact("reaction", f"joint{i}"))
            total = [a + b for a, b in zip(total, [*moment, *force], strict=True)]
    assert close(total, rate)


def cross(a: list[Any], b: list[Any]) -> list[Any]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def in_ground(pose: list[Any], wrench: list[Any]) -> tuple[list[Any], list[Any]]:
    """A wrench at a frame in its axes as moment about the ground origin and force."""

    def turned(v: list[Any]) -> list[Any]:
        return [sum(pose[4 * i + j] * v[j] for j in range(3)) for i in range(3)]

    force = turned(wrench[3:])
    moment = [a + b for a, b in zip(turned(wrench[:3]), cross(column(pose, 3), force), strict=True)]
    return moment, force


@pytest.mark.parametrize("name", TREES)
def test_difference_undoes_integrate(name: str) -> None:
    exact = Exact(TREES[name], 16)
    step = [x / 10 for x in exact.base["du"]]
    moved = exact("integrate", du=step)
    assert close(exact("difference", q0=exact.base["q"], q=moved), step)
