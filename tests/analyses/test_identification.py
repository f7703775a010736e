"""Identification: what data can tell, motions that excite, estimates within their covariance."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.stats import binom, chi2

import cardan as cd
from cardan.errors import ArgumentError, ModelError, SolveError
from mechanisms import ZOO
from mechanisms.closed_planar import four_bar, four_bar_angles
from mechanisms.robots import panda, puma

ARM = Path(__file__).parents[2] / "examples" / "arm.urdf"
SEED = 11


@cache
def robot() -> Any:
    return cd.compile(panda())


@cache
def arm() -> Any:
    return cd.compile(cd.load(ARM))


@cache
def swing() -> Any:
    """A motion of the Panda arm by chance, within its limits."""
    return robot().excitation(10.0, steps=0, starts=4, seed=3)


def changed(model: Any, part: float = 0.1) -> Any:
    """Another robot of the same shape: masses, centers and damping off by a tenth."""
    rng = np.random.default_rng(SEED)
    words = (".mass", ".com.x", ".com.y", ".com.z", ".damping")
    return model.with_parameters(
        {
            name: value * (1 + part * rng.uniform(-1, 1))
            for name, value in model.parameters.items()
            if name.endswith(words)
        }
    )


def phi(model: Any) -> np.ndarray:
    return np.array(list(model.inertial_parameters().values()))


def whitened(found: Any, truth: np.ndarray) -> np.ndarray:
    """Errors of estimates, of variance 1 and independent if the covariance is right."""
    root = np.linalg.cholesky(found.covariance)
    return np.linalg.solve(root, found.estimates - truth)


# base parameters


@pytest.mark.parametrize(
    ("build", "count"),
    # 36 of the PUMA 560: Mayeda, Yoshida and Osuka (1990); a 7R arm whose first axis is that of
    # gravity has 1 + 7 * 6 of its bodies, and seven dampers here
    [(puma, 36), (panda, 43 + 7), (ZOO["spatial_chain"].build, 3 + 7 * 3)],
    ids=["puma560", "panda", "spatial_chain"],
)
def test_number_of_base_parameters(build: Any, count: int) -> None:
    model = robot() if build is panda else cd.compile(build())
    base = model.base_parameters()
    assert len(base) == count
    # no column is nearly dependent, none nearly independent
    assert base.dropped < 1e-10 < 1e-2 < base.least_independent
    x = model.random_state(8, (200,))
    q, u = model.split(x)
    udot = np.random.default_rng(9).uniform(-5, 5, u.shape)
    Y = model.regressor(q, u, udot)
    scaled = Y.reshape(-1, Y.shape[-1])
    sizes = np.linalg.norm(scaled, axis=0)
    # columns of rounding alone are none
    scaled = (scaled / np.where(sizes > 0, sizes, 1))[:, sizes > 1e-9 * sizes.max()]
    values = np.linalg.svd(scaled, compute_uv=False)
    assert np.sum(values > 1e-8 * values[0]) == count
    tau = model.inverse_dynamics(q, u, udot)
    assert np.abs(base.regressor(Y) @ base.of(phi(model)) - tau).max() < 1e-11 * np.abs(tau).max()


@pytest.mark.parametrize(
    "build",
    [puma, pytest.param(panda, marks=pytest.mark.slow), lambda: cd.load(ARM)],
    ids=["puma", "panda", "arm"],
)
def test_symbolic_combinations_are_those_of_numbers(build: Any) -> None:
    """As many, and either determine the others at once: as functions of the user's parameters."""
    equations = cd.derive(build())
    model = cd.compile(equations)
    symbolic = equations.base_parameters().combinations
    names, values = list(model.parameters), list(model.parameters.vector)
    gradient = sp.lambdify(
        sp.symbols(names), sp.Matrix(list(symbolic.values())).jacobian(sp.symbols(names)), "numpy"
    )
    theirs = np.array(gradient(*values), dtype=float)
    base = model.base_parameters()
    inertial = [not name.endswith(".damping") for name in base.names]
    ours = (base.matrix @ model.derivative("inertial_parameters", "p")())[inertial]
    # lengths are in the numbers of B, and in the expressions
    lengths = np.abs(ours).max(axis=0) < 1e-12
    theirs[:, lengths] = 0
    # what exact zeros leave at 0 depends on no parameter
    ours = ours[np.abs(ours).max(axis=1) > 1e-12]
    scaled = [x / np.linalg.norm(x, axis=1, keepdims=True) for x in (ours, theirs)]
    ranks = [np.linalg.matrix_rank(x, tol=1e-9) for x in (*scaled, np.vstack(scaled))]
    assert len(set(ranks)) == 1
    assert ranks[0] == len(symbolic)


