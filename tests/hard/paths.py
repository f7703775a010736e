"""Paths of equilibria and of cycles that are hard to follow, against closed forms."""

from __future__ import annotations

import json
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from cycle_scenes import bounce, table
from mechanisms.flexible import column

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
REFERENCES = Path(__file__).parents[1] / "references"
Followed = tuple[float, Any]


@dataclass(frozen=True)
class PathCase:
    """A path that is hard for some reason, with an oracle.

    Attributes:
        name: In test output and in the page.
        hard: What is hard.
        oracle: What the error is measured by, and its unit.
        bound: Of the error.
        follow: The error, and the record of the path.
    """

    name: str
    hard: str
    oracle: str
    bound: float
    follow: Callable[[], Followed]

    def __repr__(self) -> str:
        return self.name


@dataclass(frozen=True)
class PathOutcome:
    """What was measured: error, points of all branches, linear systems and time [s]."""

    error: float
    points: int
    systems: int
    seconds: float


def measure(case: PathCase) -> PathOutcome:
    """Follow the path of a case; the time is that of all, models compiled too."""
    begin = time.perf_counter()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        error, path = case.follow()
    branches = path.branches.values()
    points, systems = sum(map(len, branches)), sum(branch.iterations for branch in branches)
    return PathOutcome(error, points, systems, time.perf_counter() - begin)


def folds() -> Followed:
    """Two steep bars: l^3 = l0 at the limit loads, where b = 1."""
    scene, rise = cd.Scene("truss", gravity=(0, 0, 0)), 3.0
    load, length = scene.parameter("P", 0.0), float(np.hypot(1.0, rise))
    apex = scene.body("apex", **POINT)
    scene.joint("up", cd.Prismatic("z"), scene.ground.at(0, 0, rise), apex)
    for name, x in (("left", -1.0), ("right", 1.0)):
        foot = scene.ground.at(x, 0, 0)
        bar = cd.SpringDamper(foot, apex, stiffness=1 / length, rest_length=length)
        scene.force(name, bar)
    scene.force("load", cd.Force(apex, (0, 0, -1 * load)))
    path = cd.compile(scene).continuation(P=(0, 2))
    limit = length ** (1 / 3)
    exact = 2 * (limit**2 - 1) ** 0.5 * (1 / limit - 1 / length)
    loads = [abs(point["P"]) for point in path.points if point.kind == "fold"]
    return float(np.abs(np.array(loads) - exact).max()) if len(loads) == 2 else np.inf, path


def imperfect(e: float) -> Followed:
    """Two links with a spring that is bent by e: P sin(theta) = 2 theta + e."""
    scene = cd.Scene("bent", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    one, two, end = (scene.body(name, **POINT) for name in ("one", "two", "end"))
    scene.joint("theta", cd.Revolute("z"), scene.ground, one)
    scene.joint("middle", cd.Revolute("z"), one.at(1, 0, 0), two)
    scene.joint("pin", cd.Revolute("z"), two.at(1, 0, 0), end)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, end, q0=2.0)
    scene.force("spring", cd.JointForce("middle", e - scene.q("middle")))
    scene.force("load", cd.Force(end, (-1 * load, 0, 0)))
    path = cd.compile(scene).continuation(P=(0, 4), bounds={"theta": (-1.4, 1.4)})
    theta = path["theta"]
    error = np.abs(path["P"] * np.sin(theta) - 2 * theta - e).max()
    # to the side to which the spring is bent
    return float(error) if theta[-1] * e < 0 else np.inf, path


def double_point() -> Followed:
    """A bar on a universal joint: eight branches leave P = 1."""
    scene = cd.Scene("double", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    cross, body = scene.body("cross", **POINT), scene.body("bar", **POINT)
    scene.joint("one", cd.Revolute("y"), scene.ground, cross)
    scene.joint("two", cd.Revolute("x"), cross, body)
    for name in ("one", "two"):
        scene.force(f"spring_{name}", cd.JointSpring(name, stiffness=1.0))
    scene.force("load", cd.Force(body.at(0, 0, 1), (0, 0, -1 * load)))
    path = cd.compile(scene).continuation(P=(0, 1.5), branches=1, points=12)
    if len(path.point("branch point 1").branches) != 8:
        return np.inf, path
    error = abs(path.point("branch point 1")["P"] - 1.0)
    for branch in path.branches.values():
        a, b, P = branch["one"], branch["two"], branch["P"]
        off = P * np.sin(a) * np.cos(b) - a, P * np.cos(a) * np.sin(b) - b
        error = max(error, *(float(np.abs(x).max()) for x in off))
    return error, path


def elastica(degrees: float, stiff: float, elements: int) -> Followed:
    """A pinned column of EI = 1, EA = GA = stiff, onto its branch up to an angle at its ends."""
    name = REFERENCES / "pinned_column_elastica.json"
    exact = json.loads(name.read_text("utf-8"))["reference"]["table"][f"{degrees:.0f}"]
    model, last = cd.compile(column(elements, 0.0, stiff=stiff), plane="y"), np.radians(degrees)
    path = model.continuation(P=(0, 5.0), branches=1, bounds={"pin": (-last, last)})
    up = max(path.branches.values(), key=lambda branch: branch["pin"][-1])
    ends = up["P"][-1] / exact["P_over_Pcr"] - 1, up["pin"][-1] - last
    point = path.point("branch point 1")["P"] - 1
    return float(max(abs(point), *(abs(x) for x in ends))), path


def critical(stiff: float, elements: int) -> Followed:
    """The same column straight, up to the first critical load."""
    path = cd.compile(column(elements, 0.0, stiff=stiff), plane="y").continuation(P=(0, 2.0))
    return abs(path.point("branch point 1")["P"] - 1), path


def fold_of_cycles() -> Followed:
    """A ball on a table: bounces of one kind exist from A w = v on, and meet others there."""
    cycle = bounce(table(0.0013), 0.0013)
    path = cycle.model.continuation(
        A=(0.0013, 0.001), of="cycles", start=cycle, bounds={"A": (0.001, 0.0014)}
    )
    exact = 0.0011565259198011062
    return abs(path.point("fold 1").values["A"] / exact - 1), path


CASES: dict[str, PathCase] = {
    case.name: case
    for case in (
        PathCase("two limit loads", "the load falls, pulls and rises again",
                 "closed form; load, of EA", 1e-10, folds),
        PathCase("imperfection 1e-8", "the path all but crosses another, and turns by 90 degrees",
                 "P sin a = 2 a + e at every point; moment, of the spring", 1e-11,
                 partial(imperfect, 1e-8)),
        PathCase("double point", "eight branches leave one point",
                 "closed form, at every point; moment, of the springs", 1e-9, double_point),
        PathCase("slenderness 1e5", "EA L^2 / EI = 1e10, 16 elements, onto its branch up to 80°",
                 "elastica; load, of it", 1e-4, partial(elastica, 80, 1e10, 16)),
        PathCase("slenderness 1e6", "EA L^2 / EI = 1e12, 16 elements: rounding hides what leaves "
                 "the branch point, which is said", "Euler; critical load, of it", 1e-4,
                 partial(critical, 1e12, 16)),
        PathCase("column beyond 160°", "its ends pass each other; 32 elements, EA L^2 / EI = 1e6",
                 "elastica; load, of it", 3e-5, partial(elastica, 160, 1e6, 32)),
        PathCase("fold of cycles", "bounces of a ball turn into others where a multiplier is 1",
                 "closed form; amplitude of the table, of it", 1e-9, fold_of_cycles),
    )
}  # fmt: skip
