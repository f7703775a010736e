"""Kinematics by least strain energy: against closed forms, rigid links and other formulations."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import pytest
from scipy.optimize import minimize

import cardan as cd
from mechanisms.overconstrained import bennett, bennett_angles

INERT: dict[str, Any] = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}
CRANK, COUPLER, ROCKER, GROUND = 0.1, 0.25, 0.2, 0.3
SOFT = 10.0


def four_bar(stiffness: float) -> cd.Scene:
    """Coupler and rocker are bars that give way; a soft spring pulls their pin."""
    scene = cd.Scene("four_bar", gravity=(0, 0, -9.81))
    crank, slide, pin = (scene.body(name, **INERT) for name in ("crank", "slide", "pin"))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slide)
    scene.joint("y", cd.Prismatic("y"), slide, pin)
    ends = {"coupler": (crank.at(CRANK, 0, 0), COUPLER)}
    ends["rocker"] = (scene.ground.at(GROUND, 0, 0), ROCKER)
    for name, (end, length) in ends.items():
        scene.force(name, cd.SpringDamper(end, pin, stiffness=stiffness, rest_length=length))
    soft = cd.SpringDamper(scene.ground.at(0, 0.5, 0), pin, stiffness=SOFT, rest_length=0.1)
    scene.force("soft", soft)
    return scene


def rigid_pin(angle: np.ndarray) -> np.ndarray:
    """Where the pin of rigid links is (n, 2): circles about the crank's end and the ground."""
    crank = CRANK * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    span = np.array([GROUND, 0.0]) - crank
    distance = np.linalg.norm(span, axis=1, keepdims=True)
    along = span / distance
    ahead = (COUPLER**2 - ROCKER**2 + distance**2) / (2 * distance)
    aside = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    return np.asarray(crank + ahead * along + np.sqrt(COUPLER**2 - ahead**2) * aside)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_four_bar_tends_to_rigid_links(coordinates: str) -> None:
    angles = np.linspace(0, 2 * math.pi, 25)
    exact, errors = rigid_pin(angles), []
    ratios = 10.0 ** np.arange(2, 13, 2)
    for ratio in ratios:
        model = cd.compile(four_bar(ratio * SOFT), coordinates=coordinates)
        start = {"x": exact[0, 0], "y": exact[0, 1]}
        swept = model.sweep("A", angles, by="strain_energy", start=start)
        assert swept.success
        assert all(swept.minimum)
        errors.append(np.hypot(*(np.stack([swept["x"], swept["y"]], -1) - exact).T).max())
        print(f"stiffness ratio {ratio:.0e}: pin off by {errors[-1]:.2e} m")
    assert errors[-1] <= 1e-10
    # by one over the ratio, once displacements are small
    np.testing.assert_allclose(np.diff(np.log10(errors[1:])), -2, rtol=0, atol=0.01)


def test_the_energy_is_that_of_a_minimizer() -> None:
    model = cd.compile(four_bar(100.0))
    found = model.assemble({"A": 0.7}, by="strain_energy", start={"x": 0.2, "y": 0.15})

    def energy(pin: np.ndarray) -> float:
        crank = CRANK * np.array([math.cos(0.7), math.sin(0.7)])
        bars = [(100.0, crank, COUPLER), (100.0, (GROUND, 0.0), ROCKER), (SOFT, (0.0, 0.5), 0.1)]
        return sum(0.5 * k * (np.linalg.norm(pin - end) - length) ** 2 for k, end, length in bars)

    best = minimize(energy, [0.2, 0.15], tol=1e-14, method="Nelder-Mead", options={"xatol": 1e-12})
    # a minimizer without derivatives knows the place to the root of rounding
    assert [found["x"], found["y"]] == pytest.approx(best.x, abs=1e-7)
    assert found.energy == pytest.approx(best.fun, rel=1e-12)
    assert found.energy == pytest.approx(float(model.strain_energy(found.q)), rel=1e-14)
    # the torque on the crank is the derivative of the energy
    h = 1e-5
    sides = [model.assemble({"A": 0.7 + s}, by="strain_energy", start=found.q) for s in (h, -h)]
    slope = (sides[0].energy - sides[1].energy) / (2 * h)
    assert found.holding_forces["A"] == pytest.approx(slope, rel=1e-8)
    assert "least strain energy" in repr(found)


def test_weights_and_loads_have_no_part_in_it() -> None:
    scene = four_bar(1e3)
    scene.force("load", cd.Force("pin", (0, 50.0, 0)))
    scene.force("drag", cd.JointForce("y", -30.0))
    start = {"x": 0.2, "y": 0.15}
    loaded = cd.compile(scene).assemble({"A": 0.7}, by="strain_energy", start=start)
    bare = cd.compile(four_bar(1e3)).assemble({"A": 0.7}, by="strain_energy", start=start)
    np.testing.assert_allclose(loaded.q, bare.q, rtol=0, atol=1e-14)


