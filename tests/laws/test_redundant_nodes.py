"""Redundant loops in nodes: accelerations are those of joints and of dense least squares.

Against M udot + h = f + G^T lam, G udot = gamma by numpy.linalg.lstsq, with the rank that singular
values of the closed mechanism have, and against joint coordinates. Where lengths are rounded, or
the state is beside the constraints by as much as a stage of a step, they follow in proportion.
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.finite_elements.elements import State
from cardan.runtime.models.finite_elements.mesh import Mesh
from laws.test_absolute import carried, mesh_of

# singular values of redundant rows are below, those of other rows above, in units of inertia
RANK = 1e-5
# accelerations: rounding; what gaps of positions and speeds do to them, of the largest
ROUNDING, PER_GAP = 1e-9, 1e3
Shift = Callable[..., tuple[float, ...]]


def rounded(size: float) -> Shift:
    """A shift of points by at most that much."""
    rng = np.random.default_rng(0)
    return lambda *point: tuple(np.asarray(point) + size * rng.uniform(-1, 1, 3))


def doors(count: int, hinges: int, size: float) -> cd.Scene:
    """Doors in a row, each on hinges about one line."""
    scene, place = cd.Scene("doors", gravity=(0, 0.3, -9.81)), rounded(size)
    frame, reach = scene.ground, 0.0
    for i in range(count):
        leaf = scene.body(f"leaf{i}", mass=5.0, com=(0.4, 0.02, 1.0), inertia=(2, 3, 1))
        for j in range(hinges):
            z = 2.0 * j / (hinges - 1)
            more = {"cut": True} if j else {"q0": 0.4}
            ends = frame.at(*place(reach, 0, z)), leaf.at(0, 0, z)
            scene.joint(f"hinge{i}_{j}", cd.Revolute("z"), *ends, **more)
        frame, reach = leaf, 0.8
    return scene


def table(legs: int, size: float) -> cd.Scene:
    """A table that slides on legs."""
    scene, place = cd.Scene("table", gravity=(0.5, 0, -9.81)), rounded(size)
    top = scene.body("top", mass=12.0, com=(0.1, 0.05, 0.7), inertia=(1, 1, 2))
    for j, angle in enumerate(2 * np.pi * np.arange(legs) / legs + 0.3):
        foot = (0.5 * float(np.cos(angle)), 0.4 * float(np.sin(angle)), 0.0)
        ends = scene.ground.at(*place(*foot)), top.at(*foot)
        scene.joint(f"leg{j}", cd.Planar("z"), *ends, cut=j > 0)
    return scene


def parallelograms(floors: int, bars: int, axes: str, size: float) -> cd.Scene:
    """Plates on parallel bars, one on the other, about these axes in turn."""
    scene, place = cd.Scene("parallelograms", gravity=(1.0, 0.7, -9.81)), rounded(size)
    base = scene.ground
    for i in range(floors):
        axis = axes[i % len(axes)]
        along, end, up = {
            "y": ((0, 0, 0.1), (0.15, 0.05, 0), (0, -0.05, 0)),
            "x": ((0.1, 0, 0), (0.05, 0.2, 0), (-0.1, 0, 0.3)),
        }[axis]
        plate = scene.body(f"plate{i}", mass=0.5, com=(0.05, 0.1, 0.1), inertia=(2e-3, 2e-3, 1e-3))
        for j in range(bars):
            bar = scene.body(
                f"bar{i}_{j}", mass=0.2, com=(0.07, 0.02, 0), inertia=(1e-3, 1e-3, 2e-3)
            )
            offset = j * np.array(along)
            hip = base.at(*place(*(offset + up)))
            scene.joint(f"hip{i}_{j}", cd.Revolute(axis), hip, bar, q0=0.8)
            more = {"cut": True} if j else {"q0": -0.8}
            foot = bar.at(*end), plate.at(*map(float, offset))
            scene.joint(f"foot{i}_{j}", cd.Revolute(axis), *foot, **more)
        base = plate
    return scene


def ring(count: int, size: float) -> cd.Scene:
    """A plane ring of bars that floats."""
    scene, place = cd.Scene("ring", gravity=(0, 0, -1.0)), rounded(size)
    inertia = cd.inertia.rod(0.4, 0.3, axis="x")
    bars = [
        scene.body(f"bar{i}", mass=0.4, com=(0.15, 0, 0), inertia=inertia) for i in range(count)
    ]
    scene.joint("free", cd.Free(), scene.ground, bars[0])
    for i in range(count):
        more = {"cut": True} if i == count - 1 else {"q0": 2 * np.pi / count}
        ends = bars[i].at(*place(0.3, 0, 0)), bars[(i + 1) % count]
        scene.joint(f"corner{i}", cd.Revolute("z"), *ends, **more)
    return scene


SCENES: dict[str, Callable[[float], cd.Scene]] = {
    "door": functools.partial(doors, 1, 2),
    "doors on five hinges": functools.partial(doors, 1, 5),
    "doors in a row": functools.partial(doors, 3, 3),
    "table of four": functools.partial(table, 4),
    "table of seven": functools.partial(table, 7),
    "parallelogram": functools.partial(parallelograms, 1, 2, "y"),
    "three bars": functools.partial(parallelograms, 1, 3, "y"),
    "chain of three bars": functools.partial(parallelograms, 3, 3, "y"),
    "box of four bars": functools.partial(parallelograms, 2, 4, "yx"),
    "tower of boxes": functools.partial(parallelograms, 4, 3, "yx"),
    "ring of four": functools.partial(ring, 4),
    "ring of six": functools.partial(ring, 6),
}


@functools.lru_cache(maxsize=2)
def both(name: str, size: float) -> tuple[cd.CompiledModel, cd.CompiledModel]:
    """A scene in nodes and in joints."""
    build = SCENES[name]
    nodes = cd.compile(build(size), coordinates="absolute")
    return nodes, cd.compile(build(0.0), coordinates="relative")


def least(mesh: Mesh, at: State) -> tuple[np.ndarray, float]:
    """udot (nu,) of dense least squares, and how much is open of positions and speeds."""
    tangent = mesh.tangent(at, ("M", "G"))
    M, G = tangent["M"].toarray(), tangent["G"].toarray()
    force, gaps, rates = mesh.balance(at)
    gamma = mesh.gamma(at)
    size = np.abs(G).max(axis=1)
    rows = G / np.where(size > 0, size, 1)[:, None]
    sides = gamma / np.where(size > 0, size, 1)
    # coordinates of joints have no inertia: what rows allow of it does not depend on what they hold
    root = np.linalg.cholesky(M + rows.T @ rows)
    free = np.linalg.solve(root, rows.T @ sides - force)
    columns = np.linalg.solve(root, rows.T).T
    change = np.linalg.lstsq(columns, sides - columns @ free, rcond=RANK)[0]
    most = max(np.abs(gaps).max(initial=0.0), np.abs(rates).max(initial=0.0))
    return np.linalg.solve(root.T, free + change), float(most)


def compare(mesh: Mesh, at: State) -> None:
    """Accelerations against dense least squares, in proportion to what is open."""
    expected, gap = least(mesh, at)
    udot, _ = mesh.accelerations(at)
    off = np.abs(udot - expected).max() / (1 + np.abs(expected).max())
    assert off < ROUNDING + PER_GAP * gap, f"off by {off:.1e} where {gap:.1e} is open"


@pytest.mark.parametrize("name", SCENES)
def test_accelerations_are_those_of_joints(name: str) -> None:
    model, joints = both(name, 0.0)
    q, u, _ = joints.parts_of(joints.initial())
    udot = model.forward_dynamics(*carried(model, joints, q, u))
    theirs = joints.forward_dynamics(q, u)
    for k, speed in enumerate(joints.speeds):
        assert udot[model.speeds.index(speed)] == pytest.approx(
            theirs[k], rel=ROUNDING, abs=ROUNDING * (1 + np.abs(theirs).max())
        )


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("size", [0.0, 1e-13, 1e-11, 1e-9])
def test_accelerations_are_of_least_squares(name: str, size: float) -> None:
    """At places of joints, where rounded lengths leave gaps, at rest and in motion."""
    model, joints = both(name, size)
    mesh, rng = mesh_of(model), np.random.default_rng(1)
    q, u, _ = joints.parts_of(joints.initial())
    nodes, speeds = carried(model, joints, q, u)
    compare(mesh, State(q=nodes, u=speeds))
    for _ in range(3):
        thrown = State(q=nodes, u=speeds + rng.normal(size=model.nu))
        moving = mesh.call("close_velocity", thrown, model.nu + model.nlam)[: model.nu]
        compare(mesh, State(q=nodes, u=moving))


@pytest.mark.parametrize("name", SCENES)
def test_gaps_of_a_stage_do_not_decide_on_rank(name: str) -> None:
    """Beside constraints rows are nearly redundant; what they ask for is not divided by that."""
    model, joints = both(name, 0.0)
    mesh, rng = mesh_of(model), np.random.default_rng(2)
    q, u, _ = joints.parts_of(joints.initial())
    nodes, speeds = carried(model, joints, q, u)
    closed = mesh.accelerations(State(q=nodes, u=speeds))[0]
    for gap in (1e-12, 1e-10, 1e-8, 1e-7):
        for _ in range(3):
            q_off = mesh.move(nodes, gap * rng.normal(size=model.nu))
            u_off = speeds + gap * rng.normal(size=model.nu)
            udot, _ = mesh.accelerations(State(q=q_off, u=u_off))
            off = np.abs(udot - closed).max() / (1 + np.abs(closed).max())
            assert off < ROUNDING + PER_GAP * gap


def test_rows_next_to_a_singular_position_hold() -> None:
    """Three bars of rounded lengths fit where they lie in a line, and nothing moves there.

    Redundant rows are there, and rows of their own at angles of 1e-4 to others.
    """
    build = SCENES["three bars"]
    model, joints = (cd.compile(build(1e-9), coordinates=kind) for kind in ("absolute", "relative"))
    mesh = mesh_of(model)
    q, u, _ = joints.parts_of(joints.initial())
    at = State(*carried(model, joints, q, u))
    udot, _ = mesh.accelerations(at)
    left = mesh.tangent(at, ("G",))["G"] @ udot - mesh.gamma(at)
    assert np.abs(left).max() < 1e-9
    assert np.abs(udot).max() < 1e-6


def test_contradictions_are_refused() -> None:
    """Two leaves of a door that are fixed to each other and yet to turn differently."""
    scene, leaves = cd.Scene("door", gravity=(0, 0, -9.81)), []
    for name, z, rate in (("low", 0.0, 1.0), ("high", 2.0, 1.5)):
        leaf = scene.body(f"{name}_leaf", mass=5.0, com=(0.4, 0, 0), inertia=(2, 3, 1))
        turn = cd.Revolute("z")
        scene.joint(name, turn, scene.ground.at(0, 0, z), leaf, prescribed=rate * cd.t**2)
        leaves.append(leaf)
    scene.joint("weld", cd.Fixed(), leaves[0].at(0, 0, 2.0), leaves[1], cut=True)
    model = cd.compile(scene, coordinates="absolute")
    q, u, _ = model.parts_of(model.initial())
    with pytest.raises(cd.SolveError, match=r"redundant constraints contradict each other"):
        model.forward_dynamics(q, u)
