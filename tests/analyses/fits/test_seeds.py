"""First values of a fit: from identification, and from the measurements."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, ModelError, SolveError, SolveWarning
from table import each

TRUE = {
    **{"upper.m": 3.0, "upper.c": 0.2, "upper.I": 0.08, "upper.d": 0.5},
    **{"lower.m": 1.2, "lower.c": 0.25, "lower.I": 0.03, "lower.d": 0.2},
}
# mass and center of the upper link act as a product
UNKNOWN = tuple(name for name in TRUE if name not in ("upper.m", "upper.c"))
TIMES = np.arange(0, 4.0001, 0.01)
MOTORS = {
    "upper.tau": (TIMES, 8 * np.sin(3 * TIMES) + 4 * np.sin(7.3 * TIMES)),
    "lower.tau": (TIMES, 3 * np.sin(4.1 * TIMES + 1) + np.cos(9 * TIMES)),
}


def arm(**options: Any) -> cd.CompiledModel:
    """Two links with dampers, moved by torques that are inputs."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    inner = scene.ground
    for name, length in (("upper", 0.5), ("lower", 0.4)):
        m, c, inertia, d = (
            scene.parameter(f"{name}.{one}", TRUE[f"{name}.{one}"]) for one in "mcId"
        )
        link = scene.body(name, mass=m, com=(0, 0, -c), inertia=(inertia, inertia, 0.01))
        scene.joint(f"{name}_joint", cd.Revolute("y"), inner, link)
        scene.force(f"{name}_drag", cd.JointDamper(f"{name}_joint", d))
        tau = scene.input(f"{name}.tau", unit="N*m")
        scene.force(f"{name}_motor", cd.JointForce(f"{name}_joint", tau))
        inner = link.at(0, 0, -length)
    return cd.compile(scene, **options)


def run(model: cd.CompiledModel, noise: float) -> dict[str, Any]:
    motion = model.simulate(
        TIMES, q={"upper_joint": 0.3, "lower_joint": -0.5}, inputs=MOTORS, rtol=1e-10
    )
    rng = np.random.default_rng(3)
    return {"t": TIMES} | {
        name: motion[name] + noise * rng.standard_normal(len(TIMES)) for name in model.coordinates
    }


def far(factor: float) -> dict[str, float]:
    return {name: factor * TRUE[name] for name in UNKNOWN}


@each(("factor", "noise"), [(10.0, 1e-4), (0.1, 1e-3), (10.0, 5e-3)])
def test_identification_gives_first_values(factor: float, noise: float) -> None:
    """From ten times the truth the search alone is lost; identification needs no first values."""
    model = arm()
    data = run(model, noise)
    options: dict[str, Any] = {"unknown": (*UNKNOWN, "x0"), "inputs": MOTORS}
    found = model.fit(data, parameters=far(factor), seeds="identify", **options)
    assert found.converged
    assert found.iterations <= 8
    assert found.sigma == pytest.approx(noise, rel=0.1)
    for name in UNKNOWN:
        assert abs(found.parameters[name] - TRUE[name]) < 4.5 * found.standard_errors[name]
    # the same minimum as from the truth
    near = model.fit(data, **options)
    assert found.cost == pytest.approx(near.cost, rel=1e-6)
    if factor > 1:
        with pytest.warns(SolveWarning, match="no progress|not converged|breaks down"):
            lost = model.fit(data, parameters=far(factor), most=20, **options)
        print(f"sigma {found.sigma:.2g} in {found.iterations} iterations; alone {lost.sigma:.2g}")
        assert lost.sigma > 10 * found.sigma


def test_an_identification_of_the_user() -> None:
    """With a filter of one's own; what is known stays, and inputs may be columns of the data."""
    model = arm()
    data = run(model, 1e-3) | {name: column for name, (_, column) in MOTORS.items()}
    known = far(5.0) | {"lower.d": 0.2}
    start = model.with_parameters(known)
    seeds = start.identify(data, cutoff=8.0)
    some = tuple(name for name in UNKNOWN if name != "lower.d")
    found = start.fit(data, unknown=(*some, "x0"), seeds=seeds)
    assert found.converged
    assert "lower.d" not in found.parameters
    assert found.model.parameters["lower.d"] == 0.2
    for name in some:
        assert found.parameters[name] == pytest.approx(TRUE[name], rel=0.02)


