"""Reports of paths: residuals computed anew see what is wrong, and costs are counted."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from analyses.test_continuation import truss, two_links
from cycle_scenes import duffing
from mechanisms.change_points import windows


def test_equilibria(capsys: pytest.CaptureFixture[str]) -> None:
    path = truss(3.0).continuation(P=(0, 1), branches=1)
    report = path.report()
    assert "truss: paths of equilibria" in capsys.readouterr().out
    assert [row.name for row in report.rows] == [*path.branches]
    for row, branch in zip(report.rows, path.branches.values(), strict=True):
        assert (row.points, row.iterations, row.refused) == (
            len(branch), branch.iterations, branch.refused,
        )  # fmt: skip
        assert row.special_points == len(branch.points)
        assert 0 < row.milliseconds < 1e4
        assert 0 <= row.contraction < 1
        assert row.residual < 1e-12
        assert row.unchecked == 0
    assert report.residual == max(row.residual for row in report.rows)
    assert repr(report).startswith("PathReport('truss': 6 branches of equilibria, residual ")


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_wrong_position_is_seen(coordinates: str) -> None:
    """Moved off by 1e-6 of the size a point misses its equations by as much, times stiffness."""
    path = two_links(coordinates).continuation(P=(0, 1.5))
    assert path.report().residual < 1e-12
    family, curve = path.main.solutions.family, path.main.curve
    off = np.zeros(len(family.weights))
    off[: family.positions] = 1e-6
    curve.places[3] = replace(curve.places[3], point=family.moved(curve.places[3].point, off))
    assert 1e-8 < path.report().residual < 1e-5
    row = path.report().rows[0]
    assert row.where["P"] == pytest.approx(path["P"][3])


def test_a_stiff_part_hides_nothing_in_a_soft_one() -> None:
    scene = cd.Scene("pair", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    for name, stiffness in (("soft", 1.0), ("stiff", 1e12)):
        scene.joint(name, cd.Prismatic("x"), scene.ground, scene.body(f"{name}_body", mass=1.0))
        scene.force(f"{name}_spring", cd.JointForce(name, load - stiffness * scene.q(name)))
    path = cd.compile(scene).continuation(P=(0, 1))
    assert path.report().residual < 1e-12
    family, curve = path.main.solutions.family, path.main.curve
    off = np.zeros(len(family.weights))
    off[0] = 1e-5
    curve.places[2] = replace(curve.places[2], point=family.moved(curve.places[2].point, off))
    assert path.report().residual == pytest.approx(1e-5, rel=1.0)


def test_positions_of_overconstrained_loops() -> None:
    path = windows(2, 1, 2).continuation(A0=(0.3, 7.0), of="positions", branches=1)
    report = path.report()
    assert report.kind == "positions"
    assert report.residual < 1e-11
    curve, shift = path.main.curve, np.array([1e-5, *np.zeros(path.model.nq - 1)])
    point = curve.places[2].point
    curve.places[2] = replace(curve.places[2], point=replace(point, q=point.q + shift))
    assert 1e-6 < path.report().residual < 1e-4


def test_cycles_by_another_method() -> None:
    model, omega = duffing()
    options: dict[str, Any] = {"period": 2 * sp.pi / omega, "settle": 20}
    cycle = model.cycle({"x": 0.6}, **options, parameters={"omega": 0.7})
    path = model.continuation(omega=(0.7, 0.9), of="cycles", start=cycle)
    report = path.report()
    assert "RK45 at rtol=1e-12" in report.note
    assert 0 < report.residual < 1e-9
    # one lap that cannot be computed is counted, and no number stands for it
    curve = path.main.curve
    broken = curve.places[1].point
    at = replace(broken.at, x=np.array([1e200, 0.0]))
    curve.places[1] = replace(curve.places[1], point=replace(broken, at=at))
    row = path.report().rows[0]
    assert row.unchecked == 1
    assert row.residual < 1e-9
