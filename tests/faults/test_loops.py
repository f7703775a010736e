"""Faults of mechanisms with loops: their constraints, their singular positions, their rank."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import cardan as cd
from analyses.test_refused_circuits import braced, tilted
from analyses.test_rounded import rounded
from cardan.errors import ModelWarning, SolveError
from cardan.runtime.verification import constraints
from mechanisms import ZOO
from mechanisms.closed_planar import four_bar
from mechanisms.overconstrained import bennett, bennett_angles
from table import each


def door(last: str) -> cd.Scene:
    """A door on two coaxial hinges; ``last`` says which side declares the upper one."""
    scene = cd.Scene(f"door_{last}")
    leaf = scene.body("door", mass=2.0, com=(0.4, 0, 0), inertia=(0.1, 0.1, 0.15))
    scene.joint("h1", cd.Revolute("z"), scene.ground, leaf)
    ends = leaf.at(0, 0, 1), scene.ground.at(0, 0, 1)
    scene.joint("h2", cd.Revolute("z"), *(ends if last == "door" else ends[::-1]))
    return scene


@pytest.mark.parametrize("last", ["door", "ground"])
def test_a1_jacobian_of_a_joint_whose_child_is_the_ground(last: str) -> None:
    """The Jacobian of such a joint was not the derivative of what it holds: nothing assembled."""
    model = cd.compile(cd.derive(door(last), coordinates="absolute"))
    motion = model.simulate(1.0, q={"h1": 0.3}, u={"h1": 1.0}, method="DOP853", rtol=1e-10)
    assert motion.success
    np.testing.assert_allclose(motion["h1"][-1], 1.3, atol=1e-9)
    checks = {c.function: c.error for c in model.verify().checks}
    assert max(checks[name] for name in ("constraint_rates", "gamma")) < 1e-12


def test_a1_random_states_are_states_of_nodes() -> None:
    """Quaternions of nodes were drawn number by number: no rotation, and G no derivative there."""
    model = cd.compile(cd.derive(door("door"), coordinates="absolute"))
    q = model.random_state(1, (50,))[:, : model.nq]
    for first in model.manifest["quaternions"]:
        sizes = np.linalg.norm(q[:, first : first + 4], axis=1)
        np.testing.assert_allclose(sizes, 1.0, atol=1e-14)
    step, rng = 1e-6, np.random.default_rng(2)
    for place in q[:5]:
        u = rng.uniform(-1, 1, model.nu)
        ends = [model.constraints(model.integrate(place, way * u)) for way in (step, -step)]
        along = model.constraint_jacobian(place) @ u
        # central differences: step^2 and eps / step
        np.testing.assert_allclose((ends[0] - ends[1]) / (2 * step), along, atol=1e-8)


@pytest.mark.parametrize("wrong", ["rates", "product", "gamma"])
def test_a1_every_build_compares_its_constraints(wrong: str) -> None:
    """No build compared g, G u + g_t and gamma with each other."""
    turn = np.array([[0.3, -1.0], [2.0, 0.5]])

    def position(at: constraints.Motion) -> np.ndarray:
        return np.sin(at.q @ turn.T) + at.t[:, None] ** 2

    def slopes(at: constraints.Motion) -> np.ndarray:
        return np.cos(at.q @ turn.T)[..., None] * turn

    def rates(at: constraints.Motion) -> np.ndarray:
        return np.einsum("nij,nj->ni", slopes(at), at.u) + 2 * at.t[:, None]

    def gamma(at: constraints.Motion) -> np.ndarray:
        return np.sin(at.q @ turn.T) * (turn @ at.u) ** 2 - 2

    def product(at: constraints.Motion, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return slopes(at) @ x, np.abs(slopes(at) * x).max(axis=1)

    q, u, udot = np.array([[0.2, 0.4], [1.0, -0.7], [0.3, 0.9]])
    at = constraints.Motion(np.asarray(0.3), q, u, np.zeros(0), u, udot, np.zeros(0))
    right = {"position": position, "rates": rates, "product": product, "gamma": gamma}
    found = constraints.worst(constraints.Levels(**right), [at])
    assert max(found.values()) < 1e-12
    good, part = right[wrong], (1.0 + 1e-7)
    forged = {
        "rates": lambda at: good(at) * part,
        "gamma": lambda at: good(at) * part,
        "product": lambda at, x: (good(at, x)[0] * part, good(at, x)[1]),
    }
    found = constraints.worst(constraints.Levels(**(right | {wrong: forged[wrong]})), [at])
    assert max(found.values()) > 1e-9


def windows() -> cd.Scene:
    """Two windows of four bars (IFToMM A02), their joints declared as the benchmark does."""
    scene = cd.Scene("a02", gravity=(0, -9.81, 0))
    rod, cranks = cd.inertia.rod(1.0, 1.0, axis="x"), list[cd.scene.Body]()
    for k in range(3):
        crank = scene.body(f"crank{k}", mass=1.0, com=(0.5, 0, 0), inertia=rod)
        scene.joint(f"A{k}", cd.Revolute("z"), scene.ground.at(k, 0, 0), crank)
        if k:
            coupler = scene.body(f"coupler{k}", mass=1.0, com=(0.5, 0, 0), inertia=rod)
            scene.joint(f"B{k}", cd.Revolute("z"), cranks[-1].at(1, 0, 0), coupler)
            scene.joint(f"C{k}", cd.Revolute("z"), coupler.at(1, 0, 0), crank.at(1, 0, 0))
        cranks.append(crank)
    return scene


# of phi'' = -g ((N + 1)/2 + N) cos phi / ((N + 1)/3 + N) from pi/2 with -1: phi and the time at 0
PHI = {0.7: 0.0689873}
BY = {
    "given steps": ({"method": cd.GeneralizedAlpha(0.8), "step": 1e-2}, 1e-4),
    "generalized-alpha": ({"method": cd.GeneralizedAlpha(0.8), "rtol": 1e-8}, 1e-5),
    "DOP853": ({"method": "DOP853", "rtol": 1e-10}, 1e-6),
}


@pytest.mark.parametrize("by", BY)
def test_a4_a_regular_mechanism_stays_closed(by: str) -> None:
    """Units of constraints hung on rounding in a coordinate without mass: steps came open."""
    model = cd.compile(cd.derive(windows(), coordinates="absolute"))
    start = {f"A{k}": np.pi / 2 for k in range(3)} | {f"B{k}": -np.pi / 2 for k in (1, 2)}
    how, error = BY[by]
    motion = model.simulate(0.7, q=start, u={"A0": -1.0}, **how)
    assert motion.success
    gaps = [np.abs(model.constraints(q)).max() for q in motion.q]
    rates = [np.abs(model.constraint_rates(*x)).max() for x in zip(motion.q, motion.u, strict=True)]
    assert max(gaps) < 1e-9
    assert max(rates) < 1e-7
    np.testing.assert_allclose(motion["A0"][-1], PHI[0.7], atol=error)


@pytest.mark.parametrize("how", [{"step": 1e-3}, {"rtol": 1e-6}])
def test_a4_bodies_without_inertia_hide_no_others(how: dict[str, float]) -> None:
    """Forces of a short step gave massless rings units in which rows of others vanished."""
    model = cd.compile(ZOO["point_masses"].build(), coordinates="absolute")
    start = dict(ZOO["point_masses"].states[0].q)
    motion = model.simulate(2.0, q=start, method=cd.GeneralizedAlpha(0.8), **how)
    assert motion.success
    assert motion.solver_info.statistics["steps"] <= 2000
    assert max(np.abs(model.constraints(q)).max() for q in motion.q) < 1e-9
    assert np.abs(motion.energy.total - motion.energy.total[0]).max() < 1e-4


@each("method", ["DOP853", "Radau", "RK4"])
@each("cut", ["j1", "j2", "j3"])
def test_a5_rows_that_pass_through_zero_are_no_dead_points(method: str, cut: str) -> None:
    """The rows that were kept were told by their own size: one that vanishes took others along."""
    scene = bennett()
    scene.joints[cut] = dataclasses.replace(scene.joints[cut], cut=True)
    model = cd.compile(cd.derive(scene, coordinates="relative"))
    given = {name: x for name, x in bennett_angles(0.4).items() if name in model.coordinates}
    how = {"step": 1e-3} if method == "RK4" else {"rtol": 1e-11, "atol": 1e-13}
    motion = model.simulate(2.0, q=given, u={"j0": 8.0}, method=method, **how)
    assert motion.success
    first = motion["j0"]
    assert first.max() > 2 * np.pi  # a full turn
    for name in given:
        exact = np.array([bennett_angles(x)[name] for x in first])
        apart = np.angle(np.exp(1j * (motion[name] - exact)))
        assert np.abs(apart).max() < 1e-9


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a13_redundancy_of_a_loop_without_rows(coordinates: str) -> None:
    """A loop whose group leaves no row raised numpy's 'argmax of an empty sequence'."""
    model = cd.compile(cd.derive(door("door"), coordinates=coordinates))
    found = model.redundancy(q={"h1": 0.3})
    assert found.freedoms == 1
    assert found.redundant == 5