def test_expressions_say_what_is_combined() -> None:
    """The inertia of what turns about the axis, and masses at their arms, as in the textbook."""
    base = arm().base_parameters()
    assert base.expressions["column.zz"] == "column.zz + upper_arm.xx + forearm.xx"
    assert base.expressions["upper_arm.moment_x"] == "upper_arm.moment_x + 0.4 forearm.mass"
    assert base.expressions["forearm.zz"] == "-forearm.xx + forearm.zz"
    assert "column.mass" in base.without_effect
    assert f"{len(base)} base parameters" in repr(base)


def test_panda_has_as_many_by_names() -> None:
    assert len(cd.derive(panda()).base_parameters().combinations) == 43


# estimates


def test_exact_data_give_exact_parameters() -> None:
    model, motion = robot(), swing().motion(50)
    truth = changed(model)
    tau = truth.inverse_dynamics(motion["q"], motion["u"], motion["udot"])
    found = model.identify({**motion, "tau": tau})
    assert np.allclose(found.estimates, found.base.of(phi(truth)), rtol=0, atol=1e-12)
    # at a motion it has not seen, the identified model has the forces of the true one
    assert found.missed < 1e3
    other = robot().excitation(8.0, steps=0, starts=1, seed=5).motion(20)
    at = (other["q"], other["u"], other["udot"])
    want = truth.inverse_dynamics(*at)
    assert np.abs(found.model.inverse_dynamics(*at) - want).max() < 1e-8 * np.abs(want).max()
    assert np.abs(model.inverse_dynamics(*at) - want).max() > 0.1


def test_errors_of_panda_have_the_predicted_covariance() -> None:
    """50 base parameters from noisy forces, 16 times: chi-square and coverage of intervals."""
    model, motion = robot(), swing().motion(60)
    truth = changed(model)
    tau = truth.inverse_dynamics(motion["q"], motion["u"], motion["udot"])
    base = model.base_parameters()
    beta, sigma = base.of(phi(truth)), np.array([0.4, 0.5, 0.3, 0.3, 0.1, 0.1, 0.05])
    rng, runs = np.random.default_rng(SEED), 16
    errors, covered, noises = [], 0, []
    for _ in range(runs):
        data = {**motion, "tau": tau + sigma * rng.normal(size=tau.shape)}
        found = model.identify(data, base=base)
        errors.append(whitened(found, beta))
        covered += int(np.sum(np.abs(found.estimates - beta) <= 1.96 * found.deviations))
        noises.append(found.noise)
    count = runs * len(base)
    # noise that is itself estimated spreads errors by a part of 1 / (samples) more
    low, high = chi2.ppf([0.0005, 0.9995], count)
    assert low < np.sum(np.square(errors)) < high
    low, high = binom.ppf([0.0005, 0.9995], count, 0.95)
    assert low <= covered <= high
    # every one of them by itself, over the runs
    low, high = chi2.ppf([0.0005 / len(base), 1 - 0.0005 / len(base)], runs)
    each = np.square(errors).sum(axis=0)
    assert np.all((low < each) & (each < high))
    assert np.allclose(np.mean(noises, axis=0), sigma, rtol=0.03)
    # damping of 0.003 N m s is far below what such noise shows, inertia is not
    assert found.well.any()
    assert not found.well[base.names.index("panda_joint2.damping")]
    # the noise of a good model explains what is left
    assert 0.9 < found.chi < 1.1


def test_known_noise_and_a_noisy_position() -> None:
    model, motion = arm(), arm().excitation(6.0, steps=0, speed=3.0, seed=1).motion(200, periods=3)
    truth = changed(model)
    tau = truth.inverse_dynamics(motion["q"], motion["u"], motion["udot"])
    rng, base = np.random.default_rng(SEED), model.base_parameters()
    beta, total, runs = base.of(phi(truth)), np.zeros(3), 10
    for _ in range(runs):
        noisy = tau + 0.05 * rng.normal(size=tau.shape)
        q = motion["q"] + 1e-5 * rng.normal(size=tau.shape)
        bare = {"t": motion["t"], "q": q, "tau": noisy}
        ways = (
            model.identify({**motion, "tau": noisy}, base=base, noise=0.05),
            # neither speeds nor accelerations were measured
            model.identify(bare, base=base, period=6.0),
            model.identify(bare, base=base, cutoff=8.0),
        )
        total += [np.sum(whitened(found, beta) ** 2) for found in ways]
    low, high = chi2.ppf([0.0005, 0.9995], runs * len(base))
    assert low < total[0] < high
    assert low < total[1] < high
    # filters leave a little of the noise dependent
    assert 0.8 * low < total[2] < 1.2 * high


