"""Long loops and many loops of rigid bodies, against equations in absolute angles."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd
from mechanisms.closed_planar import (
    G,
    arc_angles,
    hanging_chain,
    parallelogram,
    parallelogram_angles,
)

SPAN = 0.8


def hanging_angles(n: int) -> np.ndarray:
    """Angles of n rods that hang at rest: V = sum W_k sin(a_k) is stationary on the closed loop.

    W_k is the weight that link k carries: half of its own and that of all behind it.
    """
    length = 1 / n
    W = G * length**2 * (n - np.arange(n) - 0.5)
    a, lam = np.array(arc_angles(n, SPAN)), np.array([0.0, -W.mean() / length])
    for _ in range(60):
        c, s = np.cos(a), np.sin(a)
        closing = length * np.stack([-s, c])
        rest = np.concatenate(
            [W * c + closing.T @ lam, [length * c.sum() - SPAN, length * s.sum()]]
        )
        curved = np.diag(-W * s - length * (lam[0] * c + lam[1] * s))
        step = np.linalg.solve(np.block([[curved, closing.T], [closing, np.zeros((2, 2))]]), -rest)
        step *= min(1.0, 0.5 / np.abs(step[:n]).max())
        a, lam = a + step[:n], lam + step[n:]
        if np.abs(step[:n]).max() < 1e-14:
            break
    assert np.abs(rest).max() < 1e-12
    return a


def chain_accelerations(a: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Angular accelerations of n rods in a closed chain, in absolute angles, dense."""
    n = len(a)
    length, k = 1 / n, np.arange(n)
    behind = n - np.maximum.outer(k, k) - 0.5
    np.fill_diagonal(behind, n - 1 - k + 1 / 3)
    away = a[:, None] - a[None, :]
    M = length**3 * behind * np.cos(away)
    force = -(length**3) * (behind * np.sin(away)) @ rates**2
    force -= G * length**2 * (n - k - 0.5) * np.cos(a)
    closing = length * np.stack([-np.sin(a), np.cos(a)])
    gamma = length * np.array([(np.cos(a) * rates**2).sum(), (np.sin(a) * rates**2).sum()])
    system = np.block([[M, closing.T], [closing, np.zeros((2, 2))]])
    return np.linalg.solve(system, np.concatenate([force, gamma]))[:n]


def pins(angles: np.ndarray) -> dict[str, float]:
    """Coordinates of the joints of a chain by absolute angles, or their rates."""
    return {f"pin{k}": x for k, x in enumerate(np.diff(angles, prepend=0.0))}


@pytest.mark.parametrize("links", [20, 200])
def test_a_chain_hangs_as_a_discrete_catenary(links: int) -> None:
    model = cd.compile(hanging_chain(links))
    rest = model.equilibrium(q=pins(np.array(arc_angles(links, SPAN))))
    assert rest.stable
    q = dict(zip(model.coordinates, rest.q, strict=True))
    turned = np.cumsum([q[f"pin{k}"] for k in range(links)])
    np.testing.assert_allclose(turned, hanging_angles(links), rtol=0, atol=1e-9)


@pytest.mark.filterwarnings("ignore:the start of:cardan.SolveWarning")
@pytest.mark.parametrize(
    ("links", "coordinates"), [(12, "relative"), (12, "absolute"), (20, "auto"), (200, "auto")]
)
def test_a_stretched_chain_gives_way(links: int, coordinates: str) -> None:
    """No turn of a joint shortens a line to first order: the search leaves it along a curvature."""
    model = cd.compile(hanging_chain(links, stretched=True), coordinates=coordinates)
    q = model.split(model.initial())[0]
    at = dict(zip(model.coordinates, q, strict=True))
    angles = np.array([at[f"pin{k}"] for k in range(links)])
    c, s = np.cos(np.cumsum(angles)) / links, np.sin(np.cumsum(angles)) / links
    assert abs(c.sum() - SPAN) + abs(s.sum()) < 1e-11
    # nearest to the line: the way there is normal to all positions that close
    along = np.stack([-np.cumsum(s[::-1])[::-1], np.cumsum(c[::-1])[::-1]])
    beside = angles - along.T @ np.linalg.lstsq(along.T, angles)[0]
    # searches end after 80 steps, which 200 joints do not quite do with
    assert np.abs(beside).max() < (1e-6 if links <= 20 else 0.02) * np.abs(angles).max()


