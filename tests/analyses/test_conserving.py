"""The energy-momentum method: what it keeps, its order, and what it refuses."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import sympy

import cardan as cd

REFERENCES = Path(__file__).parents[1] / "references"
KNOWN = json.loads((REFERENCES / "heavy_top_bca.json").read_text(encoding="utf-8"))
METHOD = "EnergyMomentum"
RUBBER = cd.material(E=5e6, nu=0.5, rho=1100)
Array = np.ndarray


def top() -> tuple[cd.CompiledModel, Array]:
    """The fast heavy top as a node held at a point, and its start."""
    given, omega = KNOWN["parameters"], np.array(KNOWN["initial_state"]["Omega0_body"])
    scene = cd.Scene("heavy_top_nodes", gravity=tuple(given["g"]))
    body = scene.body("top", mass=given["m"], com=(0, 0, 0), inertia=tuple(given["J_cog"]))
    point = body.at(*(-x for x in given["X"]))
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.joint("pivot", cd.Spherical(), scene.ground, point, cut=True)
    start = [1, 0, 0, 0, *given["X"], *omega, *np.cross(omega, given["X"])]
    return cd.compile(scene, coordinates="absolute"), np.array(start, dtype=float)


def rod(pinned: bool = True, inertia: str = "lumped") -> cd.CompiledModel:
    """A rubber beam of 1 m: a pendulum, or free in space."""
    name = f"rod_{pinned}_{inertia}"
    scene = cd.Scene(name, gravity=(0, 0, -9.81 if pinned else 0))
    tube = cd.section.tube(0.01, 0.002)
    beam = scene.beam("rod", (0, 0, 0), (1, 0, 0), tube, RUBBER, elements=4, inertia=inertia)
    if pinned:
        scene.joint("pin", cd.Spherical(), scene.ground, beam.start)
    return cd.compile(scene, coordinates="absolute")


def double_pendulum() -> cd.CompiledModel:
    """Two bodies whose hinges are across each other and miss the centers of mass."""
    scene = cd.Scene("double_pendulum_nodes", gravity=(0, 0, -9.81))
    a = scene.body("a", mass=1.0, com=(0.3, 0.1, -0.2), inertia=(0.1, 0.2, 0.25))
    b = scene.body("b", mass=2.0, com=(0.2, 0, -0.5), inertia=(0.1, 0.15, 0.2))
    scene.joint("upper", cd.Revolute(axis=(0, 1, 0)), scene.ground, a)
    scene.joint("lower", cd.Revolute(axis=(1, 0, 0)), a.at(0, 0, -1), b)
    return cd.compile(scene, coordinates="absolute")


def kept(model: cd.CompiledModel, motion: cd.Trajectory) -> tuple[Array, Array]:
    """Total energy (n,) and momenta about the origin (n, 6) along a motion."""
    energy = np.array([model.energy(q, u)[2] for q, u in zip(motion.q, motion.u, strict=True)])
    momentum = [model.momentum(q, u) for q, u in zip(motion.q, motion.u, strict=True)]
    return energy, np.array(momentum)


def times(steps: int, h: float, rows: int = 50) -> Array:
    return np.linspace(0, steps, rows + 1).round() * h


def test_heavy_top_for_many_steps() -> None:
    model, start = top()
    motion = model.simulate(times(100_000, 1e-3), x0=start, step=1e-3, method=METHOD)
    energy, momentum = kept(model, motion)
    drift = np.abs(energy - energy[0]).max() / energy[0]
    turned = np.abs(momentum[:, 2] - momentum[0, 2]).max() / np.linalg.norm(momentum[0, :3])
    print(f"energy {drift:.1e}, momentum about the vertical {turned:.1e}")
    assert drift < 1e-11
    assert turned < 1e-11


def test_heavy_top_is_of_second_order() -> None:
    model, start = top()
    row = KNOWN["reference"]["own"]["rows"][0]
    known, missed = np.array(row["quat"], dtype=float), []
    for h in (1e-3, 5e-4):
        q = model.simulate([0, row["t"]], x0=start, step=h, method=METHOD).q[-1, :4]
        missed.append(np.abs(q * np.sign(q @ known) - known).max())
    print(missed)
    assert np.log2(missed[0] / missed[1]) == pytest.approx(2, abs=0.15)


def test_flexible_pendulum() -> None:
    """From rest at its highest energy of position; what moves is what energies count against."""
    model = rod()
    motion = model.simulate(times(5000, 2e-3), step=2e-3, method=METHOD)
    energy, momentum = kept(model, motion)
    moved = max(model.energy(q, u)[0] for q, u in zip(motion.q, motion.u, strict=True))
    drift = np.abs(energy - energy[0]).max() / moved
    print(f"energy {drift:.1e} of {moved:.3g} J")
    assert drift < 1e-11
    assert motion.t[-1] == 10.0
    assert np.abs(momentum[:, 2]).max() < 1e-12 * np.abs(momentum).max()


def test_a_free_rod_keeps_all_momenta() -> None:
    model = rod(pinned=False)
    rest = model.simulate([0, 1e-3], step=1e-3, method=METHOD)
    u = np.random.default_rng(0).normal(size=model.nu) * 0.5
    start = np.concatenate([rest.q[0], u])
    motion = model.simulate(times(2000, 1e-3), x0=start, step=1e-3, method=METHOD)
    energy, momentum = kept(model, motion)
    assert np.abs(energy - energy[0]).max() < 1e-11 * energy[0]
    for part in (momentum[:, :3], momentum[:, 3:]):
        # what the solver leaves in 2,000 steps is up to 2e-12, by start and processor
        assert np.abs(part - part[0]).max() < 2e-11 * np.linalg.norm(part[0])


def test_revolute_joints() -> None:
    model = double_pendulum()
    motion = model.simulate(times(4000, 1e-3), step=1e-3, method=METHOD)
    energy = kept(model, motion)[0]
    assert np.abs(energy - energy[0]).max() < 1e-12 * np.abs(energy[0])
    # the same motion as by another method
    other = model.simulate([0, 1.0], method="DOP853", rtol=1e-11, atol=1e-12)
    coarse, fine = (
        np.abs(model.simulate([0, 1.0], step=h, method=METHOD).q[-1] - other.q[-1]).max()
        for h in (4e-3, 2e-3)
    )
    print(f"{coarse:.1e} at 4 ms, {fine:.1e} at 2 ms")
    assert np.log2(coarse / fine) == pytest.approx(2, abs=0.15)


def test_springs_between_bodies_keep_all_momenta() -> None:
    scene = cd.Scene("sprung_nodes", gravity=(0, 0, 0))
    a = scene.body("a", mass=1.0, com=(0.1, 0, 0), inertia=(0.1, 0.2, 0.25))
    b = scene.body("b", mass=2.0, com=(0, 0.1, 0.2), inertia=(0.3, 0.15, 0.2))
    scene.joint("of_a", cd.Free(), scene.ground, a)
    scene.joint("of_b", cd.Free(), scene.ground, b)
    spring = cd.SpringDamper(a.at(0.2, 0, 0), b.at(0, 0, 0.3), stiffness=300.0, rest_length=0.4)
    scene.force("spring", spring)
    model = cd.compile(scene, coordinates="absolute")
    q, u = [1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0.9, 0, 0], np.linspace(-1, 2, 12)
    motion = model.simulate(times(4000, 2e-3), q=q, u=u, step=2e-3, method=METHOD)
    assert motion.success
    energy, momentum = kept(model, motion)
    assert np.abs(energy - energy[0]).max() < 1e-12 * energy[0]
    assert np.abs(momentum - momentum[0]).max() < 1e-11 * np.abs(momentum[0]).max()


def test_multipliers_are_those_of_the_motion() -> None:
    """At the ends of steps, extrapolated from their middles."""
    model, start = top()
    missed = []
    for h in (1e-3, 5e-4):
        motion = model.simulate(np.arange(0, 0.02, 1e-3), x0=start, step=h, method=METHOD)
        true = [model.multipliers(q, u) for q, u in zip(motion.q, motion.u, strict=True)]
        found = np.stack(list(motion.multipliers.values()), axis=1)
        missed.append(np.abs(found - np.array(true))[3:].max())
    print(missed)
    assert np.log2(missed[0] / missed[1]) == pytest.approx(2, abs=0.3)


def test_what_does_not_conserve_is_named() -> None:
    with pytest.raises(cd.ModelError, match="inertia='lumped'"):
        rod(inertia="linked").simulate(0.1, step=1e-3, method=METHOD)
    damped = cd.Scene("damped", gravity=(0, 0, -9.81))
    body = damped.body("bob", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.1))
    damped.joint("pin", cd.Revolute(axis=(0, 1, 0)), damped.ground, body)
    damped.force("oil", cd.SpringDamper(damped.ground.at(1, 0, 0), body, damping=4.0))
    with pytest.raises(cd.ModelError, match="'oil' is not conservative"):
        cd.compile(damped, coordinates="absolute").simulate(0.1, step=1e-3, method=METHOD)
    with pytest.raises(cd.ModelError, match="coordinates='absolute'"):
        cd.compile(damped).simulate(0.1, step=1e-3, method=METHOD)


@pytest.mark.parametrize("along", [False, True])
@pytest.mark.parametrize("by", ["time", "input"])
def test_a_load_that_begins_at_zero_is_named(along: bool, by: str) -> None:
    scene = cd.Scene("loaded", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=3, EI=4, rhoA=0.3, rhoI=1e-6)
    beam = scene.beam("beam", scene.ground, (1, 0, 0), section, elements=2, inertia="lumped")
    size = scene.input("gust") if by == "input" else cd.t
    load = (0, 0, size)
    scene.force("wind", cd.LineLoad(beam, force=load) if along else cd.Force(beam.end, load))
    name = r"beam\.\d" if along else "wind"
    with pytest.raises(cd.ModelError, match=f"'{name}' is not conservative"):
        cd.compile(scene).simulate(0.1, step=1e-3, method=METHOD)


def test_outputs_and_events_that_are_noted_change_nothing() -> None:
    """A pendulum with and without them; the event is where a fine run has it."""
    runs = []
    for noted in (False, True):
        scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
        bob = scene.body("bob", mass=1.0, com=(0.3, 0, 0), inertia=(0.1, 0.1, 0.1))
        scene.joint("pin", cd.Revolute("y"), scene.ground, bob)
        if noted:
            scene.output("x", bob.at(1, 0, 0).position()[0], unit="m")
            scene.force("passes", cd.Event(0.5 - scene.q("pin")))
        model = cd.compile(scene, coordinates="absolute")
        runs.append(model.simulate(0.6, step=1e-3, method=METHOD))
    np.testing.assert_array_equal(runs[0].x[-1], runs[1].x[-1])
    fine = cd.compile(scene).simulate(0.6, rtol=1e-10, atol=1e-12, method="DOP853")
    assert runs[1]["x"][-1] == pytest.approx(np.cos(fine["pin"][-1]), abs=1e-5)
    (event,) = runs[1].events
    (true,) = fine.events
    assert event.t == pytest.approx(true.t, abs=1e-5)


@pytest.mark.parametrize("driven", [False, True])
def test_what_begins_later_is_named(driven: bool) -> None:
    """It ran, and said at its end that energy was unaccounted for."""
    late = sympy.Piecewise((0.0, cd.t < 0.5), ((cd.t - 0.5) ** 3, True))
    scene = cd.Scene("late", gravity=(0, 0, 0))
    body, rider = (scene.body(name, 1.0, (0, 0, 0), (0.1, 0.1, 0.1)) for name in ("a", "b"))
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.joint("late", cd.Prismatic("x"), body, rider, prescribed=late if driven else None)
    if not driven:
        scene.force("late", cd.Force(body, (late, 0, 0)))
    model = cd.compile(scene, coordinates="absolute")
    with pytest.raises(cd.ModelError, match=r"'late' is not conservative .it depends on the time"):
        model.simulate([0, 1], method=METHOD, step=1e-2)
