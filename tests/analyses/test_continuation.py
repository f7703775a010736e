"""Paths of equilibria against closed forms: folds, branch points, and the branches that meet."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, ModelError, SolveError, SolveWarning

POINT = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
EXACT = 1e-10
# counts of the references are below 60 steps
MOST = 60


def truss(rise: float) -> cd.CompiledModel:
    """Two bars of EA = 1 over a span of 2 that meet in an apex under P."""
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    load, length = scene.parameter("P", 0.0), float(np.hypot(1.0, rise))
    slide, apex = scene.body("slide", **POINT), scene.body("apex", **POINT)
    scene.joint("aside", cd.Prismatic("x"), scene.ground.at(0, 0, rise), slide)
    scene.joint("up", cd.Prismatic("z"), slide, apex)
    for name, x in (("left", -1.0), ("right", 1.0)):
        bar = cd.SpringDamper(
            scene.ground.at(x, 0, 0), apex, stiffness=1 / length, rest_length=length
        )
        scene.force(name, bar)
    scene.force("load", cd.Force(apex, (0, 0, -1 * load)))
    return cd.compile(scene)


def two_links(coordinates: str = "auto") -> cd.CompiledModel:
    """Two links in line with a torsion spring of 1 between them, pressed together by P."""
    scene = cd.Scene("two_links", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    one, two, end = (scene.body(name, **POINT) for name in ("one", "two", "end"))
    scene.joint("theta", cd.Revolute("z"), scene.ground, one)
    scene.joint("middle", cd.Revolute("z"), one.at(1, 0, 0), two)
    scene.joint("pin", cd.Revolute("z"), two.at(1, 0, 0), end)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, end)
    scene.force("spring", cd.JointSpring("middle", stiffness=1.0))
    scene.force("load", cd.Force(end, (-1 * load, 0, 0)))
    return cd.compile(scene, coordinates=coordinates)


def bar() -> cd.CompiledModel:
    """A bar upright under P, held by a spring at 45 degrees."""
    scene = cd.Scene("bar", gravity=(0, 0, 0))
    load, body = scene.parameter("P", 0.0), scene.body("bar", **POINT)
    scene.joint("theta", cd.Revolute("y"), scene.ground, body)
    spring = cd.SpringDamper(
        scene.ground.at(-1, 0, 0), body.at(0, 0, 1), stiffness=1.0, rest_length=2**0.5
    )
    scene.force("spring", spring)
    scene.force("load", cd.Force(body.at(0, 0, 1), (0, 0, -1 * load)))
    return cd.compile(scene)


def double(ratio: float = 1.0) -> cd.CompiledModel:
    """A bar on a universal joint with springs of 1 and ``ratio``, under P."""
    scene = cd.Scene("double", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    cross, body = scene.body("cross", **POINT), scene.body("bar", **POINT)
    scene.joint("one", cd.Revolute("y"), scene.ground, cross)
    scene.joint("two", cd.Revolute("x"), cross, body)
    scene.force("first", cd.JointSpring("one", stiffness=1.0))
    scene.force("second", cd.JointSpring("two", stiffness=ratio))
    scene.force("load", cd.Force(body.at(0, 0, 1), (0, 0, -1 * load)))
    return cd.compile(scene)


def chain(n: int) -> cd.CompiledModel:
    """n links between a pin and a slide, with torsion springs of 1 between them, under P."""
    scene = cd.Scene("chain", gravity=(0, 0, 0))
    load, link = scene.parameter("P", 0.0), 1 / n
    last: Any = scene.ground
    for k in range(n):
        body = scene.body(f"link{k}", **POINT)
        scene.joint(f"joint{k}", cd.Revolute("z"), last, body)
        if k:
            scene.force(f"spring{k}", cd.JointSpring(f"joint{k}", stiffness=1.0))
        last = body.at(link, 0, 0)
    end = scene.body("end", **POINT)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, end, q0=1.0)
    scene.joint("pin", cd.Revolute("z"), last, end)
    scene.force("load", cd.Force(end, (-1 * load, 0, 0)))
    return cd.compile(scene)


def shallow_arch(height: float) -> cd.CompiledModel:
    """Two sines of an arch with rho = 1 in units EI (pi / L)^4, as forces of two slides."""
    scene = cd.Scene("arch", gravity=(0, 0, 0))
    load = scene.parameter("load", 0.0)
    for name, start in (("a1", height), ("a2", 0.0)):
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body, q0=start)
    a1, a2 = scene.q("a1"), scene.q("a2")
    stretch = height**2 - a1**2 - 4 * a2**2
    scene.force("first", cd.JointForce("a1", height - a1 + stretch * a1 / 4 - load))
    scene.force("second", cd.JointForce("a2", a2 * (stretch - 16)))
    return cd.compile(scene)


def column(damping: float) -> cd.CompiledModel:
    """H. Ziegler's column (1952): two links, masses 2 and 1, springs of 1, P along the second."""
    scene = cd.Scene("column", gravity=(0, 0, 0))
    load = scene.parameter("P", 0.0)
    lower = scene.body("lower", mass=2.0, com=(0, 0, 1), inertia=(0, 0, 0))
    upper = scene.body("upper", mass=1.0, com=(0, 0, 1), inertia=(0, 0, 0))
    scene.joint("one", cd.Revolute("y"), scene.ground, lower)
    scene.joint("two", cd.Revolute("y"), lower.at(0, 0, 1), upper)
    for name in ("one", "two"):
        scene.force(f"spring_{name}", cd.JointSpring(name, stiffness=1.0))
        if damping:
            scene.force(f"damper_{name}", cd.JointDamper(name, damping=damping))
    scene.force("load", cd.Force(upper.at(0, 0, 1), (0, 0, -1 * load), in_=upper))
    return cd.compile(scene)


