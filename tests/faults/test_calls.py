"""Faults of calls: arguments of the wrong kind, and results that were worth a word."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd

CALLS: dict[str, tuple[Callable[[cd.CompiledModel], Any], str]] = {
    "assemble": (lambda m: m.assemble(np.inf), "assemble: targets=inf: give values by name"),
    "workspace": (lambda m: m.workspace({"nope": 1}), "workspace: frame={'nope': 1}: give text"),
    "with_parameters": (
        lambda m: m.with_parameters([1, 2]),
        "with_parameters: values=.1, 2.: give",
    ),
    "simulate": (
        lambda m: m.simulate(0.1, atol=np.ones(2)),
        "simulate: atol=array.*: give a number",
    ),
    "sweep": (lambda m: m.sweep([1, 2]), "sweep: driver=.1, 2.: give text"),
    "root_locus": (lambda m: m.root_locus("q"), "root_locus: swept='q': give values by name"),
    "partition": (lambda m: m.partition("x"), "partition: q='x': give a number"),
    "random_state": (lambda m: m.random_state(shape="x"), "random_state: shape='x': give whole"),
    "released": (lambda m: m.redundancy().released([1]), "released: joint=.1.: give text"),
    "regressor": (lambda m: m.base_parameters().regressor(1.0), "regressor Y: shape .., expected"),
    "reaction": (lambda m: m.reaction(["pivot"], [0.0], [0.0]), "reaction: .*=.'pivot'.: give"),
}


@pytest.fixture(scope="module")
def pendulum() -> cd.CompiledModel:
    scene = cd.Scene("pendulum")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    return cd.compile(scene)


@pytest.mark.parametrize("name", CALLS)
def test_e8_arguments_of_the_wrong_kind_are_named(name: str, pendulum: cd.CompiledModel) -> None:
    """AttributeError, TypeError and ValueError of ours reached the caller in 53 places."""
    call, words = CALLS[name]
    with pytest.raises(cd.ArgumentError, match=words):
        call(pendulum)


@pytest.mark.parametrize("how", [{"rtol": 1, "atol": 10}, {"method": "RK4", "step": 1.0}])
def test_e9_rough_runs_say_what_they_lost(how: dict[str, Any], pendulum: cd.CompiledModel) -> None:
    """Runs ended as finished, 157 J and 216,666 J off, on a body of 1 kg."""
    with pytest.warns(cd.SolveWarning, match="J of energy unaccounted for, where .* was exchanged"):
        motion = pendulum.simulate(100, q={"pivot": 2.0}, **how)
    total = motion.energy.total
    assert np.ptp(total) > 1


def test_a_required_frame_is_none() -> None:
    scene = cd.Scene("none")
    ball = scene.body("ball", mass=1.0)
    scene.joint("slide", cd.Prismatic("z"), scene.ground, ball)
    scene.force("push", cd.Force(None, (0, 0, 1)))
    with pytest.raises(cd.ModelError, match="force 'push': frame None does not exist"):
        cd.derive(scene)


def test_steps_and_reports_name_what_does_not_fit() -> None:
    scene = cd.Scene("named")
    ball = scene.body("ball", mass=1.0)
    scene.joint("slide", cd.Prismatic("z"), scene.ground, ball)
    model = cd.compile(scene)
    with pytest.raises(cd.ArgumentError, match="show='x': give a function"):
        model.report(show="x")
    with pytest.raises(cd.SolveError, match="max_step=1e-300 s does not change the time"):
        model.simulate(1.0, max_step=1e-300, check=True)


def test_a_function_that_the_system_cannot_have_is_not_to_be_asked_for() -> None:
    scene = cd.Scene("slider")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", mass=1.0))
    model = cd.compile(scene)
    with pytest.raises(cd.DerivationError, match="nothing binds the speeds of 'slider'"):
        model.constraints([0.0])
    with pytest.raises(cd.DerivationError, match="was not asked for"):
        cd.compile(scene, functions=["energy"]).mass_matrix([0.0])


def test_arguments_have_the_names_of_the_signature(pendulum: cd.CompiledModel) -> None:
    """Messages spoke of blocks: of 'e' for events, of q for q1."""
    with pytest.raises(cd.ArgumentError, match=r"difference: q1 has shape \(2,\)"):
        pendulum.difference([0.0], [0.0, 1.0])
    scene = cd.Scene("cantilever")
    section, steel = cd.section.tube(0.05, 0.04), cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("beam", scene.ground, (1.0, 0, 0), section, steel, elements=1)
    beam = cd.compile(scene)
    q, u = beam.split(beam.initial())
    with pytest.raises(cd.ArgumentError, match=r"transition: events has shape \(1,\)"):
        beam.transition(q, u, [1.0])
    # there are none
    np.testing.assert_array_equal(beam.transition(q, u, None), beam.transition(q, u, []))
    with pytest.raises(cd.ArgumentError, match=r"motion: amplitude=1e\+300: states of that size"):
        beam.modes().motion(0, amplitude=1e300)


def test_a_model_takes_its_own_functions_from_a_shared_folder() -> None:
    def model(*functions: str) -> cd.CompiledModel:
        scene = cd.Scene("shared_folder")
        rod = scene.body("rod", mass=1.25, com=(0, 0, -0.5))
        scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
        return cd.compile(scene, functions=functions)

    model("rhs", "energy").prepare()
    other = model("rhs", "mass_matrix")
    assert {row.function for row in other.report().rows} == {"rhs", "mass_matrix"}
    other.prepare()