# a loop that is closed too often: it moves as Bennett found, or is strained


def test_an_overconstrained_loop_with_a_flexible_joint() -> None:
    """Bennett's linkage, its last hinge made of springs, and a spring that pulls it elsewhere."""
    firsts = np.linspace(0.5, 2.0, 7)
    errors = []
    for stiffness in (1e4, 1e6, 1e8, 1e10):
        scene = bennett(gravity=(0, 0, 0))
        last = scene.joints.pop("j3")
        scene.force(
            "j3",
            cd.Bushing(
                last.parent, last.child, stiffness=(stiffness, stiffness, 0.0, *[stiffness] * 3)
            ),
        )
        scene.force("pull", cd.JointSpring("j1", stiffness=1.0, rest=0.3))
        model = cd.compile(scene)
        start = {name: angle for name, angle in bennett_angles(firsts[0]).items() if name != "j3"}
        swept = model.sweep("j0", firsts, by="strain_energy", start=start)
        assert swept.success
        away = [swept["j1"][k] - bennett_angles(a)["j1"] for k, a in enumerate(firsts)]
        errors.append(np.abs(np.remainder(np.array(away) + 1, 2 * math.pi) - 1).max())
        print(f"stiffness {stiffness:.0e}: angle off by {errors[-1]:.2e}")
    np.testing.assert_allclose(np.diff(np.log10(errors)), -2, rtol=0, atol=0.05)


# more freedoms than drivers: a chain of links with springs, one end led to the other


def test_an_underdetermined_chain_takes_the_minimum() -> None:
    n, L = 6, 0.2
    scene = cd.Scene("chain", gravity=(0, 0, 0))
    before: Any = scene.ground
    for k in range(n):
        link = scene.body(f"link{k}", **INERT)
        scene.joint(f"h{k}", cd.Revolute("z"), before, link)
        if k:
            scene.force(f"s{k}", cd.JointSpring(f"h{k}", stiffness=2.0))
        before = link.at(L, 0, 0)
    guide = scene.body("guide", **INERT)
    scene.joint("end", cd.Prismatic("x"), scene.ground, guide, q0=n * L)
    scene.joint("pin", cd.Revolute("z"), before, guide)
    model = cd.compile(scene)
    place = 0.8
    start = {"h0": 0.6, **{f"h{k}": -0.25 for k in range(1, n)}}
    found = model.assemble({"end": place}, by="strain_energy", start=start)

    def angles(x: np.ndarray) -> np.ndarray:
        return np.cumsum(x)

    constraints = [
        {"type": "eq", "fun": lambda x: L * np.cos(angles(x)).sum() - place},
        {"type": "eq", "fun": lambda x: L * np.sin(angles(x)).sum()},
    ]
    best = minimize(
        lambda x: np.sum(x[1:] ** 2), [start[f"h{k}"] for k in range(n)], method="SLSQP",
        constraints=constraints, options={"ftol": 1e-15, "maxiter": 200},
    )  # fmt: skip
    assert best.success
    assert [found[f"h{k}"] for k in range(n)] == pytest.approx(best.x, abs=1e-6)
    assert found.energy == pytest.approx(best.fun, rel=1e-10)
    assert found.freedoms == 0


# what is refused, and what is told


def test_free_motions_are_named() -> None:
    scene = four_bar(1e3)
    loose = scene.body("loose", **INERT)
    scene.joint("swing", cd.Revolute("z"), scene.ground, loose)
    with pytest.warns(cd.SolveWarning, match="nothing that is strained resists 'swing'"):
        found = cd.compile(scene).assemble({"A": 0.7}, by="strain_energy")
    assert found.freedoms == 1


def test_refusals() -> None:
    model = cd.compile(four_bar(1e3))
    rigid = cd.Scene("rigid")
    rigid.joint("swing", cd.Revolute("y"), rigid.ground, rigid.body("bob", **INERT))
    for call, message in (
        (lambda: model.assemble(by="energy"), "'constraints' or 'strain_energy'"),
        (lambda: model.assemble({"B": 1.0}, by="strain_energy"), "'B' is not a coordinate"),
        (lambda: model.assemble({"pin": [0, 0, 0]}, by="strain_energy"), "'pin' is not a coord"),
        (lambda: model.assemble({"A": 1.0}, branch={"x": "+"}, by="strain_energy"), "branch="),
        (lambda: model.sweep("B", [0, 1], by="strain_energy"), "no coordinate 'B'"),
        (lambda: model.sweep("A", [0, 1], snap=True), "snap=True goes with by='strain_energy'"),
        (lambda: cd.compile(rigid).assemble(by="strain_energy"), "nothing of 'rigid' is strained"),
    ):
        with pytest.raises(cd.ModelError, match=message):
            call()
    with pytest.raises(cd.SolveError, match="one finite number"):
        model.assemble({"A": math.nan}, by="strain_energy")


