"""The ledger speaks: what a run cannot account for far beyond its tolerance is said, by every
integrator, in both kinds of coordinates and in ensembles; healthy runs say nothing."""

from __future__ import annotations

import functools
import warnings
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.analyses.simulation.energy_accounting import CEILING, accounts, excess
from cardan.analyses.simulation.settings import settings
from cardan.errors import DerivationError, SolveWarning
from cardan.schema.integrators import INTEGRATORS
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from spread import some

KINDS = ("relative", "absolute")
# those that keep energy by construction, and those that a kind of coordinates has not
KEEPING = {"EnergyMidpoint", "EnergyMomentum"}
MISSING = {"relative": {"EnergyMomentum"}, "absolute": {"Radau", "Rosenbrock", "Newmark"}}


@functools.cache
def pendulum(coordinates: str, loss: float = 0.0) -> cd.CompiledModel:
    """Two links under gravity."""
    scene = cd.Scene("pendulum")
    place: Any = scene.ground
    for k in range(2):
        link = scene.body(f"link{k}", mass=1.0, com=(0, 0, -1.0), inertia=(0.1, 0.1, 0.1))
        scene.joint(f"j{k}", cd.Revolute("y"), place, link)
        place = link.at(0, 0, -1)
    if loss:
        scene.force("loss", cd.JointDamper("j0", loss))
    return cd.compile(scene, coordinates=coordinates)


@functools.cache
def floating(coordinates: str) -> cd.CompiledModel:
    """Two bodies with a hinge between them, and nothing else."""
    scene = cd.Scene("floating", gravity=(0, 0, 0))
    one = scene.body("one", mass=1.0, inertia=(0.1, 0.2, 0.25))
    other = scene.body("other", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.1))
    scene.joint("free", cd.Free(), scene.ground, one)
    scene.joint("hinge", cd.Revolute("y"), one, other)
    return cd.compile(scene, coordinates=coordinates)


def said(motion: Any, caught: list[Any]) -> list[str]:
    """What the warnings of a run say of what is unaccounted for."""
    texts = [str(w.message) for w in caught if issubclass(w.category, SolveWarning)]
    assert [text for text in texts if "unaccounted" in text] == [
        text for text in [motion.solver_info.warning] if text
    ]
    return [text for text in texts if "unaccounted" in text]