def kinds(path: Any) -> list[str]:
    return [point.kind for point in path.points]


def test_truss_folds_and_sways() -> None:
    """R. von Mises (1923); limit l^3 = b^2 l0, sway l^3 - l0 l^2 + l0 b^2 = 0, b = 1."""
    path = truss(3.0).continuation(P=(0, 2))
    branch, fold = "branch point", "fold"
    assert kinds(path) == [branch, fold, branch, branch, fold, branch, "event"]
    length = 10.0**0.5
    limit = length ** (1 / 3)
    sway = max(np.roots([1, -length, 0, length]).real)
    for point, of in ((path.point("fold 1"), limit), (path.point("branch point 1"), sway)):
        height = (of**2 - 1) ** 0.5
        assert point.values["P"] == pytest.approx(2 * height * (1 / of - 1 / length), abs=EXACT)
        assert 3 + point["up"] == pytest.approx(height, abs=1e-8)
    # odd in the height
    loads = np.array([point.values["P"] for point in path.points[:-1]])
    np.testing.assert_allclose(loads, -loads[::-1], atol=EXACT)
    assert len(path) < MOST
    assert path.success
    assert path.points[0].symmetric == (("1a", "1b"),)


def test_stability_is_that_of_small_motions() -> None:
    model = truss(3.0)
    path = model.continuation(P=(0, 2))
    for k in range(0, len(path), 3):
        row = path[k]
        values = model.with_parameters(P=path["P"][k]).linearize(row).eigenvalues
        assert bool(path.main.stable[k]) == bool(values.real.max() < 1e-6)
    assert path.main.n_negative.max() == 2


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_pitchfork_and_its_branches(coordinates: str) -> None:
    """J. M. T. Thompson, G. W. Hunt (1973): P = 2 theta / sin theta, Pcr = 2, b = 1/6."""
    limits = {"theta": (-1.4, 1.4)}
    path = two_links(coordinates).continuation(P=(0, 4), branches=1, bounds=limits)
    (point, _) = path.points
    assert point.values["P"] == pytest.approx(2.0, abs=EXACT)
    assert [*path.branches] == ["main", "1a", "1b"]
    for name in ("1a", "1b"):
        branch = path.branches[name]
        theta = branch["theta"]
        np.testing.assert_allclose(branch["P"], 2 * theta / np.sin(theta), rtol=1e-10)
        assert abs(theta[-1]) == pytest.approx(1.4, abs=EXACT)
        assert len(branch) < MOST
        assert all(branch.stable)
    half, k = point.special.halves[0], path.model.speeds.index("theta.u")
    second = half.curvature[-1] * 4 / half.tangent[k] ** 2
    assert second / 2 / 2.0 == pytest.approx(1 / 6, rel=1e-6)


