"""Legs in closed form: a ball joint carried by two axes and a motor or a slide, in any order."""

from __future__ import annotations

from functools import cache
from itertools import product

import numpy as np
import pytest

import cardan as cd
from cardan.errors import TopologyError
from spread import some

HOME = np.array([1, 0, 0, 0, 0, 0, 0.5])
Y2 = (0.1, 1, 0)
END = (0, 0.02, 0.55)
# kind -> joints from the ground to the platform: (name, joint, its place on the body inboard)
CHAINS = {
    "RUS": (
        ("m", cd.Revolute("y"), ()),
        ("u", cd.Universal("x", Y2), (0.2, 0, 0)),
        ("s", cd.Spherical(), END),
    ),
    "PUS": (
        ("m", cd.Prismatic("z"), ()),
        ("u", cd.Universal("x", "y"), (0.2, 0, 0)),
        ("s", cd.Spherical(), END),
    ),
    "UPS": (
        ("u", cd.Universal("x", Y2), ()),
        ("m", cd.Prismatic("z"), (0.02, 0, 0.1)),
        ("s", cd.Spherical(), (0, 0.02, 0.15)),
    ),
    "URS": (
        ("u", cd.Universal("x", "y"), ()),
        ("m", cd.Revolute("y"), (0.2, 0, 0.1)),
        ("s", cd.Spherical(), END),
    ),
    "RSU": (
        ("m", cd.Revolute("y"), ()),
        ("s", cd.Spherical(), (0.2, 0, 0)),
        ("u", cd.Universal("x", Y2), END),
    ),
    "SPU": (
        ("s", cd.Spherical(), ()),
        ("m", cd.Prismatic("z"), (0.02, 0, 0.1)),
        ("u", cd.Universal("x", Y2), (0, 0.02, 0.15)),
    ),
    "R(RR)S": (
        ("m", cd.Revolute("y"), ()),
        ("a", cd.Revolute("x"), (0.2, 0, 0)),
        ("b", cd.Revolute(Y2), ()),
        ("s", cd.Spherical(), END),
    ),
    "R R//R S": (
        ("m", cd.Revolute("z"), ()),
        ("a", cd.Revolute("y"), (0.02, 0.01, 0.05)),
        ("b", cd.Revolute("y"), (0.05, 0.02, 0.35)),
        ("s", cd.Spherical(), (0, 0.02, 0.4)),
    ),
    "R//R R S": (
        ("a", cd.Revolute("y"), ()),
        ("b", cd.Revolute("-y"), (0.2, 0.01, 0.25)),
        ("m", cd.Revolute((1, 0, 0.3)), (0.03, 0.05, 0.04)),
        ("s", cd.Spherical(), (0, 0.02, 0.4)),
    ),
    "R//R S R": (
        ("a", cd.Revolute("y"), ()),
        ("b", cd.Revolute("y"), (0.2, 0.01, 0.25)),
        ("s", cd.Spherical(), (0, 0.02, 0.35)),
        ("m", cd.Revolute("x"), (0.02, 0.2, 0.03)),
    ),
}


def carried(kind: str, legs: int = 1) -> cd.Scene:
    """A free platform on equal legs."""
    scene = cd.Scene("legs", gravity=(0, 0, -9.81))
    platform = scene.body("platform", mass=2.0, com=(0.01, 0.02, 0.03), inertia=(0.02, 0.03, 0.04))
    scene.joint("base", cd.Free(), scene.ground, platform, q0=tuple(HOME))
    for k, angle in enumerate((0.0, 2.1)[:legs]):
        x, y = np.cos(angle), np.sin(angle)
        place = scene.ground.at(0.3 * x, 0.3 * y, 0, rotation=("XYZ", 0, 0, angle))
        last = len(CHAINS[kind]) - 1
        for n, (name, joint, where) in enumerate(CHAINS[kind]):
            inner = place.at(*where) if where else place
            if n == last:
                outer = platform.at(0.1 * x, 0.1 * y, -0.02)
            else:
                outer = place = scene.body(
                    f"link{k}{n}", mass=0.3, com=(0.02, 0.01, 0.1), inertia=(0.003, 0.002, 0.001)
                )
            scene.joint(f"{name}{k}", joint, inner, outer, cut=name == "s")
    return scene