def test_energies_need_no_accelerations() -> None:
    model, motion = arm(), arm().excitation(6.0, steps=0, speed=3.0, seed=1).motion(400, periods=3)
    truth = changed(model)
    tau = truth.inverse_dynamics(motion["q"], motion["u"], motion["udot"])
    base = model.base_parameters()
    beta = base.of(phi(truth))
    data = {"t": motion["t"], "q": motion["q"], "u": motion["u"], "udot": 0 * motion["u"]}
    exact = model.identify({**data, "tau": tau}, base=base, form="energy")
    assert np.allclose(exact.estimates, beta, rtol=0, atol=1e-6)
    rng, total, runs = np.random.default_rng(SEED), np.zeros(2), 10
    for _ in range(runs):
        noisy = {**data, "tau": tau + 0.05 * rng.normal(size=tau.shape)}
        ways = (
            model.identify(noisy, base=base, form="energy"),
            model.identify(noisy, base=base, form="energy", noise=0.05),
        )
        total += [np.sum(whitened(found, beta) ** 2) for found in ways]
    low, high = chi2.ppf([0.0005, 0.9995], runs * len(base))
    assert np.all((low < total) & (total < high))


def test_a_run_is_data() -> None:
    """Motors that follow a plan: a run of the true robot, held against the nominal one."""
    scene = cd.Scene("driven_arm", gravity=(0, 0, -9.81))
    inner = scene.ground
    for k in range(2):
        link = scene.body(f"link{k}", mass=1.5, com=(0.02, 0.01, -0.3), inertia=(0.05, 0.05, 0.01))
        scene.joint(f"joint{k}", cd.Revolute("y"), inner, link)
        scene.force(f"drag{k}", cd.JointDamper(f"joint{k}", 0.1))
        plan = (9 - 6 * k) * sp.sin((2.1 + 1.6 * k) * cd.t + k)
        scene.force(f"motor{k}", cd.JointForce(f"joint{k}", plan))
        inner = link.at(0, 0, -0.6)
    model = cd.compile(scene)
    truth = changed(model, 0.3)
    run = truth.simulate(np.linspace(0, 6, 1201), q={"joint0": 0.4}, rtol=1e-11, atol=1e-12)
    found = model.identify(run)
    beta = found.base.of(phi(truth))
    # accelerations come from a spline through the speeds
    assert np.allclose(found.estimates, beta, rtol=1e-4, atol=1e-6)
    assert not np.allclose(found.expected, beta, rtol=1e-2)


def test_friction_and_a_rotor() -> None:
    """Coefficients of elements, of which the nominal model has none but the rotor."""
    scene = cd.Scene("axle", gravity=(0, 0, -9.81))
    arm = scene.body("arm", mass=1.0, com=(0, 0, -0.3), inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm)
    names = {name: scene.parameter(name, 0.0) for name in ("dry", "wet", "soft")}
    scene.force("rub", cd.Friction("hinge", coulomb=names["dry"], viscous=names["wet"]))
    scene.force("coil", cd.JointSpring("hinge", stiffness=names["soft"], rest=0.2))
    scene.force("motor", cd.Drive("hinge", inertia=1e-4, ratio=20))
    model = cd.compile(scene)
    truth = model.with_parameters({"dry": 0.5, "wet": 0.1, "soft": 2.0, "motor.inertia": 3e-4})
    t = np.linspace(0, 4, 801)
    motion = {"t": t, "q": 0.8 * np.sin(3 * t + 0.1)[:, None]}
    tau = truth.torques(motion)
    for form in ("torque", "energy"):
        found = model.identify(tau.table(), form=form)
        assert np.allclose(found.estimates, found.base.of(phi(truth)), rtol=1e-4, atol=1e-5)
        new = found.parameters
        assert [new[name] for name in ("dry", "wet", "soft")] == pytest.approx(
            [0.5, 0.1, 2.0], rel=1e-3
        )
    # the rotor turns with the arm: only the sum shows
    assert found.base.expressions["arm.yy"] == "arm.yy + 400 motor.inertia"