def test_transcritical_slope() -> None:
    """W. T. Koiter (1945): P = cot t (1 - 1 / sqrt(1 + sin t)), Pcr = 1/2, slope -3/8."""
    path = bar().continuation(P=(0, 1), branches=1, bounds={"theta": (-1.3, 1.3)})
    point = path.point("branch point 1")
    assert point.values["P"] == pytest.approx(0.5, abs=EXACT)
    for along, load in point.tangents:
        assert load / along == pytest.approx(-3 / 8, rel=1e-8)
    assert point.symmetric == ()
    for name in ("1a", "1b"):
        theta, load = path.branches[name]["theta"], path.branches[name]["P"]
        np.testing.assert_allclose(load, (1 - 1 / np.sqrt(1 + np.sin(theta))) / np.tan(theta))


def test_all_branches_of_a_double_point() -> None:
    """Cardan angles: P cos a cos b, so that P sin a cos b = a and P cos a sin b = b."""
    path = double().continuation(P=(0, 1.5), branches=1, points=12)
    point = path.point("branch point 1")
    assert point.values["P"] == pytest.approx(1.0, abs=EXACT)
    assert point.kernel.shape[1] == 3
    wanted = {(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)}
    directions = point.tangents[:, :2] / np.abs(point.tangents[:, :2]).max(axis=1)[:, None]
    assert {tuple(np.rint(row).astype(int).tolist()) for row in directions} == wanted
    assert len(directions) == 8
    np.testing.assert_allclose(directions, np.rint(directions), atol=1e-8)
    np.testing.assert_allclose(point.tangents[:, 2], 0.0, atol=1e-8)
    assert len(point.symmetric) == 4
    for name in point.branches:
        branch = path.branches[name]
        a, b, load = branch["one"], branch["two"], branch["P"]
        np.testing.assert_allclose(load * np.sin(a) * np.cos(b), a, atol=1e-9)
        np.testing.assert_allclose(load * np.cos(a) * np.sin(b), b, atol=1e-9)


def test_branches_that_meet_again_are_followed_once() -> None:
    """Y. C. Fung, A. Kaplan (1952): a1^2 + 4 a2^2 = h^2 - 16, load = h + 3 a1 on the ellipse."""
    path = shallow_arch(8.0).continuation(load=(0, 80), branches=True)
    assert kinds(path) == ["branch point", "fold", "fold", "branch point", "event"]
    limit, sway = (60 / 3) ** 0.5, 48**0.5
    for name, a1 in (("fold 1", limit), ("branch point 1", sway)):
        wanted = 8 - a1 + (64 - a1**2) * a1 / 4
        assert path.point(name).values["load"] == pytest.approx(wanted, rel=EXACT)
    assert [*path.branches] == ["main", "1a"]
    ellipse = path.branches["1a"]
    assert ellipse.status == "closed"
    np.testing.assert_allclose(ellipse["a1"] ** 2 + 4 * ellipse["a2"] ** 2, 48, rtol=EXACT)
    np.testing.assert_allclose(ellipse["load"], 8 + 3 * ellipse["a1"], atol=1e-9)
    met = [point for point in ellipse.points if point.kind == "branch point"]
    assert "it is branch point 2 of 'main'" in str(met[0])


@pytest.mark.parametrize(
    ("damping", "load", "frequency"),
    [(0.1, 41 / 28 + 0.1**2 / 2, 0.5345224838248488), (0.0, 7 / 2 - 2**0.5, 0.5**0.25)],
)
def test_flutter(damping: float, load: float, frequency: float) -> None:
    """G. Herrmann, I.-C. Jong (1965): 41 k / 28 l + b^2 / 2 m l^3; (7/2 - sqrt 2) k / l without."""
    (point, _) = column(damping).continuation(P=(0, 3)).points
    assert point.kind == "Hopf point"
    assert point.values["P"] == pytest.approx(load, abs=EXACT)
    # undamped the frequency is a double root
    assert point.frequency == pytest.approx(frequency, rel=1e-9 if damping else 1e-6)