@pytest.mark.parametrize("plane", ["auto", None])
def test_accelerations_of_a_chain(plane: str | None) -> None:
    """In a plane and in space, where out-of-plane conditions of the loop are redundant."""
    n = 20
    model = cd.compile(hanging_chain(n), coordinates="absolute", plane=plane)
    a, rng = np.array(arc_angles(n, SPAN)), np.random.default_rng(0)
    closing = np.stack([-np.sin(a), np.cos(a)])
    rates = rng.standard_normal(n)
    rates -= np.linalg.pinv(closing) @ (closing @ rates)
    q, u = model.split(model.initial(pins(a), pins(rates)))
    udot = dict(zip(model.speeds, model.forward_dynamics(q, u), strict=True))
    turning = np.cumsum([udot[f"pin{k}.u"] for k in range(n)])
    expected = chain_accelerations(a, rates)
    np.testing.assert_allclose(turning, expected, rtol=0, atol=1e-10 * np.abs(expected).max())


def lines_of_c(scene: cd.Scene) -> int:
    """Lines of generated C of a scene in the coordinates that are chosen for it."""
    folder = Path(cd.compile(scene).directory)
    return sum(len(file.read_text().splitlines()) for file in folder.glob("*.c"))


def test_code_does_not_grow_with_loops() -> None:
    assert lines_of_c(hanging_chain(20)) == lines_of_c(hanging_chain(60))
    assert lines_of_c(parallelogram(32)) == lines_of_c(parallelogram(64))


def test_coordinates_are_chosen_by_the_loops() -> None:
    """Of what only joint coordinates have, they are taken whatever the loops."""
    long = hanging_chain(20)
    assert "a loop with 20 speeds" in str(cd.derive(long)).splitlines()[0]
    assert "loops with 63 speeds" in str(cd.derive(parallelogram(31))).splitlines()[0]
    assert isinstance(cd.derive(parallelogram(16)), cd.Equations)
    assert isinstance(cd.derive(long, method="composite"), cd.Equations)
    assert isinstance(cd.derive(long, constraints="null_space"), cd.Equations)
    assert not cd.compile(long, functions=["bias"]).manifest.absolute
    assert cd.compile(long, functions=["forward_dynamics"]).manifest.absolute


def crank_angle(windows: int, times: np.ndarray) -> np.ndarray:
    """Angle of all cranks of N four-bars: ((N + 1) / 3 + N) a'' = -g ((N + 1) / 2 + N) cos a."""
    k = G * ((windows + 1) / 2 + windows) / ((windows + 1) / 3 + windows)
    run = solve_ivp(
        lambda t, y: [y[1], -k * np.cos(y[0])], (0, times[-1]), [np.pi / 2, -1.0],
        method="DOP853", rtol=1e-13, atol=1e-13, t_eval=times,
    )  # fmt: skip
    return np.asarray(run.y[0])


def start_of_cranks(model: cd.CompiledModel, windows: int) -> dict[str, float]:
    angles = parallelogram_angles(np.pi / 2, windows)
    return {name: x for name, x in angles.items() if name in model.coordinates}


PASSING = [
    *((windows, "relative", None) for windows in (1, 2, 4, 8, 16)),
    *((windows, "absolute", "z") for windows in (1, 2, 4, 8, 16)),
    *((windows, "absolute", None) for windows in (1, 2, 4)),
]


@pytest.mark.parametrize(("windows", "coordinates", "plane"), PASSING)
def test_four_bars_pass_their_singular_positions(
    windows: int, coordinates: str, plane: str | None
) -> None:
    """10 s, in which all cranks and couplers come to lie on one line ten times (IFToMM A02).

    In space every loop has three redundant rows besides.
    """
    model = cd.compile(parallelogram(windows), coordinates=coordinates, plane=plane)
    q, times = start_of_cranks(model, windows), np.linspace(0, 10, 41)
    motion = model.simulate(
        times, q=q, u={"A0": -1.0}, method="DOP853", rtol=1e-10, atol=1e-12, check=True
    )
    for k in range(windows + 1):
        np.testing.assert_allclose(motion[f"A{k}"], crank_angle(windows, times), rtol=0, atol=1e-7)
    assert motion.statistics["passed"] == 10


@pytest.mark.parametrize(
    ("windows", "end"), [(32, 0.5), pytest.param(64, 1.3, marks=pytest.mark.slow)]
)
def test_many_four_bars_move_as_one(windows: int, end: float) -> None:
    """Also over positions at which all cranks and couplers lie on one line."""
    model = cd.compile(parallelogram(windows))
    assert model.manifest.absolute
    q, times = start_of_cranks(model, windows), np.linspace(0, end, 6)
    motion = model.simulate(
        times, q=q, u={"A0": -1.0}, method="DOP853", rtol=1e-9, atol=1e-11, check=True
    )
    assert motion.statistics["passed"] == (2 if end > 1 else 0)
    for k in range(windows + 1):
        np.testing.assert_allclose(motion[f"A{k}"], crank_angle(windows, times), rtol=0, atol=1e-7)