LOCKED = {"frame": braced, "tilted four-bar": tilted, "rounded": lambda: rounded(8)}


@pytest.mark.parametrize("name", LOCKED)
def test_a12_builds_of_circuits_that_cannot_move_are_judged(name: str) -> None:
    """Nothing but rounding was left of their speeds, and the judge took it for their size."""
    scene = LOCKED[name]()
    model = scene if isinstance(scene, cd.CompiledModel) else cd.compile(scene)
    names = "rhs constraints constraint_rates constraint_jacobian mass_matrix qdot integrate"
    model.prepare(*names.split(), "close_position", "close_velocity", "closure")
    result = model.verify()
    assert {"close_position", "close_velocity", "closure"} <= set(result.checked), str(result)
    assert result.worst < 1e-11


def test_what_the_plane_of_a_loop_holds_is_said_to_be_held_by_that() -> None:
    """The report named no reason: conditions that are left out passed for constraints."""
    model = cd.compile(four_bar())
    found = model.redundancy(model.assemble({"A": 0.5}).q)
    assert found.redundant == 3
    assert all("its loop moves in a group that holds it" in text for text in found.directions)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_what_no_mode_holds_is_not_redundant(coordinates: str) -> None:
    """Stiction that does not stick passed for the redundant constraint, of a joint of its name."""
    plain, scene = four_bar(), four_bar()
    scene.force("brake", cd.Friction("A", coulomb=0.1))
    scene.force("other", cd.Friction("D", coulomb=0.1))
    model = cd.compile(scene, coordinates=coordinates)
    q = {"A": 0.5}
    if coordinates == "relative":
        q = model.assemble(q).q
    found = model.redundancy(q)
    alone = cd.compile(plain, coordinates=coordinates).redundancy(q)
    assert (found.constraints, found.rank, found.redundant, found.freedoms) == (
        alone.constraints,
        alone.rank,
        alone.redundant,
        1,
    )
    assert found.directions == alone.directions
    assert found.components == alone.components
    assert found.unique["brake.stick"]
    assert "brake" not in found.loops
    # what sticks counts, and twice is once too often
    sticks = 2.0
    both = model.redundancy(q, s={"brake": sticks, "other": sticks})
    assert both.freedoms == 0
    assert both.redundant == found.redundant + 1
    if coordinates == "relative":
        assert any("'stick' of force 'other'" in text for text in both.directions)
    assert not any("joint 'other'" in text for text in both.directions)
    one = model.redundancy(q, s={"brake": sticks})
    assert (one.freedoms, one.redundant) == (0, found.redundant)
    if coordinates == "relative":
        with pytest.warns(cd.SolveWarning, match="are redundant, rotation about x of joint 'C'"):
            model.reaction("C", q, np.zeros(model.nu))