def test_near_points_are_told_apart() -> None:
    path = double(1.02).continuation(P=(0, 1.5))
    loads = [point.values["P"] for point in path.points if point.kind == "branch point"]
    np.testing.assert_allclose(loads, [1.0, 1.02], atol=EXACT)


@pytest.mark.parametrize("n", [8, pytest.param(11, marks=pytest.mark.slow)])
def test_every_bifurcation_of_a_chain(n: int) -> None:
    """P_j = 4 c / l sin^2(j pi / 2 n), H. Hencky (1920)."""
    wanted = 4 * n * np.sin(np.arange(1, n) * np.pi / (2 * n)) ** 2
    path = chain(n).continuation(P=(0, 6.0 * n))
    points = [point for point in path.points if point.kind == "branch point"]
    np.testing.assert_allclose([point.values["P"] for point in points], wanted, rtol=EXACT)
    assert all(len(point.branches) == 2 and point.symmetric for point in points)
    assert len(path) < MOST


def test_units_do_not_matter() -> None:
    """In other units of the load, and backward along the same curve."""
    here = truss(3.0).continuation(P=(0, 1))
    there = truss(3.0).continuation(P=(0, 0.9), bounds={"up": (-2.5, 1.0)})
    names = ("fold 1", "branch point 1", "branch point 2")
    for name in names:
        assert here.point(name).values["P"] == pytest.approx(
            there.point(name).values["P"], abs=EXACT
        )
    assert there["up"][-1] == pytest.approx(-2.5, abs=EXACT)


def test_targets_and_events() -> None:
    path = truss(0.5).continuation(P=(0, 1), until={"up": -0.8}, events={"up": -0.5})
    (event,) = (point for point in path.points if point.name == "up = -0.5")
    assert event["up"] == pytest.approx(-0.5, abs=EXACT)
    # halfway through nothing pulls up
    assert event.values["P"] == pytest.approx(0.0, abs=EXACT)
    assert path["up"][-1] == pytest.approx(-0.8, abs=EXACT)
    assert event.solution.converged


def test_prescribed_displacements_pass_limit_loads() -> None:
    """The apex moved down: the load is the force that holds it."""
    path = truss(0.5).continuation(locked={"up": (0, -1.0)})
    height, length = 0.5 + path["up"], np.hypot(1.0, 0.5)
    force = 2 * height * (1 / np.hypot(1, height) - 1 / length)
    np.testing.assert_allclose(path["up.holding_force"], -force, atol=1e-10)
    assert kinds(path) == ["event"]
    assert not all(path.main.stable)
    assert all(path.main.stable_held)


def test_what_nothing_resists_stays_where_it_is() -> None:
    """A pendulum that also turns about the vertical: m g l sin a = k (pi / 2 - a), any turn."""
    scene = cd.Scene("turning", gravity=(0, 0, -9.81))
    post, rod = scene.body("post", **POINT), scene.body("rod", com=(0, 0, -1), **POINT)
    scene.joint("turn", cd.Revolute("z"), scene.ground, post)
    scene.joint("tilt", cd.Revolute("y"), post, rod)
    scene.force("spring", cd.JointForce("tilt", 5.0 * (np.pi / 2 - scene.q("tilt"))))
    path = cd.compile(scene).continuation({"gravity.z": (-1.0, -9.81)}, q={"turn": 0.7})
    assert path.success
    tilt, weight = path["tilt"], -path["gravity.z"]
    np.testing.assert_allclose(weight * np.sin(tilt), 5 * (np.pi / 2 - tilt), rtol=1e-9)
    np.testing.assert_allclose(path["turn"], 0.7, rtol=1e-12)


