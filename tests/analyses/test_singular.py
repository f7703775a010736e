"""Singular positions, workspaces and redundant constraints of mechanisms with known ones."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from mechanisms.change_points import windows
from mechanisms.closed_planar import FOUR_BAR, four_bar, slider_crank, slider_crank_coordinates
from mechanisms.closed_spatial import bricard, bricard_angles, stewart, stewart_coordinates


@pytest.fixture(scope="module")
def bars() -> cd.CompiledModel:
    return cd.compile(four_bar())


def test_dead_points_of_a_rocker(bars: cd.CompiledModel) -> None:
    """The rocker stands still where crank and coupler lie on one line."""
    found = bars.singular_positions("A", (0.2, 0.2 + 2 * math.pi), driver="D", branch={"D": "+"})
    a, b, c, d = (FOUR_BAR[name] for name in ("crank", "coupler", "rocker", "ground"))
    stretched = math.acos(((b + a) ** 2 + d**2 - c**2) / (2 * (b + a) * d))
    folded = math.acos(((b - a) ** 2 + d**2 - c**2) / (2 * (b - a) * d)) + math.pi
    np.testing.assert_allclose(found.values(), [stretched, folded], rtol=0, atol=1e-9)
    assert [p.kind for p in found.positions] == ["dead point", "dead point"]
    # the crank itself is never dead
    assert len(bars.singular_positions("A", (0.2, 6.4), branch={"D": "+"})) == 0


def test_dead_ends_of_a_range(bars: cd.CompiledModel) -> None:
    """Driven at the rocker the mechanism turns round at both ends of the rocker's swing."""
    found = bars.singular_positions("D", (2.0, 4.0), start={"A": 0.5, "B": -0.1, "D": 2.0})
    assert "closed" in found.ended or "left" in found.ended
    assert found.values()[0] == pytest.approx(2.6811, abs=1e-4)


def test_workspace_of_a_coupler(bars: cd.CompiledModel, tmp_path: Path) -> None:
    over, open_branch = {"A": (-math.pi, math.pi)}, {"D": "+"}
    found = bars.workspace("C.parent", over=over, samples=120, branch=open_branch)
    # the tip of the rocker stays on its circle, above the ground
    from_pivot = found.points - [FOUR_BAR["ground"], 0, 0]
    np.testing.assert_allclose(np.linalg.norm(from_pivot, axis=1), 0.2, rtol=0, atol=1e-12)
    assert (found.points[:, 1] > 0).all()
    assert len(found) > 100
    swing = np.arctan2(from_pivot[:, 1], from_pivot[:, 0])
    assert 1.63 < swing.min() < swing.max() < 2.682
    assert found.box.shape == (2, 3)
    assert "of 120 samples" in repr(found)
    found.plot(tmp_path / "space.png")
    assert (tmp_path / "space.png").stat().st_size > 1000
    # from anywhere: both branches
    anywhere = bars.workspace("C.parent", samples=60)
    assert anywhere.points[:, 1].min() < 0 < anywhere.points[:, 1].max()


def test_bricard_has_one_redundant_constraint() -> None:
    model = cd.compile(bricard())
    slots = {row["joint"] for row in model.manifest["coordinates"]}
    q = {name: value for name, value in bricard_angles(0.3).items() if name in slots}
    found = model.redundancy(q)
    assert (found.constraints, found.rank, found.redundant, found.freedoms) == (5, 4, 1, 1)
    cut = model.manifest["cuts"][0]["name"]
    assert found.loops == {cut: (5, 4)}
    assert len(found.directions) == 1
    assert f"of joint '{cut}'" in found.directions[0]
    assert "translation along" in found.directions[0]
    # a self-stress loads every hinge of the only loop, and does no work
    assert not any(found.joints.values())
    assert set(found.joints) == {f"J{k}" for k in range(6)}
    assert "reactions not determined" in repr(found)
    stress = found.vectors[0]
    x = model.initial(q=q)
    work = stress @ model.constraint_jacobian(x[: model.nq])
    np.testing.assert_allclose(work, 0, rtol=0, atol=1e-12)