def simulated(model: cd.CompiledModel, *args: Any, **how: Any) -> tuple[Any, list[str]]:
    """A run, and what it says of what it cannot account for."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        motion = model.simulate(*args, **how)
    return motion, said(motion, caught)


@pytest.mark.parametrize("coordinates", KINDS)
@pytest.mark.parametrize("method", INTEGRATORS)
def test_a_bad_run_says_so(method: str, coordinates: str) -> None:
    if method in MISSING[coordinates]:
        pytest.skip("not for these coordinates")
    adaptive = INTEGRATORS[method].adaptive
    how: dict[str, Any] = {"rtol": 1.0, "atol": 10.0} if adaptive else {"step": 0.5}
    motion, texts = simulated(pendulum(coordinates), 20.0, q={"j0": 1.0}, method=method, **how)
    missed = float(np.abs(motion.energy_residual).max())
    moved = float(motion.energy.kinetic.max() + np.ptp(motion.energy.potential))
    print(f"{method}, {coordinates}: {motion.status}, {missed:.1e} J of {moved:.1e} J: {texts}")
    if method in KEEPING:
        assert not any("energy" in text for text in texts)
    elif missed > CEILING * moved:
        assert "J of energy unaccounted for" in texts[0]
    else:
        # it broke down before it could be wrong by much
        assert not motion.success


def test_most_methods_are_bad_at_such_tolerances() -> None:
    """Else the test above would show nothing: nine of eleven, without links on nodes."""
    bad = 0
    for method in INTEGRATORS:
        if method in KEEPING | MISSING["relative"]:
            continue
        how: dict[str, Any] = {"rtol": 1.0, "atol": 10.0}
        how = how if INTEGRATORS[method].adaptive else {"step": 0.5}
        bad += bool(simulated(pendulum("relative"), 20.0, q={"j0": 1.0}, method=method, **how)[1])
    assert bad >= 9


@pytest.mark.parametrize("coordinates", KINDS)
def test_momenta_are_watched_where_nothing_acts(coordinates: str) -> None:
    """A method that keeps energy whatever the step loses momentum, and says so."""
    model = floating(coordinates)
    begin = {"free": (1, 2, 3, 0, 0, 0), "hinge": 3.0}
    how = {"method": "EnergyMidpoint", "step": 0.5}
    motion, texts = simulated(model, 20.0, u=begin, **how)
    momentum = model.momentum(motion.q, motion.u)
    print(np.abs(momentum - momentum[0]).max(axis=0), texts)
    assert "N m s of angular momentum unaccounted for" in texts[0]
    assert simulated(model, 2.0, u=begin, method="EnergyMidpoint", step=1e-3)[1] == []


def test_a_momentum_that_stays_at_nothing_is_no_fault() -> None:
    """Speeds are known to atol: what is 0 may come to that, however little else there is of it."""
    scene = cd.Scene("craft", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=200, inertia=(30, 40, 35))
    scene.joint("drift", cd.Free(), scene.ground, hub)
    carbon = cd.material(E=6e10, nu=0.3, rho=1600, damping=5e-4)
    strip = cd.section.rectangle(0.5, 0.004)
    scene.beam("panel", hub, (0, 2.5, 0), strip, carbon, elements=1, up="x")
    with warnings.catch_warnings():
        warnings.simplefilter("error", SolveWarning)
        motion = cd.compile(scene).simulate(0.1, u={"drift.u.y": 0.01})
    assert motion.status == "finished"


def test_momenta_are_not_watched_where_something_acts() -> None:
    """Gravity, the ground, a force from outside and a wheel of constant momentum."""
    assert not pendulum("relative").manifest.get("isolated")

    def free(gravity: float, *forces: Any) -> bool:
        scene = cd.Scene("one", gravity=(0, 0, gravity))
        body = scene.body("body", mass=1.0, inertia=(0.1, 0.2, 0.25))
        other = scene.body("other", mass=1.0, inertia=(0.1, 0.2, 0.25), pose=(1, 0, 0))
        scene.joint("free", cd.Free(), scene.ground, body)
        scene.joint("apart", cd.Free(), scene.ground, other)
        for k, force in enumerate(forces):
            scene.force(f"force{k}", force(scene.ground, body, other))
        model = cd.compile(scene)
        motion = model.simulate(0.1, u={"free": (1, 2, 3, 0, 0, 0)})
        names = {a.what for a in accounts(motion, settings("DOP853", 1e-6, 1e-9, None, None, 0.1))}
        return "momentum" in names

    assert free(0.0)
    assert free(0.0, lambda ground, a, b: cd.SpringDamper(a, b, stiffness=3.0))
    assert not free(-9.81)
    assert not free(
        0.0, lambda ground, a, b: cd.SpringDamper(ground, a, stiffness=3.0, rest_length=1)
    )
    assert not free(0.0, lambda ground, a, b: cd.Force(a, (1.0, 0, 0)))
    assert not free(0.0, lambda ground, a, b: cd.Rotor(a, axis="z", momentum=2.0))


@pytest.mark.parametrize("coordinates", KINDS)
def test_a_loop_that_comes_open_says_so(coordinates: str) -> None:
    """Every method projects, so that runs stay closed: what a record would say if one did not."""
    scene = CLOSED["four_bar"].build()
    motion = cd.compile(scene, coordinates=coordinates).simulate(0.1, rtol=1e-6, atol=1e-9)
    how = settings(motion.solver_info.method, 1e-6, 1e-9, None, None, 0.1)
    assert excess(motion, how) == ""
    assert motion.ledger is not None
    for level in ("position", "velocity"):
        record = getattr(motion.ledger, level)
        name = next(reversed(record))
        for gap, told in ((1e-3, True), (1e-7, False)):
            wide = {**record, name: replace(record[name], after=gap)}
            opened = replace(motion, ledger=replace(motion.ledger, **{level: wide}))
            assert (f"of closure of '{name}' unaccounted for" in excess(opened, how)) == told


def test_a_start_in_strain_says_so() -> None:
    """What damped vibrations of a strained start carry away is lost without a source."""
    scene = cd.Scene("strained", gravity=(0, 0, 0))
    section, steel = cd.section.rectangle(0.01, 0.01), cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("beam", scene.ground, (1.0, 0, 0), section, steel, elements=4)
    model = cd.compile(scene)
    start = model.initial()
    start[model.coordinates.index("beam.node2.px")] += 0.02
    motion, texts = simulated(model, 0.1, x0=start, rtol=1e-3)
    print(motion.energy_residual[-1], motion.energy.total[0], texts)
    assert "J of energy unaccounted for" in texts[0]


@pytest.mark.parametrize("loss", [0.0, 0.3])
@pytest.mark.parametrize("coordinates", KINDS)
def test_ensembles_say_it_of_their_runs(coordinates: str, loss: float) -> None:
    model = pendulum(coordinates, loss)
    starts = np.linspace(0.3, 0.9, 6)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = model.ensemble(10.0, vary={"j0": starts}, method="RK4", step=0.4)
    texts = [str(w.message) for w in caught if issubclass(w.category, SolveWarning)]
    assert any("miss far more than their tolerance is worth" in text for text in texts), texts
    told = [k for k in range(6) if found.finished[k] and "unaccounted" in found.messages.get(k, "")]
    assert told
    # each of them says the same alone
    assert "unaccounted" in found.run(told[0]).solver_info.warning
    with warnings.catch_warnings():
        warnings.simplefilter("error", SolveWarning)
        model.ensemble(2.0, vary={"j0": starts})


def test_check_raises() -> None:
    with pytest.raises(cd.errors.SolveError, match="unaccounted for"):
        pendulum("relative").simulate(20.0, q={"j0": 1.0}, rtol=1.0, atol=10.0, check=True)


def test_a_run_says_it_in_print_and_keeps_it_in_its_file(tmp_path: Any) -> None:
    motion, texts = simulated(pendulum("relative"), 20.0, q={"j0": 1.0}, rtol=1.0, atol=10.0)
    assert "  warning   " in str(motion)
    loaded = cd.load_motion(motion.save(tmp_path / "bad.nc"))
    assert loaded.solver_info.warning == texts[0]


def test_what_rests_says_nothing() -> None:
    """Speeds that rounding leaves carry an energy that no ledger can account for."""
    crank = cd.compile(CLOSED["slider_crank"].build())
    crank = crank.with_parameters({n: 0.0 for n in crank.parameters if n.startswith("gravity")})
    start = crank.equilibrium(q={"A": -1.0}, stable=True)
    motion, texts = simulated(crank, 1.0, x0=start, method="GeneralizedAlpha")
    assert texts == []
    assert np.abs(motion.u).max() < 1e-15


@pytest.mark.parametrize(("name", "coordinates"), some([(n, c) for n in ZOO for c in KINDS], 16))
def test_healthy_runs_of_the_zoo_say_nothing(name: str, coordinates: str) -> None:
    try:
        model = cd.compile(ZOO[name].build(), coordinates=coordinates)
    except DerivationError as refused:
        pytest.skip(str(refused))
    first = ZOO[name].states[0]
    for rtol in (1e-6, 1e-9):
        how = {"q": dict(first.q), "u": dict(first.u), "rtol": rtol}
        assert simulated(model, 2.0, **how)[1] == []


def shaken() -> cd.Scene:
    """An arm with a beam at its end, on a base that is driven up and down."""
    scene = cd.Scene("driven", gravity=(0, 0, -9.81))
    base = scene.body("base", mass=2.0, inertia=(0.1, 0.1, 0.1))
    heave = 0.03 * sp.sin(9 * cd.t)
    scene.joint("heave", cd.Prismatic("z"), scene.ground, base, prescribed=heave)
    arm = scene.body("arm", mass=1.0, com=(0.25, 0, 0), inertia=(0.01, 0.02, 0.02))
    scene.joint("hinge", cd.Revolute("y"), base, arm, q0=0.3)
    section = cd.section.general(EA=2e3, GA=1e3, GJ=1.5, EI=2.0, rhoA=1.0, rhoI=1e-3)
    scene.beam("beam", arm.at(0.5, 0, 0), (0.8, 0, 0), section, elements=2, up="z")
    return scene


@pytest.mark.parametrize("coordinates", ["auto", "absolute"])
def test_what_drives_a_tree_with_a_beam_is_accounted_for(coordinates: str) -> None:
    """Power of a driven base is force times rate, inertia of the tree that it carries included."""
    model = cd.compile(shaken(), coordinates=coordinates)
    motion = model.simulate(np.linspace(0, 0.3, 7), method="DOP853", rtol=1e-10, atol=1e-12)
    assert np.abs(motion.energy_residual).max() < 1e-9
    q, u, _ = model.parts_of(motion.x[-1])
    (power,) = model.power(q, u, t=motion.t[-1])
    rate = 0.27 * np.cos(9 * motion.t[-1])
    assert power == pytest.approx(motion["heave.driving_force"][-1] * rate, rel=1e-9)
