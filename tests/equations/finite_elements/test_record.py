"""What absolute equations say about themselves, and what they refuse."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.equations.finite_elements.record import FiniteElementRecord
from cardan.ir.interpreter import evaluate
from equations.finite_elements.reference import Reference
from laws.cases import values
from mechanisms import ZOO


def scene(name: str) -> FiniteElementRecord:
    return cd.derive(ZOO[name].build(), coordinates="absolute")


def test_joints_keep_their_names_and_nodes_have_those_of_bodies() -> None:
    found = scene("double_pendulum")
    joints = tuple(found.system.joints)
    assert {joint.name for joint in joints} <= set(found.coordinates)
    assert {f"{joint.name}.u" for joint in joints} <= set(found.speeds)
    for body in found.system.bodies:
        assert f"{body.name}.px" in found.coordinates
    assert len(found.coordinates) == found.places.nq
    assert len(found.speeds) == found.places.nu


def test_a_node_gives_way_to_a_joint_of_its_name() -> None:
    model = cd.Scene("same")
    arm = model.body("arm", mass=1.0, inertia=(1, 1, 1))
    model.joint("arm", cd.Revolute("z"), model.ground, arm)
    found = cd.derive(model, coordinates="absolute")
    assert found.coordinates[:2] == ("arm", "arm.node.qw")


def test_a_free_joint_is_its_node() -> None:
    found = scene("free_quaternion")
    free = next(j for j in found.system.joints if j.element.kind == "free")
    assert found.coordinates[:7] == tuple(f"{free.name}.{c.name}" for c in free.element.coordinates)
    assert free.name not in found.joints


def test_like_elements_are_derived_once() -> None:
    model = cd.Scene("chain", gravity=(0, 0, -9.81))
    last = model.ground
    for k in range(12):
        link = model.body(f"link{k}", mass=1.0 + k, com=(0, 0, -0.1), inertia=(1, 2, 2 + k / 20))
        place = last if k == 0 else last.at(0, 0, -0.3 - k)
        model.joint(f"joint{k}", cd.Revolute("y"), place, link)
        last = link
    found = cd.derive(model, coordinates="absolute")
    assert [(group.kind.name, len(group)) for group in found.groups] == [
        ("body", 12),
        ("revolute", 1),
        ("revolute_2", 11),
    ]


def test_print_shows_every_kind_with_its_counts() -> None:
    found = scene("drives")
    text = str(found)
    for group in found.groups:
        assert group.kind.name in text
        assert str(found.operations[group.kind.c_name("balance")].total) in text


def test_sources_name_the_formulation_and_the_joints() -> None:
    found = scene("universal").sources
    assert any("Géradin" in source for source in found)
    joint = next(j for j in scene("universal").system.joints if j.element.kind == "universal")
    assert joint.element.source in found


def test_what_is_not_offered_names_the_next_call() -> None:
    found = scene("pendulum")
    with pytest.raises(cd.DerivationError, match=r"coordinates='relative'\).mass_matrix"):
        _ = found.mass_matrix
    with pytest.raises(AttributeError, match="mass_matrx"):
        _ = found.mass_matrx  # type: ignore[attr-defined]


def test_unknown_kinds_and_functions_are_named() -> None:
    found = scene("pendulum")
    with pytest.raises(cd.DerivationError, match="Did you mean 'revolute'"):
        found.function("revolut", "balance")
    with pytest.raises(cd.DerivationError, match="Did you mean 'balance'"):
        found.function("revolute", "balanc")


def test_options_of_joint_coordinates_are_refused() -> None:
    model = ZOO["pendulum"].build()
    with pytest.raises(cd.DerivationError, match="method=: for joint coordinates only"):
        cd.derive(model, coordinates="absolute", method="kane")  # type: ignore[call-overload]
    with pytest.raises(cd.DerivationError, match="Did you mean 'absolute'"):
        cd.derive(model, coordinates="absolut")  # type: ignore[call-overload]


def test_rows_of_positions_come_first() -> None:
    model = cd.Scene("two")
    for name in ("left", "right"):
        disk = model.body(name, mass=1.0, inertia=(1, 2, 1))
        model.joint(f"{name}.rolls", cd.RollingDisk(0.3), model.ground, disk)
    found = cd.derive(model, coordinates="absolute")
    slips = [name for name in found.multipliers if name.endswith(("itudinal", "lateral"))]
    assert found.multipliers[found.mp :] == tuple(slips)
    assert len(slips) == 4
    (group,) = (group for group in found.groups if group.kind.m)
    assert group.rows.tolist() == [[0, 12], [6, 14]]


def test_data_follow_parameters() -> None:
    """What members share is derived once, whatever their numbers."""
    model = ZOO["springs"].build()
    relative, absolute = (cd.derive(model, coordinates=c) for c in ("relative", "absolute"))
    rng = np.random.default_rng(4)
    p = np.array([entry.value for entry in relative.system.parameters])
    p = p * rng.uniform(0.8, 1.2, len(p))
    q, u = rng.uniform(0.1, 0.5, (2, relative.system.nq))
    given = values(relative, q=q, u=u, p=p)
    state = evaluate(absolute.states, given, "numpy")
    reference = Reference(absolute, state["q"], state["u"], t=0.3)
    reference.p = p
    udot, _, bound = reference.solved()
    expected = evaluate(relative.function("forward_dynamics"), given, "numpy")["udot"]
    mine = [absolute.speeds.index(name) for name in relative.speeds]
    assert np.abs(udot[mine] - expected).max() < 100 * bound * (1 + np.abs(expected).max())