def test_a_passive_joint() -> None:
    """A cart is pushed, its pole swings: that nothing drives the pole is known for certain."""
    scene = ZOO["cart_pole"].build()
    model = cd.compile(scene)
    scene.force("push", cd.JointForce("track", 5 * sp.sin(3 * cd.t) + 3 * sp.sin(7.1 * cd.t)))
    truth = changed(cd.compile(scene))
    t = np.linspace(0, 5, 1001)
    run = truth.simulate(t, q={"hinge": 0.5}, rtol=1e-11, atol=1e-13)
    push = truth.applied_forces(run.q, run.u, t=t)[:, 0] + 0.1 * np.random.default_rng(2).normal(
        size=1001
    )
    udot = truth.forward_dynamics(run.q, run.u, t=t)
    data = {"t": t, "q": run.q, "u": run.u, "udot": udot, "track.tau": push}
    found = model.identify(data)
    assert found.noise[0] == pytest.approx(0.1, rel=0.1)
    # ratios of what the pole feels are exact: all errors lie in one direction
    errors = whitened(found, found.base.of(phi(truth)))
    assert np.sum(errors**2) < chi2.ppf(0.9995, len(found.base))
    assert np.allclose(found.estimates, found.base.of(phi(truth)), rtol=0.02, atol=1e-9)
    assert "hinge.u" in repr(found).splitlines()[-2]


def test_circuits() -> None:
    """A four-bar that its crank drives: what the loop makes dependent falls together."""
    model = cd.compile(four_bar())
    truth = model.with_parameters({"coupler.mass": 0.3, "rocker.com.x": 0.12})
    start = {name: angle for name, angle in four_bar_angles(0.0).items() if name != "C"}
    angles = np.linspace(0, 2 * np.pi, 60)
    sweeps = [
        model.sweep("A", angles, rate=rate, acceleration=way, start=start)
        for rate, way in ((3.0, 0.0), (5.0, 8.0))
    ]
    q, u, udot = (np.vstack([getattr(s, x) for s in sweeps]) for x in ("q", "u", "udot"))
    tau = truth.actuation(q, u, udot, ["A"]).tau
    data = {"t": np.arange(len(q)), "q": q, "u": u, "udot": udot, "tau": tau}
    found = model.identify(data, actuators=["A"])
    assert found.channels == ("A.u",)
    # fewer than the 3 * 3 of a tree in the plane whose first body only turns
    assert 0 < len(found.base) < 9
    assert np.allclose(found.estimates, found.base.of(phi(truth)), rtol=1e-6, atol=1e-9)
    assert not np.allclose(found.estimates, found.expected, rtol=1e-3, atol=1e-6)
    with pytest.raises(SolveError, match="1 freedoms, but forces of 3 speeds"):
        model.identify(data)
    with pytest.raises(SolveError, match="has loops"):
        model.excitation()


# refusals


def test_refusals_name_the_culprit(tmp_path: Path) -> None:
    model = arm()
    t = np.linspace(0, 1, 50)
    still = {"t": t, "q": np.zeros((50, 3)), "tau": np.zeros((50, 3))}
    with pytest.raises(ArgumentError, match=r"no forces in the data: .*'waist.tau'"):
        model.identify(still)
    still["tau"] += 1
    with pytest.raises(ArgumentError, match="less than a period"):
        model.identify(still, period=2.0)
    with pytest.raises(ArgumentError, match=r"'waist' has shape \(49,\), t has \(50,\)"):
        model.identify({"t": t, "waist": t[1:]})
    with pytest.raises(SolveError, match=r"do not tell .*model\.excitation"):
        model.identify(still)
    with pytest.raises(ArgumentError, match=r"'elbo' is not a column of this model.*elbow"):
        model.identify({"t": t, "elbo": t})
    with pytest.raises(ArgumentError, match="column 'shoulder' is missing"):
        model.identify({"t": t, "waist": t, "elbow": t})
    with pytest.raises(ArgumentError, match="form='energies' does not exist"):
        model.identify(still, form="energies")
    with pytest.raises(ArgumentError, match="cutoff=30 Hz is not below half"):
        model.identify(still, cutoff=30.0)
    with pytest.raises(ArgumentError, match="equal steps"):
        model.identify({**still, "t": t**2}, cutoff=3.0)
    with pytest.raises(SolveError, match="free or ball-jointed"):
        cd.compile(ZOO["free_ZYX"].build()).excitation()
    absolute = cd.compile(ZOO["double_pendulum"].build(), coordinates="absolute")
    for call in (lambda: absolute.identify(still), absolute.excitation):
        with pytest.raises(ModelError, match="has no function 'regressor'"):
            call()
    with pytest.raises(ArgumentError, match="slides and has no limits"):
        cd.compile(ZOO["cart_pole"].build()).excitation()
    table = tmp_path / "run.csv"
    table.write_text("t,waist\n0,zero\n", encoding="utf-8")
    with pytest.raises(ArgumentError, match="line 2, column 'waist': 'zero' is not a number"):
        model.identify(table)
    with pytest.raises(ArgumentError, match="noise: a positive number"):
        model.identify(still, noise={"elbow": 0.1})