def states(count: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Poses of the platform near its home, and speeds."""
    rng = np.random.default_rng(seed)
    q = HOME + np.concatenate(
        [rng.uniform(-0.05, 0.05, (count, 4)), rng.uniform(-0.02, 0.02, (count, 3))], axis=1
    )
    q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
    return q, rng.uniform(-1, 1, (count, 6))


def entries(model: cd.CompiledModel, q: np.ndarray, u: np.ndarray) -> dict[str, np.ndarray]:
    """All coordinates and speeds by name, of joints of legs too."""
    values = np.concatenate([q, u, model.dependents(q, u)], axis=-1).T
    follow = [n for o in model.manifest["functions"]["dependents"]["outputs"] for n in o["entries"]]
    names = (*model.coordinates, *model.speeds, *follow)
    return dict(zip(names, values, strict=True))


def compared(whole: cd.CompiledModel, solved: cd.CompiledModel, count: int = 6) -> np.ndarray:
    """Check states, accelerations and reactions against multipliers; what follows (..., n)."""
    q, u = states(count)
    found = entries(solved, q, u)
    full = [
        np.stack([found[n] for n in names], axis=-1) for names in (whole.coordinates, whole.speeds)
    ]
    assert np.abs(whole.constraints(full[0])).max() < 1e-13
    assert np.abs(whole.constraint_rates(*full)).max() < 1e-12
    wanted = whole.forward_dynamics(*full)
    places = [whole.speeds.index(n) for n in solved.speeds]
    size = np.abs(wanted).max()
    np.testing.assert_allclose(
        solved.forward_dynamics(q, u), wanted[:, places], rtol=0, atol=1e-10 * size
    )
    for joint in ("m0", "s0"):
        expected = whole.reaction(joint, *full)
        np.testing.assert_allclose(
            solved.reaction(joint, q, u), expected, rtol=0, atol=1e-10 * np.abs(expected).max()
        )
    return solved.dependents(q, u)


@pytest.mark.parametrize("kind", some(CHAINS, 10, 7))
def test_legs_are_found_and_equal_to_multipliers(kind: str) -> None:
    scene = carried(kind, legs=2 if kind == "RUS" else 1)
    solved = cd.compile(scene, constraints="closed_form")
    assert solved.coordinates == tuple(
        f"base.{n}" for n in ["qw", "qx", "qy", "qz", "px", "py", "pz"]
    )
    assert solved.nlam == 0
    # every function is judged by an independent program as it is built
    compared(cd.compile(scene), solved)


@pytest.mark.parametrize("kind", some(["RUS", "UPS", "R R//R S"], 3))
def test_all_branches_close_and_differ(kind: str) -> None:
    scene = carried(kind)
    whole = cd.compile(scene)
    found = []
    for pair, third in product("+-", repeat=2):
        branches = {"s0": pair, "m0": third}
        equations = cd.derive(scene, constraints="closed_form", branches=branches)
        found.append(compared(whole, cd.compile(equations)))
        assert f"(branch {pair}, m0 {third})" in str(equations)
    for n, one in enumerate(found):
        for other in found[:n]:
            assert np.abs(np.sin((one - other) / 2)).max() > 1e-3


def test_branches_of_legs_that_do_not_exist() -> None:
    scene = carried("RUS")
    with pytest.raises(TopologyError, match=r"branch of 'u0': .* not a motor or slide of a .*s0"):
        cd.derive(scene, branches={"u0": "+"})
    with pytest.raises(TopologyError, match="branch of 'm0' is 'left'"):
        cd.derive(scene, branches={"m0": "left"})


@cache
def leg() -> cd.CompiledModel:
    """A platform on an arm and a rod, in closed form."""
    return cd.compile(carried("RUS"), constraints="closed_form")


def test_batches_are_single_states() -> None:
    solved = leg()
    q, u = states(64)
    solved.prepare("forward_dynamics", batch=True)
    single = np.stack([solved.forward_dynamics(*state) for state in zip(q, u, strict=True)])
    np.testing.assert_allclose(solved.forward_dynamics(q, u), single, rtol=1e-13)


def test_a_leg_that_is_stretched_ends_the_run() -> None:
    solved = leg()
    with pytest.warns(cd.SolveWarning, match="is at a dead point there"):
        motion = solved.simulate(5.0, u={"base.u.pz": 5.0}, rtol=1e-6)
    assert motion.status in ("not_finite", "step_too_small")
    # the arm and the rod, 0.2 and 0.55 m, are nearly in line
    arm = motion.pose("link00")[-1][:3, 3]
    end = motion.pose("platform")[-1] @ [0.1, 0, -0.02, 1]
    assert np.linalg.norm(end[:3] - arm) > 0.7


def test_a_platform_on_slides_and_arms() -> None:
    """A Delta robot: three arms with rods on balls, a platform that only slides."""
    scene = cd.Scene("delta", gravity=(0, 0, -9.81))
    names = ("x", "y", "z")
    body = scene.ground
    for name in names:
        carriage = scene.body("platform" if name == "z" else f"slide{name}")
        start = -0.4 if name == "z" else None
        scene.joint(name, cd.Prismatic(name), body, carriage, q0=start)
        body = carriage
    scene.bodies["platform"] = body
    heavy = scene.body("load", mass=0.5, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("bolt", cd.Fixed(), body, heavy)
    for k in range(3):
        about = ("XYZ", 0, 0, 2 * np.pi * k / 3)
        x, y = np.cos(about[3]), np.sin(about[3])
        arm = scene.body(f"arm{k}", mass=0.4, com=(0.1, 0, 0), inertia=(1e-4, 1e-3, 1e-3))
        rod = scene.body(f"rod{k}", mass=0.15, com=(0, 0, -0.22), inertia=(2e-3, 2e-3, 1e-5))
        place = scene.ground.at(0.15 * x, 0.15 * y, 0, rotation=about)
        scene.joint(f"motor{k}", cd.Revolute("y"), place, arm)
        scene.joint(f"elbow{k}", cd.Universal("y", "x"), arm.at(0.2, 0, 0), rod)
        wrist = body.at(0.05 * x, 0.05 * y, 0)
        scene.joint(f"ball{k}", cd.Spherical(), rod.at(0, 0, -0.45), wrist, cut=True)
    solved = cd.compile(scene, constraints="closed_form")
    assert solved.coordinates == names
    one = solved.simulate(0.2, rtol=1e-9)
    start = solved.dependents(*solved.split(one.x[0]))
    follow = solved.manifest["functions"]["dependents"]["outputs"]
    given = dict(zip([n for o in follow for n in o["entries"]], start, strict=True))
    whole = cd.compile(scene)
    q = given | dict(zip(names, solved.split(one.x[0])[0].tolist(), strict=True))
    q = {n: q[n] for n in whole.coordinates}
    two = whole.simulate(0.2, q=q, rtol=1e-9)
    for name in (*names, "motor0"):
        np.testing.assert_allclose(one[name][-1], two[name][-1], rtol=0, atol=1e-8)


def test_what_closed_form_would_leave_is_told() -> None:
    told = str(cd.derive(carried("RUS")))
    assert "constraints='closed_form' would leave 7 of 10 coordinates; it does not pass" in told
    assert "would leave" not in str(cd.derive(carried("RUS"), constraints="closed_form"))
    with pytest.raises(TopologyError, match="branch of 'x': it closes no loop"):
        cd.derive(cd.Scene("empty"), branches={"x": "+"})
