"""Paths of beams through limit loads and onto other branches, against exact beams.

Every error falls with order four; values for elements of no length are within ten times the
tolerance of their references.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms.flexible import column
from mechanisms.loaded import arch, heated_beam, lee_frame, narrow_frame, tall_cantilever

HERE = Path(__file__).parent
COARSE = 16
# of 16 elements
ERROR = 1e-4
Values = dict[str, float]


def known(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((HERE / f"{name}.json").read_text("utf-8"))
    return found


def fold_of_lee(elements: int) -> Values:
    reference = known("lee_frame")
    model = lee_frame(elements, reference["parameters"])
    path = model.continuation(P=(0, 40000.0), until={"v": 62.0})
    return {
        f"{name} {k}": point["P" if name == "load" else "v"] / limit[name == "place"]
        for k, (point, limit) in enumerate(zip(folds(path), [
            values[::-1] for values in reference["reference"]["ks56"]["load_limit"]
        ], strict=True))
        for name in ("load", "place")
    }  # fmt: skip


def folds(path: Any) -> list[Any]:
    return [point for point in path.points if point.kind == "fold"]


def arch_with_a_clamped_end(elements: int) -> Values:
    reference = known("arch_clamped_hinged_180")
    model = arch(elements, reference["parameters"], clamped=True)
    path = model.continuation(P=(0, 12.0), until={"plane.x": -1.0})
    limit = reference["reference"]["limit"]
    (fold,) = folds(path)
    return {"load": fold["P"] / limit["P"], "place": -fold["plane.x"] / limit["v"]}


def deep_arch(elements: int) -> Values:
    reference = known("deep_arch_hinged_A")
    model = arch(elements, reference["parameters"])
    path = model.continuation(
        P=(0, 1000.0), branches=1, bounds={"plane.y": (-30, 30)}, until={"plane.x": -125.0}
    )
    sway, (limit,) = reference["reference"]["bifurcations"][0], folds(path)
    point, secondary = path.point("branch point 1"), reference["reference"]["secondary"][-1]
    (mirrored,) = point.symmetric
    ends = [path.branches[name][-1] for name in mirrored]
    sides = sorted(end["plane.y"] for end in ends)
    assert sides == pytest.approx([-secondary["crown_x"], secondary["crown_x"]])
    top = reference["reference"]["symmetric_limits"][0]
    return {
        "sway": point["P"] / sway["P"],
        "sway place": -point["plane.x"] / sway["v"],
        "limit": limit["P"] / top["P"],
        "secondary": path.branches[mirrored[0]]["P"][-1] / secondary["P"],
        "secondary place": -ends[1]["plane.x"] / secondary["crown_down"],
    }


def right_angle(elements: int) -> Values:
    """Onto the branch that leaves the plane, without a push."""
    reference = known("right_angle_frame_postbuckling_plus")
    model = narrow_frame(elements, reference["parameters"])
    last = reference["reference"]["branch"][-1]
    path = model.continuation(P=(0, 1.6), branches=1, bounds={"z": (-last["z"], last["z"])})
    found = {"critical": path.point("branch point 1")["P"] / reference["reference"]["Pcr"]}
    (up,) = (branch for branch in path.branches.values() if branch["z"][-1] > 1)
    assert len(up) < 60
    tip = [up[name][-1] for name in "xyz"]
    assert tip[2] == pytest.approx(last["z"])
    found["load"] = up["P"][-1] / last["P"]
    return found | {name: x / y for name, x, y in zip("xy", tip, last["tip"], strict=False)}


def heated(elements: int) -> Values:
    reference = known("thermal_buckling_cc")
    model, middle = heated_beam(elements, reference["parameters"]), 0.1
    path = model.continuation(
        e=(0, 0.04), branches=1, bounds={"w": (-middle, middle)}, events={"w": 0.05}
    )
    exact = reference["reference"]["GA_thermal"]
    (up,) = (branch for branch in path.branches.values() if branch["w"][-1] > 0.09)
    points = {f"{point['w']:.2g}": point["e"] for point in up.points if point.kind == "event"}
    after = {w: exact["post"][f"w_mid/L={w}"]["strain_or_shortening"] for w in ("0.05", "0.1")}
    buckles = path.point("branch point 1")["e"] * reference["parameters"]["EA"]
    return {
        "buckles": buckles / exact["N_cr_exact"],
        **{w: points[w] / value for w, value in after.items()},
    }


def prandtl(elements: int) -> Values:
    found = {}
    for name in ("prandtl_A", "prandtl_slender"):
        reference = known(name)
        path = tall_cantilever(elements, reference["parameters"]).continuation(P=(0, 4.0))
        (point,) = (one for one in path.points if one.kind == "branch point")
        found[name] = point["P"] / reference["reference"]["P_exact"]
    return found


# errors of 16 elements, and of none; arches are bent sharply at their limit loads
PROBLEMS: dict[str, tuple[Callable[[int], Values], float, float]] = {
    "lee": (fold_of_lee, 1.6e-4, 2e-5),
    "clamped arch": (arch_with_a_clamped_end, 1.5e-4, 1e-6),
    "deep arch": (deep_arch, 4e-4, 1e-5),
    "right angle": (right_angle, ERROR, 1e-5),
    "heated": (heated, ERROR, 1e-7),
    "prandtl": (prandtl, ERROR, 1e-6),
}


@pytest.mark.parametrize("name", ["lee", "right angle", "deep arch"])
def test_sixteen_elements(name: str) -> None:
    values, error, _ = PROBLEMS[name]
    found = values(COARSE)
    print(name, {key: f"{value - 1:.1e}" for key, value in found.items()})
    assert found == pytest.approx(dict.fromkeys(found, 1.0), abs=error)


@pytest.mark.slow
@pytest.mark.parametrize("name", PROBLEMS)
def test_order_and_limit_of_fine_meshes(name: str) -> None:
    values, error, tolerance = PROBLEMS[name]
    meshes = [values(n * COARSE) for n in (1, 2, 4)]
    for key in meshes[0]:
        coarse, middle, fine = (mesh[key] for mesh in meshes)
        order = np.log2((coarse - middle) / (middle - fine))
        limit = (16 * fine - middle) / 15
        print(f"{name}, {key}: {coarse - 1:.1e}, order {order:.2f}, limit {limit - 1:.1e}")
        assert abs(coarse - 1) < error
        # smaller errors are other terms of the series as well
        if abs(coarse - 1) > 1e-7:
            assert order == pytest.approx(4.0, abs=0.5)
        assert limit == pytest.approx(1.0, abs=tolerance)


def test_a_column_turns_by_160_degrees_and_comes_back() -> None:
    """S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability (1961), section 2.7."""
    table = known("pinned_column_elastica")["reference"]["table"]
    model = cd.compile(column(COARSE, 0.0, stiff=1e6), plane="y")
    last = np.radians(160.0)
    turns = {"pin": (-last, last)}
    path = model.continuation(P=(0, 5.0), branches=1, bounds=turns, events={"pin": np.radians(80)})
    point = path.point("branch point 1")
    # shorter by P / EA, the critical load is larger
    assert point["P"] == pytest.approx(1.0, abs=ERROR)
    up = max(path.branches.values(), key=lambda branch: branch["pin"][-1])
    (event,) = (one for one in up.points if "pin = 1.3" in one.name)
    assert event["P"] == pytest.approx(table["80"]["P_over_Pcr"], rel=ERROR)
    assert up["P"][-1] == pytest.approx(table["160"]["P_over_Pcr"], rel=ERROR)
    assert len(up) < 60
    # over the top, where it is straight, to the other side
    back = model.continuation(
        P=(up["P"][-1], 0.0), q=up[-1].q, until={"pin": -0.5}, events={"pin": np.radians(80)}
    )
    (again,) = (one for one in back.points if one.kind == "event" and "1.3" in one.name)
    assert again["P"] == pytest.approx(event["P"], rel=1e-9)
    straight = [one for one in back.points if one.kind == "branch point"][-1]
    assert straight["P"] == pytest.approx(point["P"], rel=1e-9)


@pytest.mark.parametrize("stiffness", [1e4, 1e8, 1e10])
def test_slenderness_costs_no_steps(stiffness: float) -> None:
    """A cantilever at P L^2 / EI = 10: what it stretches and shears falls with EA L^2 / EI."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    section = cd.section.general(EA=stiffness, GA=stiffness, GJ=1, EI=1, rhoA=1)
    beam = scene.beam("beam", (0, 0, 0), (1, 0, 0), section, elements=64)
    scene.joint("clamp", cd.Fixed(), scene.ground, beam.start)
    scene.force("load", cd.Force(beam.end, (0, 0, load)))
    for name, k in (("x", 0), ("z", 2)):
        scene.output(name, beam.end.position()[k], unit="m")
    path = cd.compile(scene).continuation(P=(0, 10))
    assert path.success
    assert len(path) <= 12
    assert path.main.iterations <= 50
    tip = known("elastica_tip_load")["reference"]["table"]["10"]
    off = np.hypot(path["x"][-1] - 1 + tip["u"], path["z"][-1] - tip["w"])
    assert off <= 2e-8 + 20 / stiffness
    # at the end of the range and not beside it
    assert path["P"][-1] == pytest.approx(10, abs=1e-12)
