"""Laws of every force element: potentials and power, action and reaction, guards, messages."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf, nan
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.elements.forces import FORCES
from cardan.elements.forces.force import Action, ForceElement
from cardan.ir.derivative import gradient
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.exponential import exp
from elements.force_bench import BY_MASS, INSTANCES, RATES, STATE, Bench
from spatial.numbers_of import block, close, difference, moving, numbers
from table import each


@pytest.fixture(params=INSTANCES)
def bench(request: pytest.FixtureRequest) -> Bench:
    return Bench(INSTANCES[request.param])


def test_every_element_is_tested() -> None:
    assert {element.kind for element in INSTANCES.values()} == set(FORCES)
    assert all(FORCES[e.kind] is type(e) and e.source for e in INSTANCES.values())


def test_power_is_what_the_potential_loses(bench: Bench) -> None:
    paths = {name: moving(STATE[name], RATES[name]) for name in STATE}
    stored = [action for action in bench.actions if action.potential is not None]
    spring = bool(np.any(getattr(bench.element, "stiffness", 0)))
    spring |= bool(getattr(bench.element, "tables", ()))
    spring &= bench.element.kind != "maxwell"
    spring |= bench.element.kind in ("flexible_hinge", "cable")
    field = bench.element.masses() is not None
    assert len(stored) == (spring or (field and getattr(bench.element, "force", True)))
    for action in stored:

        def energy(t: Any, action: Action = action) -> Any:
            return bench.value(action.potential, **{k: path(t) for k, path in paths.items()})

        assert close([bench.value(bench.power(action)) + difference(energy)], 0)
        assert energy(0) > 0 or field or bench.element is INSTANCES["slack cable"]


DAMPERS = [name for name in INSTANCES if "damp" in name or name == "elastic drive"]


@pytest.mark.parametrize("name", DAMPERS)
def test_dampers_take_power(name: str) -> None:
    """Whatever the speeds; of the elastic drive, the shaft."""
    bench, rng = Bench(INSTANCES[name]), np.random.default_rng(11)
    (damper,) = [action for action in bench.actions if action.potential is None][:1]
    for _ in range(5):
        rates = {f"v_{name}": rng.normal(size=len(x)) for name, x in STATE.items()}
        assert bench.value(bench.power(damper), **rates) < 0


BETWEEN_TWO = ("spring_damper", "maxwell", "bushing", "flexible_hinge", "cable")
BETWEEN = [n for n, e in INSTANCES.items() if e.kind in BETWEEN_TWO]
BETWEEN += BY_MASS


@each("name", BETWEEN)
def test_forces_between_frames_are_balanced(name: str) -> None:
    """Force and moment about the origin of what acts between two frames sum to zero."""
    bench = Bench(INSTANCES[name])
    for action in bench.actions:
        force, moment = Matrix.zeros(bench.motion.graph, 3), Matrix.zeros(bench.motion.graph, 3)
        for load in action.loads:
            force = force + load.force
            position = bench.motion.position(load.frame)
            moment = moment + load.torque + position.cross(load.force)
        assert len(action.loads) == 2
        assert close(bench.value(force), 0, 70)
        assert close(bench.value(moment), 0, 70)


def load_of(element: ForceElement, k: int = 0) -> np.ndarray:
    """Torque and force of the first load, or a joint force, summed over the actions; floats."""
    bench = Bench(element)
    total = 0.0
    for action in bench.actions:
        if action.loads:
            load = action.loads[k]
            total = total + bench.value(Matrix.vstack(load.torque, load.force), "float")
        for joint_load in action.joint_loads:
            if joint_load.joint == k:
                total = total + bench.value(joint_load.force, "float")
    return total


# values in closed form


def test_spring_and_damper_in_closed_form() -> None:
    span = np.subtract(STATE["x1"], STATE["x0"])
    distance = np.linalg.norm(span)
    rate = span @ np.subtract(RATES["x1"], RATES["x0"]) / distance
    wanted = (30.0 * (distance - 0.4) + 4.0 * rate) * span / distance
    found = load_of(INSTANCES["spring and damper"])
    np.testing.assert_allclose(found, [0, 0, 0, *wanted], rtol=1e-13)


def test_loads_turn_with_their_axes() -> None:
    R = numbers(exp(Matrix.vector(Graph(), STATE["r1"])))
    force, torque = load_of(INSTANCES["force in axes"]), load_of(INSTANCES["torque in axes"])
    np.testing.assert_allclose(force, [0, 0, 0, *(R @ (1.0, -2.0, 0.5))], rtol=1e-14)
    np.testing.assert_allclose(torque, [*(R @ (0.3, 0.0, -2.0)), 0, 0, 0], rtol=1e-14)
    assert np.array_equal(load_of(INSTANCES["force"]), [0, 0, 0, 1.0, -2.0, 0.5])
    assert np.array_equal(load_of(INSTANCES["torque"]), [0.3, 0.0, -2.0, 0, 0, 0])


def test_joint_elements_in_closed_form() -> None:
    q, u = STATE["q0"][0], RATES["q0"][0]
    assert load_of(INSTANCES["torsion spring"]) == pytest.approx([-7.0 * (q - 0.2)], rel=1e-15)
    wanted = [-7.0 * q - 0.3 * u]
    assert load_of(INSTANCES["torsion spring and damper"]) == pytest.approx(wanted, rel=1e-14)
    assert np.array_equal(load_of(INSTANCES["joint forces"], 1), [3.0, -1.0])
    np.testing.assert_allclose(load_of(INSTANCES["damping"], 1), [-0.8 * 0.6, -0.8 * 0.9])
    # reflected through the gear: torque by the ratio, friction by its square
    wanted = [50.0 * 0.6 - 50.0**2 * 0.02 * u]
    assert load_of(INSTANCES["rigid drive"]) == pytest.approx(wanted, rel=1e-14)


def test_elastic_drive_in_closed_form() -> None:
    q, u, angle, speed = STATE["q0"][0], RATES["q0"][0], STATE["q2"][0], RATES["q2"][0]
    shaft = 90.0 * (angle / 20 - q) + 1.5 * (speed / 20 - u)
    drive = INSTANCES["elastic drive"]
    assert load_of(drive) == pytest.approx([shaft], rel=1e-13)
    rotor = 0.6 - 0.02 * speed - shaft / 20
    assert load_of(drive, 2) == pytest.approx([rotor], rel=1e-12)


def test_rotor_of_a_drive() -> None:
    """Reflected inertia, or a body that turns by itself."""
    rigid = Bench(INSTANCES["rigid drive"])
    added = rigid.element.rotor_inertia(rigid.data)["joint"]
    assert rigid.value(added[0], "float") == pytest.approx(50.0**2 * 0.1, rel=1e-15)
    assert rigid.element.rotor() is None
    for name, elastic in (("gyroscopic drive", False), ("elastic drive", True)):
        bench = Bench(INSTANCES[name])
        rotor = bench.element.rotor()
        assert (rotor.inertia, rotor.joint) == (0.1, "one")
        assert rotor.ratio == (None if elastic else bench.element.ratio)
        assert not bench.element.rotor_inertia(bench.data)


def test_what_is_zero_does_not_act() -> None:
    assert not Bench(cd.SpringDamper("A", "B")).actions
    assert not Bench(cd.JointSpring("one")).actions
    assert not Bench(cd.JointDamper("two", 0.0)).actions


# guards


@pytest.mark.parametrize("name", ["spring", "spring of no length", "damper", "spring and damper"])
def test_where_the_points_of_a_spring_meet_nothing_pulls(name: str) -> None:
    """No force, and no NaN in it, in the energy, or in their derivatives."""
    bench = Bench(INSTANCES[name])
    meeting = {"x1": STATE["x0"]}
    for action in bench.actions:
        pull = action.loads[0].force
        assert np.array_equal(bench.value(pull, "float", **meeting), np.zeros(3))
        assert np.isfinite(bench.value(bench.power(action), "float", **meeting))
        roots = [*pull.nodes, *([action.potential.node] if action.potential else [])]
        at = [*bench.motion.position(0).nodes, *bench.motion.position(1).nodes]
        for root in roots:
            slopes = gradient(bench.motion.graph, root, at)
            column = Matrix(bench.motion.graph, len(slopes), 1, slopes)
            assert np.isfinite(bench.value(column, "float", **meeting)).all()


def test_a_spring_of_no_length_is_smooth_where_its_points_meet() -> None:
    bench = Bench(INSTANCES["spring of no length"])
    pull, at = bench.actions[0].loads[0].force, bench.motion.position(1).nodes
    for k, root in enumerate(pull.nodes):
        slopes = gradient(bench.motion.graph, root, at)
        found = bench.value(Matrix(bench.motion.graph, 3, 1, slopes), "float", x1=STATE["x0"])
        np.testing.assert_allclose(found, 30.0 * np.eye(3)[k], rtol=1e-15)


@pytest.mark.parametrize("away", [1e-9, 1e-150])
def test_next_to_the_meeting_point_the_force_has_its_full_size(away: float) -> None:
    bench = Bench(INSTANCES["spring"])
    pull = bench.actions[0].loads[0].force
    zero = [0.0, 0.0, 0.0]
    found = bench.value(pull, "float", x0=zero, x1=[0.0, away, 0.0])
    np.testing.assert_allclose(found, [0.0, 30.0 * (away - 0.4), 0.0], rtol=1e-12)


# potentials only of what is constant


@pytest.mark.parametrize(
    ("element", "name"),
    [
        (cd.SpringDamper("A", "B", 2.0, rest_length=1.0), "rest_length"),
        (cd.JointSpring("one", 2.0), "rest"),
        (cd.CentralGravity("A", 3.0, "B"), "mu"),
        (cd.J2("A", 3.0, 0.1, 0.7, bodies="B"), "j2"),
    ],
)
def test_a_spring_that_is_driven_has_no_potential(element: ForceElement, name: str) -> None:
    """A parameter keeps it; a coordinate or time in it works on the system. With time it has one at
    every instant."""
    bench = Bench(element)
    for source, stored, instant in (("p", True, True), ("q0", False, False), ("t", False, True)):
        bench.data[name] = block(bench.motion.graph, source, 1)
        (action,) = bench.act()
        assert (action.stored is not None) == stored
        assert (action.potential is not None) == instant


# messages

x = sympy.Symbol("x")
BAD: dict[str, tuple[Callable[[], ForceElement], str]] = {
    "two": (lambda: cd.Force("A", (1, 2)), "force: force has 2 entries; give 3"),
    "text": (lambda: cd.Force("A", "up"), "force: force is 'up'; give 3 numbers"),
    "nan": (lambda: cd.Torque("A", (0, nan, 0)), r"torque: torque\[1\] is nan; give a finite"),
    "none": (
        lambda: cd.JointDamper("one", None),
        "joint_damper: damping is None; give a finite number",
    ),
    "inf": (
        lambda: cd.SpringDamper("A", "B", stiffness=inf),
        "spring_damper: stiffness is inf; give a finite number, a parameter or an expression",
    ),
    "complex": (lambda: cd.JointSpring("one", 1j), r"joint_spring: stiffness is 1j; give"),
    "true": (lambda: cd.JointForce("one", True), "joint_force: force is True; give"),
    "entry": (lambda: cd.JointForce("two", (x, "a")), r"joint_force: force\[1\] is 'a'; give"),
    "ratio": (lambda: cd.Drive("one", 0.1, ratio="50"), "drive: ratio is '50'; give a finite"),
    "wheel": (
        lambda: cd.Rotor("A", inertia=1.0, speed=1.0, torque=2.0),
        r"rotor: momentum, speed and torque \(with friction\) exclude each other; give one",
    ),
    "wheel inertia": (lambda: cd.Rotor("A", speed=1.0), "rotor: give inertia about the axis, or"),
    "wheel friction": (lambda: cd.Rotor("A", inertia=1, friction=-1), "friction is -1; give 0 or"),
    "mu": (lambda: cd.CentralGravity("A", -1.0), "central_gravity: mu is -1; give 0 or more"),
    "bodies": (lambda: cd.J2("A", 1.0, 0.1, 1.0, bodies=3), "j2: 3 is not a body; give a body"),
    "body twice": (lambda: cd.CentralGravity("A", 1.0, ["B", "B"]), "body 'B' is named twice"),
    "force": (lambda: cd.GravityGradient("A", 1.0, force=1), "force is True or False, not 1"),
    "shaft": (lambda: cd.Drive("one", 0.1, stiffness=nan), "drive: stiffness is nan; give"),
}


@each("make", BAD)
def test_bad_input_is_named(make: str) -> None:
    call, message = BAD[make]
    with pytest.raises(cd.ModelError, match=message):
        call()


def test_joints_with_the_wrong_number_of_coordinates() -> None:
    for element in (
        replace(INSTANCES["torsion spring"], joint="two"),
        replace(INSTANCES["rigid drive"], joint="two"),
    ):
        with pytest.raises(cd.ModelError, match=r"on joint 'two': the joint has 2 coordinates"):
            Bench(element)
    with pytest.raises(
        cd.ModelError, match=r"'one': force has 2 values for a joint of 1 speed; give 1"
    ):
        Bench(replace(INSTANCES["joint forces"], joint="one"))


def test_a_momentum_that_is_turned_takes_no_power() -> None:
    bench = Bench(INSTANCES["rotor of constant momentum"])
    assert np.abs(load_of(bench.element, 0)).max() > 0.1
    assert close([bench.value(bench.power(bench.actions[0]))], 0)