def test_seeds_stay_within_bounds() -> None:
    model = arm()
    data = run(model, 1e-4)
    found = model.fit(
        data, unknown=(*UNKNOWN, "x0"), inputs=MOTORS, parameters=far(10.0), seeds="identify",
        bounds={"lower.m": (1.5, 2.0)},
    )  # fmt: skip
    assert found.parameters["lower.m"] == 1.5


def test_where_identification_says_nothing() -> None:
    model = arm()
    data = run(model, 1e-4)
    options: dict[str, Any] = {"unknown": (*UNKNOWN, "x0"), "inputs": MOTORS}
    with pytest.raises(ArgumentError, match="seeds='guess': give 'identify'"):
        model.fit(data, seeds="guess", **options)
    upper = {name: data[name] for name in ("t", "upper_joint")}
    with pytest.raises(ArgumentError, match=r"seeds: identification needs all .*'lower_joint'"):
        model.fit(upper, seeds="identify", **options)
    with pytest.raises(ArgumentError, match=r"no unknown of gravity\.z is a mass"):
        model.fit(data, unknown="gravity.z", inputs=MOTORS, seeds="identify")
    with pytest.raises(ArgumentError, match=r"input 'upper.tau' is a function"):
        model.fit(data, **options | {"inputs": {"upper.tau": np.sin}}, seeds="identify")
    # a motion without known forces would fit a model without mass
    with pytest.raises(ArgumentError, match=r"seeds='identify': .*there are no forces"):
        free().fit(free_run(), unknown=("m", "d"), seeds="identify")
    # a joint that hardly moves tells nothing
    still = data | {"lower_joint": np.zeros(len(TIMES)), "upper_joint": np.zeros(len(TIMES))}
    with pytest.raises(SolveError, match="seeds='identify': the data do not tell"):
        model.fit(still, seeds="identify", **options)
    with pytest.raises(ArgumentError, match="whose bodies and forces are others"):
        free().fit(free_run(), unknown="m", seeds=model.identify(data | columns()))
    with pytest.raises(ModelError, match="no function 'regressor'"):
        arm(functions=("rhs",)).fit(data, seeds="identify", **options)


def columns() -> dict[str, Any]:
    return {name: column for name, (_, column) in MOTORS.items()}


def free() -> cd.CompiledModel:
    """A bar that swings freely: known up to a factor."""
    scene = cd.Scene("bar", gravity=(0, 0, -9.81))
    m, d = scene.parameter("m", 2.0), scene.parameter("d", 0.2)
    bar = scene.body("bar", mass=m, com=(0, 0, -0.5), inertia=cd.inertia.rod(m, 1.0, axis="z"))
    scene.joint("y", cd.Revolute("y"), scene.ground, bar)
    scene.force("bearing", cd.JointDamper("y", d))
    return cd.compile(scene)


def free_run() -> dict[str, Any]:
    t = np.linspace(0, 3, 200)
    return {"t": t, "y": free().simulate(t, q={"y": 1.0}, rtol=1e-10)["y"]}


def test_a_start_that_nobody_named_begins_where_it_was_measured() -> None:
    """One run, from the other side of the pendulum, would go wrong."""
    model = free()
    data = free_run()
    found = model.fit(data, unknown=("d", "x0"), parameters={"d": 0.3}, segments=1)
    assert found.converged
    assert found.iterations <= 6
    assert found.start == pytest.approx([1.0, 0.0], abs=1e-6)
    # what was named and is no unknown stays
    held = model.fit(data, unknown="d", q={"y": 0.9}, u={"y": 0.05}, segments=1)
    assert held.start.tolist() == [0.9, 0.05]


def test_samples_at_times_of_their_own() -> None:
    """Channels that were sampled in turns, and one that begins late."""
    model = arm()
    data = run(model, 1e-4)
    data["upper_joint"][::2] = np.nan
    data["lower_joint"][1::2] = np.nan
    data["lower_joint"][:30] = np.nan
    found = model.fit(data, unknown=("lower.m", "x0"), inputs=MOTORS, parameters={"lower.m": 1.5})
    assert found.converged
    assert found.parameters["lower.m"] == pytest.approx(1.2, rel=1e-3)
    assert found.freedom == 201 - 1 + 200 - 14 - 5