def test_a_stewart_platform_has_none() -> None:
    model = cd.compile(stewart())
    slots = {row["joint"] for row in model.manifest["coordinates"]}
    q = {name: value for name, value in stewart_coordinates(0.2).items() if name in slots}
    found = model.redundancy(q)
    assert found.redundant == 0
    assert found.freedoms == 6
    assert all(found.unique.values())
    assert all(found.joints.values())
    assert found.directions == ()


@pytest.mark.parametrize("step", [0.01, 0.5, 1.0, 3.0])
def test_longest_steps_do_not_matter(bars: cd.CompiledModel, step: float) -> None:
    """Steps are halved until they follow the curve."""
    over = (0.2, 0.2 + 2 * math.pi)
    found = bars.singular_positions("A", over, driver="D", branch={"D": "+"}, step=step)
    plain = bars.singular_positions("A", over, driver="D", branch={"D": "+"})
    assert found.values() == pytest.approx(plain.values(), abs=1e-9)


def test_mistakes(bars: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match="no coordinate 'E'"):
        bars.singular_positions("E", (0, 1))
    with pytest.raises(cd.ModelError, match="no coordinate 'E'"):
        bars.singular_positions("A", (0, 1), driver="E")
    with pytest.raises(cd.ArgumentError, match="two finite numbers"):
        bars.singular_positions("A", (0, math.inf))
    with pytest.raises(cd.ArgumentError, match="positive steps"):
        bars.singular_positions("A", (0, 1), step=-1)
    for step in (1e-300, 1e30, math.inf):
        with pytest.raises(cd.ArgumentError, match=re.escape(f"step={step:g}")):
            bars.singular_positions("A", (0, 1), step=step)
    with pytest.raises(cd.ModelError, match=r"driver: there is no coordinate ''\. Known: A, B"):
        bars.singular_positions("A", (0, 1), driver="")
    with pytest.raises(cd.ModelError, match="no frame 'tip'"):
        bars.workspace("tip")
    with pytest.raises(cd.ArgumentError, match=r"give \(low, high\)"):
        bars.workspace("crank", over={"A": (1, 0)})
    with pytest.raises(cd.ModelError, match="no coordinate 'E'"):
        bars.workspace("crank", over={"E": (0, 1)})
    with pytest.raises(cd.ArgumentError, match="samples=0: give a whole number of at least 1"):
        bars.workspace("crank", samples=0)


def test_the_slider_of_a_slider_crank() -> None:
    model = cd.compile(slider_crank())
    start = slider_crank_coordinates(0.5)
    start.pop("C", None)
    start = {name: value for name, value in start.items() if name in model.coordinates}
    found = model.singular_positions("A", (0.5, 0.5 + 2 * math.pi), driver="guide", start=start)
    np.testing.assert_allclose(found.values(), [math.pi, 2 * math.pi], rtol=0, atol=1e-9)
    assert "dead point of 'guide'" in repr(found)


def test_loops_in_closed_form_are_refused() -> None:
    model = cd.compile(four_bar(), constraints="closed_form")
    with pytest.raises(cd.ModelError, match="solves them in closed form"):
        model.singular_positions("A", (0.0, 1.0))


def test_two_loops_lose_rank_together() -> None:
    """Parallelograms in a row, where all links lie on one line: determinants keep their sign."""
    model, count = windows(2, 0.6, 1.1), 2
    begin = {f"A{k}": 0.5 for k in range(count + 1)} | {f"B{k}": -0.5 for k in range(count)}
    found = model.singular_positions("A0", (0.5, 6.5), start=begin)
    assert [p.kind for p in found.positions] == ["branch point"] * 2
    np.testing.assert_allclose(found.values("branch point"), [math.pi, 2 * math.pi], atol=1e-9)
