"""What every flexible element must do, whatever it is made of."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from elements.flexible.states import ELEMENTS, ENDS, State, state

# numbers of order one, a few hundred operations, stiffnesses up to 100
ROUNDING = 2e-12
STRAINED = [name for name, element in ELEMENTS.items() if "stress" in element.derived()]
MASSIVE = [name for name, element in ELEMENTS.items() if "momentum" in element.derived()]
both = pytest.mark.parametrize("kinds", ENDS, ids="-".join)
every = pytest.mark.parametrize("name", ELEMENTS)
strained = pytest.mark.parametrize("name", STRAINED)
massive = pytest.mark.parametrize("name", MASSIVE)
TURN, SHIFT = Rotation.from_rotvec([1.2, -2.0, 0.7]), np.array([3.0, -1.0, 2.0])
WEIGHTLESS = {f"gravity_{k}": 0.0 for k in (1, 2, 3)}
# loads that keep their direction do not turn with an element
UNLOADED = dict.fromkeys((*(f"dead_force_{k}" for k in (1, 2, 3)), "rhoA"), 0.0)
SHAPED = {f"strain_{k}": 0.0 for k in range(1, 7)}


def matrix(s: State, name: str, function: str = "balance_tangent", **blocks: Any) -> Any:
    """A tangent; what is left out is zero."""
    n = len(s.u)
    if not s.has(function, name):
        return np.zeros((n, n))
    return s.value(function, name, **blocks).reshape(n, n)


@every
@both
def test_tangents_are_the_derivatives_of_the_balance(name: str, kinds: tuple[str, str]) -> None:
    s = state(ELEMENTS[name], kinds)
    for letter, block in (("K", "q"), ("C", "u"), ("M", "udot")):

        def at(x: Any, block: str = block) -> Any:
            return s.value("balance", "balance", **{block: x})

        assert matrix(s, letter) == pytest.approx(s.along(at, block), abs=ROUNDING)


@every
@both
def test_forces_follow_from_energy_and_power(name: str, kinds: tuple[str, str]) -> None:
    s = state(ELEMENTS[name], kinds)
    rest, slope = np.zeros(len(s.u)), np.zeros(len(s.u))
    if "energy" in s.functions:
        slope = s.along(lambda q: s.value("energy", "energy", q=q, u=rest)[1])
    # what has no potential says its power at any speeds
    driven = s.value("power", "power")[0] if "power" in s.functions else 0.0
    forces = s.value("balance", "balance", u=rest if driven == 0 else s.u, udot=rest)
    if driven:
        assert (slope - forces) @ s.u == pytest.approx(driven, abs=ROUNDING)
    else:
        assert forces == pytest.approx(slope, abs=ROUNDING)


@strained
@pytest.mark.parametrize("turn", [(0.3, -0.5, 0.4), (0.0, 0.0, 0.0), (2.0, -1.5, 1.7)])
def test_a_rigid_motion_turns_forces_and_leaves_stress(
    name: str, turn: tuple[float, float, float]
) -> None:
    s = state(ELEMENTS[name], turn=turn, **UNLOADED)
    moved = s.turned(TURN, SHIFT)
    b, stress = s.value("balance", "balance"), s.value("stress", "stress")
    wanted = b.reshape(4, 3).copy()
    wanted[1::2] = TURN.apply(wanted[1::2])
    assert moved.value("balance", "balance") == pytest.approx(wanted.ravel(), abs=1e2 * ROUNDING)
    assert moved.value("stress", "stress") == pytest.approx(stress, abs=1e2 * ROUNDING)
    assert moved.value("energy", "energy") == pytest.approx(s.value("energy", "energy"))


@strained
def test_forces_of_an_element_are_in_equilibrium(name: str) -> None:
    s = state(ELEMENTS[name], **UNLOADED)
    assert total(s, s.value("balance", "balance")) == pytest.approx(np.zeros(6), abs=ROUNDING)


@strained
def test_rigid_motions_of_the_reference_shape_need_no_force(name: str) -> None:
    follower = {f"follower_force_{k}": 0.0 for k in (1, 2, 3)}
    s = state(ELEMENTS[name], **SHAPED, **UNLOADED, **follower)
    # the data of a reference shape that is this very pose
    shape = s.element.rows([0.0, s.numbers.get("length", 1.0)], s.q[None])[0]
    numbers = s.numbers | dict(zip(s.element.geometric, shape, strict=True))
    for turn in (Rotation.identity(), TURN, Rotation.from_rotvec([0, 0, 3.0])):
        moved = State(**{**vars(s), "numbers": numbers}).turned(turn, SHIFT)
        assert moved.value("balance", "balance") == pytest.approx(np.zeros(12), abs=ROUNDING)
        # and its tangent has the six rigid modes
        sizes = np.linalg.svd(matrix(moved, "K"), compute_uv=False)
        assert sizes[5] > 1e-2
        assert sizes[6] < ROUNDING


@strained
def test_tangents_are_symmetric_but_for_the_moments(name: str) -> None:
    s = state(ELEMENTS[name])
    K, b = matrix(s, "K"), s.value("balance", "balance")
    for k in (0, 6):
        K[k : k + 3, k : k + 3] -= 0.5 * np.cross(np.eye(3), b[k : k + 3])
    assert pytest.approx(K.T, abs=ROUNDING) == K


@massive
@both
def test_power_of_inertia_is_the_rate_of_its_energy(name: str, kinds: tuple[str, str]) -> None:
    s = state(ELEMENTS[name], kinds)
    rate, h = s.rate(s.u), 1e-30
    moved = s.value("energy", "energy", q=s.q + 1j * h * rate, u=s.u + 1j * h * s.udot)
    assert s.value("balance", "balance") @ s.u == pytest.approx(sum(moved).imag / h, abs=ROUNDING)


@massive
def test_forces_of_inertia_are_the_rate_of_its_momentum(name: str) -> None:
    s = state(ELEMENTS[name], **WEIGHTLESS)
    h = 1e-30
    moved = s.value("momentum", "momentum", q=s.q + 1j * h * s.rate(s.u), u=s.u + 1j * h * s.udot)
    assert total(s, s.value("balance", "balance")) == pytest.approx(moved.imag / h, abs=ROUNDING)


@both
def test_damping_takes_energy(kinds: tuple[str, str]) -> None:
    s = state(ELEMENTS["damping"], kinds)
    assert s.value("power", "power")[0] < 0
    assert s.value("balance", "balance", u=0 * s.u) == pytest.approx(0 * s.u)


@massive
def test_mass_is_that_of_the_beam(name: str) -> None:
    s = state(ELEMENTS[name])
    M, mass = matrix(s, "M"), s.numbers["rhoA"] * s.numbers["length"]
    shift = np.tile([0, 0, 0, 1, 0, 0], 2)
    assert pytest.approx(M.T, abs=ROUNDING) == M
    assert np.linalg.eigvalsh(M)[0] > 0
    assert shift @ M @ shift == pytest.approx(mass)
    rest = s.value("balance", "balance", u=0 * s.u, udot=0 * s.u).reshape(4, 3)
    weight = mass * np.array([s.numbers[f"gravity_{k}"] for k in (1, 2, 3)])
    assert rest[1] + rest[3] == pytest.approx(-weight)


def total(s: State, b: Any) -> Any:
    """Moment about the origin of the ground and force of what acts on the nodes of two ends."""
    parts = b.reshape(4, 3)
    force, moment = np.zeros(3), np.zeros(3)
    for (R, p), own, f in zip(s.poses, parts[::2], parts[1::2], strict=True):
        force, moment = force + f, moment + R.apply(own) + np.cross(p, f)
    return np.concatenate([moment, force])
