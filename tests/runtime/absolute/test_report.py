"""The report of a model with beams: functions of the mesh, and its elements one by one."""

from __future__ import annotations

import math

import pytest

import cardan as cd


def bracket(load: float = 10.0) -> cd.Scene:
    """A beam of three elements on a turning column."""
    scene = cd.Scene("bracket", gravity=(0, 0, -9.81))
    column = scene.body("column", mass=5.0, inertia=cd.inertia.box(5.0, 0.1, 0.1, 1.0))
    scene.joint("slew", cd.Revolute("z"), scene.ground, column)
    section = cd.section.general(EA=4e6, GA=2e6, GJ=2e3, EI=2e3, rhoA=2.0, rhoI=1e-4)
    arm = scene.beam("arm", column, (1, 0, 0), section=section, elements=3)
    scene.force("weight", cd.Force(arm.end, (0, 0, -load)))
    return scene


def test_elements_are_measured(capsys: pytest.CaptureFixture[str]) -> None:
    model = cd.compile(bracket())
    report = model.report()
    rows = {row.function: row for row in report.rows}
    element = rows["hellinger_reissner__balance_tangent"]
    counts = cd.derive(bracket()).operations["hellinger_reissner__balance_tangent"]
    assert element.operations == counts.total
    for row in report.rows:
        if "__" in row.function:
            assert row.call_ns > 0
            assert row.error is not None
            assert row.error < 1e-12, row.function
            assert math.isnan(row.python_ns)
            assert row.lanes == 1
        else:
            assert row.python_ns > 0
            # three elements do three times the work of one
            assert row.operations > 3 * 100
    assert {"rhs", "inverse_dynamics", "energy", "linked_inertia__balance"} <= rows.keys()
    assert "one element" in capsys.readouterr().out
