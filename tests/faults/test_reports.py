"""Faults of reports and of forces along motions."""

from __future__ import annotations

import re

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.simulation.precision.runs import precision
from cardan.runtime.calls import samples


@pytest.mark.slow
def test_b5_stiff_scenes_have_a_reference_of_implicit_runs() -> None:
    """``report`` of a beam slider-crank: "no reference: RK45 ... takes more than 50 s"."""
    scene = cd.Scene("slider_crank", gravity=(0, 0, 0))
    crank = scene.body("crank", mass=0.36, com=(0.075, 0, 0), inertia=(0.002, 0.003, 0.003))
    slider = scene.body("slider", mass=0.08, pose=(0.45, 0, 0))
    # from rest and smooth, so that vibrations nobody resolves stay asleep
    scene.joint("drive", cd.Revolute("z"), scene.ground, crank, prescribed=200 * cd.t**3)
    scene.joint("guide", cd.Prismatic("x"), scene.ground, slider)
    # damping that no explicit method gets over: DOP853 needs some 1e7 steps
    steel = cd.material(E=2e11, nu=0.3, rho=7870, damping=1e-3)
    section = cd.section.rectangle(0.008, 0.008)
    ends = {"release_start": "rz", "release_end": "rz"}
    scene.beam("rod", crank.at(0.15, 0, 0), slider, section, steel, elements=2, **ends)
    model = cd.compile(scene)
    made = precision(model, 0.1, ["GeneralizedAlpha"], patience=0.2)
    said = r"GeneralizedAlpha.* and HHT in steps of .* extrapolated to 0, which differ by "
    assert re.match(said, made.reference)
    assert re.search(r"DOP853 at rtol 1e-1\d would take more than 2 s", made.reference)
    assert f"differ by {made.doubt:.0e}" in made.reference
    assert made.doubt < 1e-7
    # errors are those against a run at far tighter tolerances
    times = np.linspace(0, 0.1, 41)
    point = made.points[4]
    rough, fine = (
        model.simulate(times, method="GeneralizedAlpha", rtol=rtol, atol=1e-3 * rtol).q
        for rtol in (point.value, 1e-11)
    )
    assert point.error == pytest.approx(np.abs(rough - fine).max(), rel=0.05)


def test_b10_torques_keep_all_times_and_identify_takes_them() -> None:
    """``torques`` dropped samples at the ends: ``identify`` refused its 1989 of 2001."""
    scene = cd.Scene("arm")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    scene.force("loss", cd.JointDamper("pivot", 0.3))
    model = cd.compile(scene)
    t = np.linspace(0, 10, 2001)
    q = 0.7 * np.sin(2 * t) + 0.3 * np.cos(5 * t)
    made = model.torques({"t": t, "pivot": q})
    assert len(made.t) == len(t)
    u, udot = 1.4 * np.cos(2 * t) - 1.5 * np.sin(5 * t), -2.8 * np.sin(2 * t) - 7.5 * np.cos(5 * t)
    exact = model.inverse_dynamics(q[:, None], u[:, None], udot[:, None])
    # the ends too: a spline of degree 5 differentiated twice, step 5e-3, fifth derivative 1e3
    np.testing.assert_allclose(made.forces, exact, atol=1e-5)
    # work is that of the whole motion: 30 ms less at each end were 9 % of it in docs/identification
    power = (exact * u[:, None]).sum(axis=1)
    assert made.work.sum() == pytest.approx(np.trapezoid(power, t), rel=1e-6)
    found = model.identify({"t": t, "pivot": q, "pivot.tau": made["pivot"]})
    assert found is not None


def test_e8_functions_of_parameters_alone_are_measured_in_room_for_all_calls() -> None:
    """``report`` wrote results of 1024 calls into room for one: the heap was overwritten."""
    scene = cd.Scene("one")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    model = cd.compile(scene)
    model.inertial_parameters()
    (function,) = model._load([("inertial_parameters", None)])
    assert function.caller.arguments == ()
    assert len(samples.states(function, {}, 1024).out) == 1024
    assert "inertial_parameters" in {row.function for row in model.report().rows}