def test_what_the_motion_changes_has_no_strain_energy() -> None:
    """A free length that follows a coordinate works on the system: its force has no potential."""
    scene = cd.Scene("led", gravity=(0, 0, 0))
    slide = scene.body("slide", **INERT)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slide, q0=0.5)
    length = 0.2 + scene.q("x") ** 2
    spring = cd.SpringDamper(scene.ground, slide, stiffness=3.0, rest_length=length)
    scene.force("spring", spring)
    with pytest.raises(cd.ModelError, match="nothing of 'led' is strained"):
        cd.compile(scene).assemble(by="strain_energy")


def test_values_out_of_reach_are_named() -> None:
    """A rigid crank cannot lead its slider further than its two links are long."""
    scene = cd.Scene("crank", gravity=(0, 0, 0))
    crank, rod, slider = (scene.body(name, **INERT) for name in ("crank", "rod", "slider"))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), rod)
    scene.joint("guide", cd.Prismatic("x"), scene.ground, slider)
    scene.joint("C", cd.Revolute("z"), rod.at(0.3, 0, 0), slider)
    scene.force("spring", cd.JointSpring("A", stiffness=1.0))
    model = cd.compile(scene)
    with pytest.raises(cd.ModelError, match="guide"):
        model.assemble({"guide": 0.5}, by="strain_energy")
    with pytest.warns(cd.SolveWarning, match="the sweep stops at 'guide' = 0.4"):
        swept = model.sweep("guide", [0.3, 0.35, 0.39, 0.45], by="strain_energy", start={"A": 0.8})
    assert len(swept) == 3


def test_progress_and_ctrl_c() -> None:
    model = cd.compile(four_bar(1e3))
    shares: list[float] = []

    def interrupt(share: float) -> None:
        shares.append(share)
        if len(shares) == 3:
            raise KeyboardInterrupt

    for by in ("strain_energy", "constraints"):
        shares.clear()
        locked = {"x": 0.2, "y": 0.15} if by == "constraints" else None
        start = {"x": 0.2, "y": 0.15}
        with pytest.warns(cd.SolveWarning, match="interrupted"):
            swept = model.sweep(
                "A", np.linspace(0, 1, 9), by=by, locked=locked, start=start, progress=interrupt
            )
        assert swept.status == "interrupted"
        assert 3 <= len(swept) <= 4
        assert shares == sorted(shares)


def test_no_warning_without_reason() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cd.compile(four_bar(1e3)).sweep(
            "A", np.linspace(0, 1, 3), by="strain_energy", start={"x": 0.2, "y": 0.15}
        )


# the functions of a model that it rests on


def tethered(rotation: str) -> cd.Scene:
    """A free body on a bushing, a spring and a cable, with a slide on it."""
    scene = cd.Scene("tethered", gravity=(0, 0, 0))
    bodies = [scene.body(name, **INERT) for name in ("base", "rider")]
    scene.joint("base", cd.Free(rotation=rotation), scene.ground, bodies[0])
    scene.joint("slide", cd.Cylindrical("x"), *bodies)
    mount = bodies[0].at(0.1, 0.2, 0.3)
    scene.force("mount", cd.Bushing(scene.ground, mount, stiffness=(1, 2, 3, 4, 5, 6)))
    anchors = scene.ground.at(2, 0, 0), scene.ground.at(0, 0, 3)
    scene.force("spring", cd.SpringDamper(anchors[0], mount, stiffness=3.0, rest_length=0.4))
    scene.force("rope", cd.Cable(anchors[1], bodies[1], EA=30.0, length=0.4))
    return scene


@pytest.mark.parametrize("rotation", ["quaternion", "XYZ", "mrp"])
def test_forces_are_the_gradient_of_the_energy(rotation: str) -> None:
    model = cd.compile(tethered(rotation))
    q = model.random_state(1)[: model.nq]
    slope = model.derivative("strain_energy", "q")(q)
    h, ways = 1e-5, np.eye(model.nu)
    ends = [
        np.array([model.strain_energy(model.integrate(q, sign * h * way)) for way in ways])
        for sign in (1, -1)
    ]
    np.testing.assert_allclose(slope, (ends[0] - ends[1]) / (2 * h), rtol=1e-7, atol=1e-8)
    # strains are all that is stored without gravity
    total = model.energy(q, np.zeros(model.nu)).potential
    assert float(model.strain_energy(q)) == pytest.approx(float(total), rel=1e-13)


def test_a_build_is_checked() -> None:
    model = cd.compile(tethered("quaternion"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        model.assemble(by="strain_energy")
    checks = {check.function: check.error for check in model.verify().checks}
    names = ("strain_energy", "strain_balance", "derivative('strain_balance: q')")
    assert all(checks[name] <= 1e-9 for name in names)