def test_interrupted_paths_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = list[float]()

    def stop(part: float) -> None:
        shown.append(part)
        if len(shown) == 9:
            raise KeyboardInterrupt

    with pytest.warns(SolveWarning, match="interrupted; what was computed is kept"):
        path = truss(3.0).continuation(P=(0, 2), progress=stop)
    assert len(path) == 10
    assert path.main.status == "interrupted"
    assert path.point("fold 1").values["P"] > 0.78


def test_budget_is_told() -> None:
    with pytest.warns(SolveWarning, match="after 5 points, the most that points= allows"):
        path = truss(3.0).continuation(P=(0, 2), points=5)
    assert not path.success
    with pytest.raises(SolveError, match="points="):
        truss(3.0).continuation(P=(0, 2), points=5, check=True)


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda m: m.continuation(), ModelError, "say what is swept"),
        (lambda m: m.continuation(Q=(0, 1)), ModelError, "no parameter or input 'Q'"),
        (lambda m: m.continuation(P=(0, 1, 2)), ModelError, "no values within"),
        (lambda m: m.continuation(P=(0, 1), until={"upp": 1}), ModelError, "Did you mean 'up'"),
        (lambda m: m.continuation(P=(0, np.nan)), SolveError, "finite"),
        (lambda m: m.continuation(P=(0, 1), step=0), ArgumentError, "a length above 0"),
        (lambda m: m.continuation(P=(0, 1), step=-0.1), ArgumentError, "a length above 0"),
        (lambda m: m.continuation(P=(0, 1), step=1e-300), ArgumentError, "step=1e-300"),
        (lambda m: m.continuation(P=(0, 1), step=float("inf")), ArgumentError, "step=inf"),
        (lambda m: m.continuation(P=(0, 1), branches=-1), ArgumentError, "0 or more, or True"),
        (lambda m: m.continuation(P=(0, 1), until={"up": np.nan}), ArgumentError, "a number"),
        (lambda m: m.continuation(P=(0, 1), events={"up": np.inf}), ArgumentError, "a number"),
        (lambda m: m.continuation(P=(0, 2)).point("fold 9"), ModelError, "Did you mean 'fold"),
    ],
)
def test_nonsense_is_refused(
    call: Callable[[Any], Any], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        call(truss(3.0))


def test_picture(tmp_path: Path) -> None:
    path = bar().continuation(P=(0, 1), branches=1, bounds={"theta": (-1.2, 1.2)})
    figure = path.plot("P", "theta", tmp_path / "diagram.svg")
    (axis,) = figure.axes
    styles = {line.get_linestyle() for line in axis.lines}
    assert {"-", "--"} <= styles
    assert "branch point 1" in {text.get_text() for text in axis.texts}
    assert "branch point 1: P = 0.5" in str(path)


@pytest.mark.parametrize("error", [1e-2, 1e-4, 1e-6, 1e-8])
def test_imperfections_bend_the_path_to_one_side(error: float) -> None:
    """P sin(theta) = 2 theta + e with a spring that is bent by e; no step leads across."""
    scene = cd.Scene("bent", gravity=(0, 0, 0))
    load, bend = scene.parameter("P", 0.0), scene.parameter("e", 0.0)
    one, two, end = (scene.body(name, **POINT) for name in ("one", "two", "end"))
    scene.joint("theta", cd.Revolute("z"), scene.ground, one)
    scene.joint("middle", cd.Revolute("z"), one.at(1, 0, 0), two)
    scene.joint("pin", cd.Revolute("z"), two.at(1, 0, 0), end)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, end)
    scene.force("spring", cd.JointForce("middle", bend - scene.q("middle")))
    scene.force("load", cd.Force(end, (-1 * load, 0, 0)))
    model = cd.compile(scene)
    for sign in (1, -1):
        path = model.continuation(
            P=(0, 4), parameters={"e": sign * error}, bounds={"theta": (-1.4, 1.4)}
        )
        assert kinds(path) == ["event"]
        theta = path["theta"]
        assert theta[-1] == pytest.approx(-1.4 * sign)
        np.testing.assert_allclose(path["P"] * np.sin(theta), 2 * theta + sign * error, atol=1e-12)
