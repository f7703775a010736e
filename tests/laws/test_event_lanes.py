"""Elements with events side by side in vectors: as in joint coordinates, one by one."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from laws.test_absolute import carried

COUNT, SPAN = 11, 0.6


def row() -> tuple[cd.Scene, dict[str, float]]:
    """Masses on rails, alike but for numbers, each with what may happen to it."""
    scene = cd.Scene("row", gravity=(0, 0, -9.81))
    for k in range(COUNT):
        ball = scene.body(f"ball{k}", mass=1.0 + 0.1 * k, inertia=(0.1,) * 3)
        scene.joint(f"z{k}", cd.Prismatic("z"), scene.ground.at(k, 0, 0), ball)
        scene.force(f"floor{k}", cd.Stop(f"z{k}", lower=0.0, restitution=0.05 * k, settle=0.05))
        arm = scene.body(f"arm{k}", mass=1.0, com=(0.2, 0, 0), inertia=(0.1,) * 3)
        scene.joint(f"J{k}", cd.Revolute("y"), scene.ground.at(k, 1, 0), arm)
        scene.force(f"rub{k}", cd.Friction(f"J{k}", coulomb=0.8 + 0.05 * k, static=1.5))
        motor = cd.Actuator(f"J{k}", command=sp.sin(5 * cd.t + k), lag=0.05, limit=2.0)
        scene.force(f"motor{k}", motor)
        scene.force(f"latch{k}", cd.Lock(f"J{k}", when=0.45 - scene.q(f"J{k}")))
    start = {f"z{k}": 0.1 + 0.02 * k for k in range(COUNT)}
    return scene, start | {f"J{k}": -0.05 * k for k in range(COUNT)}


@pytest.fixture(scope="module")
def both() -> tuple[cd.CompiledModel, cd.CompiledModel]:
    """In finite-element and in joint coordinates."""
    return cd.compile(row()[0], coordinates="absolute"), cd.compile(row()[0], loops=True)


def test_they_go_side_by_side(both: tuple[cd.CompiledModel, cd.CompiledModel]) -> None:
    model, other = both
    q = np.array([row()[1].get(name, 0.0) for name in other.coordinates])
    nodes, speeds = carried(model, other, q, np.zeros(other.nu))
    model.events(nodes, speeds, s=model._layout.start("s"))
    mesh = model._source.results(model).mesh
    # numbers 0 and 1 make kinds of their own
    groups = [group for group in mesh.tables.groups if group.kind.ne and len(group) > 8]
    assert len(groups) == 3
    assert all(mesh._codes[group.kind.functions["signs"]].lanes > 1 for group in groups)


@pytest.mark.parametrize("method", ["DOP853", cd.GeneralizedAlpha(0.8)])
def test_motions(both: tuple[cd.CompiledModel, cd.CompiledModel], method: object) -> None:
    model, other = both
    fine = {"rtol": 1e-9, "atol": 1e-10}
    theirs = other.simulate(SPAN, q=row()[1], method="DOP853", **fine)
    options = {"step": 1e-3} if method != "DOP853" else fine
    mine = model.simulate(SPAN, q=row()[1], method=method, **options)
    near = 1e-6 if method == "DOP853" else 2e-3
    # friction and the latch of a joint that stands share its load, which no law tells: whether
    # friction lets go then changes nothing
    caught = {
        event.name[len("latch") :].partition(".")[0]: event.t
        for event in theirs.events
        if event.name.startswith("latch")
    }
    assert len(caught) > COUNT // 2
    counts = [
        sorted(
            event.name
            for event in motion.events
            if not event.name.startswith("rub")
            or event.t < caught.get(event.name[len("rub") :].partition(".")[0], np.inf)
        )
        for motion in (mine, theirs)
    ]
    assert counts[0] == counts[1]
    assert len(counts[0]) > 3 * COUNT
    for name in other.coordinates:
        assert mine[name][-1] == pytest.approx(theirs[name][-1], abs=near)
    shared = {f"rub{k}" for k in caught}
    own = [name.partition(".")[0] not in shared for name in model.mode_names]
    assert mine.s[-1][own] == pytest.approx(theirs.s[-1][own])


def test_transitions_of_many_at_once(both: tuple[cd.CompiledModel, cd.CompiledModel]) -> None:
    model, other = both
    rng = np.random.default_rng(5)
    q = np.array([row()[1].get(name, 0.0) for name in other.coordinates])
    u = rng.uniform(-1, 1, other.nu)
    z = np.array([row.default for row in other.manifest.z])
    nodes, speeds = carried(model, other, q, u)
    at = [model.speeds.index(speed) for speed in other.speeds]
    for _ in range(3):
        s = np.array([float(rng.choice([int(v) for v in row.labels])) for row in other.manifest.s])
        e = rng.integers(0, 2, len(other.event_names)).astype(float)
        theirs = other.transition(q, u, e, s=s, z=z)
        mine = model.transition(nodes, speeds, e, s=s, z=z)
        assert mine[at] == pytest.approx(theirs[: other.nu], abs=1e-9)
        stops = [i for i, row in enumerate(other.manifest.s) if row.name.startswith(("fl", "la"))]
        first = len(mine) - len(s)
        assert mine[first:][stops] == pytest.approx(theirs[other.nu + len(z) :][stops])
