"""Starts with beams that named positions strain."""

from __future__ import annotations

import pytest

import cardan as cd


def test_a_tip_is_pulled_where_no_joint_can_move() -> None:
    scene = cd.Scene("blade", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=6.0 * cd.t)
    tip = scene.body("tip", mass=1.0, inertia=(1e-3, 1e-3, 1e-3), pose=(1, 0, 0))
    section = cd.section.general(EA=1e5, GA=1e5, GJ=1.0, EI=1.0, rhoA=0.1, rhoI=1e-6)
    scene.beam("blade", hub, tip, section, elements=1)
    model = cd.compile(scene)
    x = model.simulate(1e-4, q={"tip.px": 1.001}, method="GeneralizedAlpha").x[0]
    start = dict(zip(model.coordinates, x, strict=False))
    assert start["tip.px"] == pytest.approx(1.001, abs=1e-12)
    # the work of the stretch, EA e^2 / 2
    assert model.energy(*model.split(x)).potential == pytest.approx(0.05, rel=1e-6)