@pytest.mark.parametrize("rate", [0.0, 1e-17, 1e-12])
def test_a4_rates_of_rounding_explain_no_contradiction(rate: float) -> None:
    """At rest a rate of rounding explained anything: drives against each other passed."""
    scene = cd.Scene("driven_twice", gravity=(0, -9.81, 0))
    rod = cd.inertia.rod(1.0, 1.0, axis="y")
    left, right = (scene.body(name, mass=1.0, inertia=rod) for name in ("left", "right"))
    bar = scene.body("bar", mass=1.0, inertia=cd.inertia.rod(1.0, 1.0, axis="x"))
    for k, crank in enumerate((left, right)):
        motion = rate * cd.t + (k + 1) * cd.t**2
        place = scene.ground.at(k, 0, 0)
        scene.joint(f"A{k}", cd.Revolute("z"), place, crank, prescribed=motion)
    scene.joint("B", cd.Revolute("z"), left.at(0, 1, 0), bar)
    scene.joint("C", cd.Revolute("z"), bar.at(1, 0, 0), right.at(0, 1, 0))
    with pytest.warns(ModelWarning, match="unless their motions agree"):
        model = cd.compile(cd.derive(scene, coordinates="absolute"))
    start = np.r_[model.initial()[: model.nq], np.zeros(model.nu)]
    # closed at the start, where the drives ask for 2 and 4 rad/s^2 of one parallelogram
    assert np.abs(model.constraints(start[: model.nq])).max() < 1e-14
    with pytest.raises(SolveError):
        model.rhs(0.0, start)
