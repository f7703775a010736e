"""Rigid trees as one element, on the ground and on nodes: the same as in joint coordinates."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest

import cardan as cd
from cardan.equations.finite_elements.lowering import lowered
from cardan.equations.finite_elements.record import FiniteElementRecord
from cardan.topology import build
from equations.finite_elements.cases import Both, State
from equations.finite_elements.reference import Reference
from equations.finite_elements.test_circuits import agree, circuit, pair
from equations.finite_elements.test_tangents import CHOSEN, tangents_agree
from laws.cases import derived, states
from laws.circuits import EVERY
from laws.test_cut_joints import INSTANCES
from mechanisms import ZOO
from spread import some

Nodes = Callable[[int], range]
# bodies that have nodes: none, so that all is one tree; or some, so that trees hang on nodes and
# carry them
NODES: dict[str, Nodes] = {
    "none": lambda n: range(0),
    "even": lambda n: range(0, n, 2),
    "odd": lambda n: range(1, n, 2),
}
ROUNDING = 400


def with_trees(system: object, choice: str) -> FiniteElementRecord:
    """Equations where some bodies have nodes and joints place the others."""
    bodies = len(system.bodies)  # type: ignore[attr-defined]
    return lowered(system, nodes=frozenset(NODES[choice](bodies)))  # type: ignore[arg-type]


@cache
def at(name: str, choice: str) -> list[State]:
    equations = derived(name)
    own = Both(equations, with_trees(equations.system, choice))
    return [own.at(q, u) for q, u in zip(*states(name), strict=True)]


@pytest.mark.parametrize("choice", NODES)
@pytest.mark.parametrize("name", some(ZOO, 6))
def test_mechanisms(name: str, choice: str) -> None:
    for state in at(name, choice):
        relative, absolute = state.both.relative, state.both.absolute
        udot, _, error = state.solved
        bound = ROUNDING * max(error, 4 * np.finfo(float).eps)
        size = 1 + np.abs(state.udot).max(initial=0)
        for k, speed in enumerate(relative.speeds):
            assert abs(udot[absolute.speeds.index(speed)] - state.udot[k]) < bound * size, speed
        mine, other = state.accelerations()
        assert np.abs(mine - other).max(initial=0) < bound * (1 + np.abs(other).max(initial=0))
        wrenches, expected = state.reactions()
        largest = 1 + max((np.abs(w).max() for w in expected.values()), default=0)
        for joint, wrench in wrenches.items():
            assert np.abs(wrench - expected[joint]).max() < bound * largest, joint
        for function in ("energy", "momentum"):
            sums = state.reference.sum(function)
            for key, value in state.both.call(function, q=state.q, u=state.u).items():
                if key in sums:
                    assert np.abs(sums[key] - value).max() < 1e-12 * (1 + np.abs(value).max())


def test_a_tree_has_the_coordinates_of_its_joints_alone() -> None:
    absolute = with_trees(derived("spatial_chain").system, "none")
    assert absolute.coordinates == tuple(derived("spatial_chain").coordinates)
    assert [group.kind.name for group in absolute.groups] == ["tree"]


@pytest.mark.parametrize("choice", NODES)
@pytest.mark.parametrize("name", some(EVERY, 8, 1))
def test_loops(name: str, choice: str) -> None:
    state = circuit(name)
    relative = state.both.relative
    agree(Both(relative, with_trees(relative.system, choice)).at(state.q, state.u))


@pytest.mark.parametrize("choice", NODES)
@pytest.mark.parametrize("name", some(INSTANCES, 6))
def test_every_joint_in_a_tree_and_closing_a_loop(name: str, choice: str) -> None:
    own = pair(name, False)
    agree(Both(own.tree, with_trees(own.tree.system, choice)).at(own.q, own.u))
    for back in (False, True):
        own = pair(name, back)
        agree(Both(own.cut, with_trees(own.cut.system, choice)).at(*own.floating))


@pytest.mark.parametrize("choice", NODES)
@pytest.mark.parametrize("name", some(CHOSEN, 8, 1))
def test_tangents(name: str, choice: str) -> None:
    tangents_agree(Reference(with_trees(build(CHOSEN[name]()), choice), None, None))  # type: ignore[arg-type]


def test_bodies_at_ends_of_beams_have_nodes_where_no_joint_carries_them() -> None:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=1, com=(0.2, 0, 0), inertia=(0.1, 0.1, 0.1))
    lower = scene.body("lower", mass=1, com=(0.2, 0, 0), inertia=(0.1, 0.1, 0.1))
    tool = scene.body("tool", mass=0.1, inertia=(1e-3, 1e-3, 1e-3), pose=(1.3, 0, 0))
    scene.joint("shoulder", cd.Revolute("z"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("z"), upper.at(0.4, 0, 0), lower)
    steel = cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("rod", lower.at(0.4, 0, 0), tool, cd.section.circle(0.01), steel, elements=2)
    equations = cd.derive(scene)
    names = equations.places.names
    assert {"shoulder", "elbow", "tool"} <= set(names)
    assert not {"upper", "lower"} & set(names)
    assert equations.tree_joints == ("shoulder", "elbow")
    assert not equations.multipliers


@pytest.mark.parametrize("count", [3, 13])
def test_ends_of_beams_that_many_or_prescribed_joints_carry_have_nodes(count: int) -> None:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    place = scene.ground
    for k in range(count):
        link = scene.body(f"link{k}", mass=1, com=(0.2, 0, 0), inertia=(0.1, 0.1, 0.1))
        driven = 0.3 * cd.t if k == 1 and count == 3 else None
        scene.joint(f"hinge{k}", cd.Revolute("y"), place, link, prescribed=driven)
        place = link.at(0.4, 0, 0)
    steel = cd.material(E=2e11, nu=0.3, rho=7800)
    end = (0.4 * count + 0.5, 0, 0)
    scene.beam("rod", place, end, cd.section.circle(0.01), steel, elements=2)
    equations = cd.derive(scene)
    assert f"link{count - 1}" in equations.places.names
    assert len(equations.multipliers) == 6
