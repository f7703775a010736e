"""States that runs begin with: beams on bodies away from the origin are not strained by it."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from mechanisms.flexible import folding_arm, slider_crank


def test_beams_on_bodies_stand_as_in_the_reference() -> None:
    scene = folding_arm(elements=2)
    model = cd.compile(scene)
    q, u, *_ = model.split(model.initial())
    np.testing.assert_allclose(model.pose("outer.start", q)[:3, 3], [2, 0, 0], atol=1e-15)
    np.testing.assert_allclose(model.pose("outer.end", q)[:3, 3], [2.5, 0, 0], atol=1e-15)
    # the spring alone acts: 4 N m on a node of about 1e-4 kg m^2; a strain of 1e-5 would do more
    assert np.abs(model.forward_dynamics(q, u)).max() < 1e5


@pytest.mark.parametrize("angle", [0.7, -2.0])
def test_beams_go_along_with_bodies_that_joints_turn(angle: float) -> None:
    model = cd.compile(folding_arm(elements=2))
    q, *_ = model.split(model.initial(q={"hinge": angle}))
    along = np.array([np.cos(angle), np.sin(angle), 0])
    tip = model.pose("outer.end", q)
    np.testing.assert_allclose(tip[:3, 3], [1, 0, 0] + 1.5 * along, atol=1e-14)
    np.testing.assert_allclose(tip[:3, 0], along, atol=1e-14)


def test_speeds_go_over_from_one_end_of_a_beam_to_the_other() -> None:
    model = cd.compile(slider_crank(elements=2))
    # both hinges of the rod are named and stand still: it has to bend
    q, u, *_ = model.split(model.initial(u={"rod.start": 0.0, "rod.end": 0.0}))
    # the crank turns at 150 rad/s, the slider does not move: the middle, 0.3 m from the pivot,
    # has the mean of what either end would give it, though a named node is there
    start, middle = (model.velocity(name, q, u)[4] for name in ("rod.start", "rod.at1"))
    assert start == pytest.approx(150 * 0.15)
    assert middle == pytest.approx(150 * 0.3 / 2)


def test_bodies_on_the_ends_of_beams_go_along_and_carry_the_next() -> None:
    scene = cd.Scene("boom", gravity=(0, 0, -9.81))
    section = cd.section.general(EA=1e5, GA=1e5, GJ=100, EI=100, rhoA=1, rhoI=1e-3)
    hub, bob = (scene.body(name, mass=1, inertia=(0.1, 0.1, 0.1)) for name in ("hub", "bob"))
    scene.joint("root", cd.Revolute("y"), scene.ground, hub, q0=0.3, u0=2.0)
    boom = scene.beam("boom", hub, (1, 0, 0), section=section, elements=3)
    scene.joint("pin", cd.Revolute("y"), boom.end, bob, q0=0.2, u0=0.5)
    scene.beam("jib", bob.at(0.1, 0, 0), (1, 0, 0.5), section=section, elements=2)
    model = cd.compile(scene)
    q, u = model.split(model.initial())
    assert np.abs(model.constraints(q)).max(initial=0) < 1e-14
    assert np.abs(model.constraint_rates(q, u)).max(initial=0) < 1e-13
    turned = model.pose("bob", q)
    assert np.arctan2(turned[0, 2], turned[0, 0]) == pytest.approx(0.3 + 0.2)
    for name in ("boom", "jib"):
        assert np.abs(model.beam(name, q).force).max() < 1e-9, name
    # turning with the root, and with the pin besides
    assert model.velocity("bob", q, u)[:3] == pytest.approx([0, 2.5, 0])
    assert model.velocity("boom.end", q, u)[3:] == pytest.approx(
        np.cross([0, 2.0, 0], model.pose("boom.end", q)[:3, 3])
    )


def test_a_run_that_folds_an_element_says_so() -> None:
    """A soft rod between a driven hub and a wall: its elements are twisted beyond half a turn."""
    scene = cd.Scene("fold", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("drive", cd.Revolute("x"), scene.ground, hub, prescribed=2.0 * cd.t)
    section = cd.section.general(EA=100, GA=100, GJ=1, EI=1, rhoA=0.1, rhoI=1e-3)
    scene.beam("rod", hub, scene.ground.at(1, 0, 0), section, elements=1)
    model = cd.compile(scene)
    # to 2.8 rad by the law of a bar in torsion, without a warning
    motion = model.simulate(np.linspace(0, 1.4, 34))
    assert motion.energy[1][-1] == pytest.approx(2.8**2 / 2)
    with pytest.warns(cd.SolveWarning, match=r"element of beam 'rod' is bent by 17\d degrees"):
        model.simulate(np.linspace(0, 1.7, 34))
