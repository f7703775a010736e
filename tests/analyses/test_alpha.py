"""The generalized-alpha method on mechanisms: orders by slope, step control, what it refuses."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.simulation.driving import runner_of
from cardan.analyses.simulation.run_record import UNSOLVED
from cardan.analyses.simulation.settings import settings
from cardan.analyses.simulation.signals import signals
from cardan.errors import ModelError, SolveWarning
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING
from spread import some

Array = np.ndarray
SPEED = 150.0


def top(name: str = "heavy_top", **options: Any) -> cd.CompiledModel:
    """The fast heavy top: a free body, whose center is held to turn about the ground origin."""
    scene = cd.Scene(name, gravity=(0, 0, -9.81))
    body = scene.body("top", mass=15, com=(0, 0, 0), inertia=(0.234375, 0.46875, 0.234375))
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.joint("pivot", cd.Spherical(), scene.ground, body.at(0, -1, 0), cut=True)
    return cd.compile(scene, **options)


def spinning(model: cd.CompiledModel) -> Array:
    turn = np.array([0.0, SPEED, -4.61538])
    place, speed = [1, 0, 0, 0, 0, 1, 0], [*turn, *np.cross(turn, [0, 1, 0])]
    return np.array([*place, *speed], dtype=float)


def slope(counts: Any, errors: Any) -> float:
    return float(-np.polyfit(np.log(counts), np.log(errors), 1)[0])


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    return top()


class Exact:
    """The motion by another method at tight tolerances."""

    def __init__(self, model: cd.CompiledModel, times: Array) -> None:
        self.times, self.start = times, spinning(model)
        known = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-13}
        self.motion = model.simulate(times, x0=self.start, **known)
        self.lam = np.stack([*self.motion.multipliers.values()], axis=-1)

    def errors(self, model: cd.CompiledModel, since: int = 0, **options: Any) -> list[float]:
        """Largest errors of q, u and multipliers from some output time on."""
        found = model.simulate(self.times, x0=self.start, **options)
        assert found.success
        lam = np.stack([*found.multipliers.values()], axis=-1)
        pairs = ((found.q, self.motion.q), (found.u, self.motion.u), (lam, self.lam))
        return [float(np.abs(a - b)[since:].max()) for a, b in pairs]


@pytest.fixture(scope="module")
def exact(model: cd.CompiledModel) -> Exact:
    return Exact(model, np.linspace(0, 0.2, 41))


@pytest.mark.parametrize("index", [2, 3])
def test_order_of_every_variable(model: cd.CompiledModel, exact: Exact, index: int) -> None:
    method, counts = cd.GeneralizedAlpha(0.8, index=index), np.array([400, 800, 1600])
    # of index 3 multipliers are of the second order once the start has died out
    since = 8 if index == 3 else 0
    errors = [exact.errors(model, since, method=method, step=0.2 / n) for n in counts]
    for name, column in zip(("q", "u", "multipliers"), np.transpose(errors), strict=True):
        print(f"index {index}: {name} of order {slope(counts, column):.3f}")
        assert slope(counts, column) == pytest.approx(2, abs=0.15)


@pytest.mark.parametrize(("index", "order"), [(2, 2), (3, 1)])
def test_multipliers_of_the_first_steps(model: cd.CompiledModel, index: int, order: int) -> None:
    counts, errors = np.array([400, 800, 1600, 3200]), []
    for n in counts:
        # the same number of steps from the start, ever shorter
        exact = Exact(model, np.arange(6) * 0.2 / n)
        method = cd.GeneralizedAlpha(0.8, index=index)
        errors.append(exact.errors(model, method=method, step=0.2 / n)[2])
    print(f"index {index}: multipliers of the first steps are of order {slope(counts, errors):.3f}")
    assert slope(counts, errors) == pytest.approx(order, abs=0.15)


@pytest.mark.parametrize("method", ["GeneralizedAlpha", "HHT", cd.GeneralizedAlpha(0.0)])
def test_order_of_named_methods(model: cd.CompiledModel, exact: Exact, method: Any) -> None:
    counts = np.array([400, 800, 1600])
    errors = [exact.errors(model, method=method, step=0.2 / n)[:2] for n in counts]
    for column in np.transpose(errors):
        assert slope(counts, column) == pytest.approx(2, abs=0.15)


def test_newmark_without_constraints() -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1, com=(0, 0.1, -0.3), inertia=(0.1, 0.2, 0.25))
    scene.joint("ball", cd.Spherical(), scene.ground, body)
    model, counts, errors = cd.compile(scene), np.array([100, 200, 400]), []
    start = {"q": {"ball": (0.8, 0, 0.6, 0)}, "u": {"ball": (1.0, 5.0, -2.0)}}
    exact = model.simulate([0, 1.0], **start, rtol=1e-13, atol=1e-13)
    for n in counts:
        motion = model.simulate([0, 1.0], **start, method="Newmark", step=1.0 / n)
        errors.append(np.abs(motion.x[-1] - exact.x[-1]).max())
    assert slope(counts, errors) == pytest.approx(2, abs=0.15)


@pytest.mark.parametrize("index", [2, 3])
def test_error_follows_the_tolerance(model: cd.CompiledModel, exact: Exact, index: int) -> None:
    tolerances = 10.0 ** -np.arange(4, 9)
    errors, rejected, steps = [], 0, 0
    for tolerance in tolerances:
        options = {"rtol": tolerance, "atol": 1e-3 * tolerance}
        method = cd.GeneralizedAlpha(0.8, index=index)
        errors.append(exact.errors(model, method=method, **options)[0])
        run = model.simulate(0.2, x0=exact.start, method=method, **options)
        rejected, steps = rejected + run.statistics["rejections"], steps + run.statistics["steps"]
        # the dead band: matrices serve many steps
        assert run.statistics["factorizations"] <= run.statistics["steps"]
        if tolerance <= 1e-7:
            assert run.statistics["factorizations"] <= 0.3 * run.statistics["steps"]
    # error per step h^3, and h^2 of it in the end: tolerance^(2/3)
    found = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    print(f"index {index}: error ~ tolerance^{found:.3f}, {rejected} of {steps} rejected")
    assert found == pytest.approx(2 / 3, abs=0.07)
    assert rejected <= 0.02 * steps


def test_condition_does_not_depend_on_the_step(model: cd.CompiledModel) -> None:
    for index in (2, 3):
        method = cd.GeneralizedAlpha(0.8, index=index)
        how = settings(method, 1e-6, 1e-9, 1e-3, None, 1.0)
        runner = runner_of(model, how, signals([], None, None, (0.0, 1.0)))
        runner.want(None, dense=False)
        assert runner.start(0.0, spinning(model), [1.0]) == 0
        matrix = np.zeros((model.nu + 2 * model.nlam) ** 2)
        call = runner.library.cardan_alpha_matrix
        call.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]
        call.restype = ctypes.c_ssize_t
        conditions = {}
        for h in 10.0 ** -np.arange(2, 10):
            n = call(ctypes.addressof(runner.record), h, matrix.ctypes.data)
            conditions[h] = np.linalg.cond(matrix[: n * n].reshape(n, n))
        print(f"index {index}: " + ", ".join(f"{h:.0e}: {c:.3g}" for h, c in conditions.items()))
        small = [c for h, c in conditions.items() if h <= 1e-4]
        assert max(conditions.values()) < 100
        assert max(small) < 1.05 * min(small)


MODEL_FUNCTION = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_void_p, ctypes.POINTER(ctypes.c_double), ctypes.c_void_p
)


@pytest.mark.parametrize("rtol", [1e-6, 1e-8])
@pytest.mark.parametrize("longer", [1.0, 1e12])
def test_speeds_that_come_open_fail_their_step(longer: float, rtol: float) -> None:
    """Rows that a matrix takes for so much longer make all corrections small, and close nothing.

    At steps of 10 us what speeds miss moves nothing to speak of in a step: it counts by itself.
    """
    model = cd.compile(CLOSED["four_bar"].build())
    state = CLOSED["four_bar"].state(0.3, 1.0, {row["name"] for row in model.manifest["joints"]})
    start = model.simulate([0, 1e-9], q=state.q, u=state.u).x[0]
    how = settings(cd.GeneralizedAlpha(0.8), rtol, 1e-3 * rtol, None, 1e-5, 1.0)
    runner = runner_of(model, how, signals([], None, None, (0.0, 1.0)))
    runner.want(None, dense=False)
    assert runner.start(0.0, start, [1.0]) == 0
    nu, m = model.nu, model.nlam
    right = MODEL_FUNCTION(runner.record.balance_tangent)

    def wrong(given: Any, out: Any, work: Any) -> int:
        """K C M (nu, nu) each, R and G (m, nu): G is made longer."""
        status: int = right(given, out, work)
        for k in range(m * nu):
            out[3 * nu * nu + m * nu + k] *= longer
        return status

    kept = MODEL_FUNCTION(wrong)
    runner.record.balance_tangent = ctypes.cast(kept, ctypes.c_void_p).value
    answer = runner.drive(2000)
    numbers = ctypes.cast(runner.record.y, ctypes.POINTER(ctypes.c_double))
    q, u = model.split(np.array(numbers[: model.nq + nu]))
    missed = float(np.abs(model.constraint_rates(q, u)).max())
    print(f"{longer}, {rtol}: {runner.record.steps} steps, {missed:.1e} m/s left")
    assert (answer == UNSOLVED) == (longer > 1)
    # the tolerance times the speed of the links, 1.1 to 1.2 rad/s
    assert missed <= 1.5 * rtol


# of the largest one index by default
MECHANISMS = [(name, index) for name in ("stewart", "four_bar", "bricard") for index in (2, 3)]


@pytest.mark.parametrize(("name", "index"), [*some(MECHANISMS[:2], 2, 1), *MECHANISMS[2:]])
def test_circuits(name: str, index: int) -> None:
    """Redundant rows too: Bricard's has one more than it has conditions."""
    model = cd.compile(CLOSED[name].build())
    state = CLOSED[name].state(0.3, 1.0, {row["name"] for row in model.manifest["joints"]})
    times, counts, errors = np.linspace(0, 0.3, 11), np.array([100, 200, 400]), []
    exact = model.simulate(times, q=state.q, u=state.u, rtol=1e-12, atol=1e-13)
    for n in counts:
        method = cd.GeneralizedAlpha(0.8, index=index)
        motion = model.simulate(times, q=state.q, u=state.u, method=method, step=0.3 / n)
        assert motion.success
        errors.append(np.abs(motion.q - exact.q).max())
        worst = motion.drift.position.values()
        assert max(row.after for row in worst) < 1e-10
    print(f"{name}, index {index}: {errors}, order {slope(counts, errors):.3f}")
    assert slope(counts, errors) == pytest.approx(2, abs=0.15)


@pytest.mark.parametrize("name", ["skate", "tire"])
def test_rolling(name: str) -> None:
    """Constraints of velocities."""
    model = cd.compile(ROLLING[name]())
    x = model.random_state(3)
    q, u = model.split(x)
    u = model.close_velocity(q, u)[: model.nu]
    exact, counts, errors = model.simulate([0, 0.5], q=q, u=u, rtol=1e-12), (100, 200, 400), []
    for n in counts:
        motion = model.simulate([0, 0.5], q=q, u=u, method="GeneralizedAlpha", step=0.5 / n)
        assert motion.success, motion.message
        errors.append(np.abs(motion.q[-1] - exact.q[-1]).max())
    assert slope(counts, errors) == pytest.approx(2, abs=0.15)


def test_long_rotations_in_a_step(model: cd.CompiledModel) -> None:
    """Half a turn and more in a step: the tangent operator stands in the iteration matrix."""
    motion = model.simulate(1.0, x0=spinning(model), method="GeneralizedAlpha", step=0.015)
    assert motion.success
    assert np.abs(np.linalg.norm(motion.q[:, :4], axis=1) - 1).max() < 1e-14
    # corrections that a wrong matrix would need many of
    assert motion.statistics["evaluations"] <= 12 * motion.statistics["steps"]


def test_inputs_work_and_backwards() -> None:
    scene = cd.Scene("driven", gravity=(0, 0, -9.81))
    push = scene.input("push")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=cd.inertia.rod(1, 1, axis="z"))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    scene.force("motor", cd.JointForce("pivot", push))
    model = cd.compile(scene)
    given = {"push": ([0, 0.5, 0.5, 1], [0, 1, -1, 0.5])}
    exact = model.simulate(1.0, q={"pivot": 1.0}, inputs=given, rtol=1e-11, atol=1e-12)
    motion = model.simulate(
        1.0, q={"pivot": 1.0}, inputs=given, method="GeneralizedAlpha", rtol=1e-8, atol=1e-9
    )
    assert np.abs(motion.at(0.77) - exact.at(0.77)).max() < 1e-4
    assert np.abs(motion.energy_residual).max() < 1e-4
    # the jump is between two steps
    assert np.any(motion.t == 0.5)
    back = model.simulate(
        (1.0, 0.0), x0=exact.x[-1], inputs=given, method="GeneralizedAlpha", rtol=1e-8, atol=1e-9
    )
    assert back["pivot"][-1] == pytest.approx(1.0, abs=1e-4)


def test_function_of_time() -> None:
    scene = cd.Scene("driven")
    push = scene.input("push")
    cart = scene.body("cart", mass=2)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
    scene.force("motor", cd.JointForce("slide", push))
    model, errors = cd.compile(scene), []
    for n in (50, 100, 200):
        motion = model.simulate(
            [0, 1.0], inputs={"push": lambda t, x: np.cos(3 * t)}, method="HHT", step=1.0 / n
        )
        errors.append(abs(motion["slide"][-1] - (1 - np.cos(3.0)) / 18))
    assert slope((50, 100, 200), errors) == pytest.approx(2, abs=0.15)


def test_without_damping_constraints_are_refused_or_capped(model: cd.CompiledModel) -> None:
    start = spinning(model)
    motion = model.simulate(0.05, x0=start, method=cd.GeneralizedAlpha(1.0), step=1e-3)
    assert "rho_inf 0.95 as constraints ask for damping" in motion.solver_info.settings
    for method in ("Newmark", cd.GeneralizedAlpha(coefficients=cd.stability.Alpha.hht(0.0))):
        with pytest.raises(ModelError, match=r"it needs damping, at most 0\.95"):
            model.simulate(0.05, x0=start, method=method)


def test_refusals(model: cd.CompiledModel) -> None:
    with pytest.raises(ModelError, match=r"index=1 is 2 .* or 3"):
        cd.GeneralizedAlpha(index=1)
    with pytest.raises(ModelError, match="rho_inf=2 lies outside"):
        cd.GeneralizedAlpha(2.0)
    soft = top(constraints="penalty")
    with pytest.raises(ModelError, match="compile with constraints='multipliers'"):
        soft.simulate(0.1, x0=spinning(model), method="GeneralizedAlpha")
    few = top("few", functions=["rhs", "qdot", "close_position", "close_velocity"])
    with pytest.raises(ModelError, match="needs the function 'balance'"):
        few.simulate(0.1, x0=spinning(model), method="GeneralizedAlpha")


def test_a_step_that_cannot_be_solved_is_said(model: cd.CompiledModel) -> None:
    with pytest.warns(SolveWarning, match="the equations of a step of 3 s were not solved"):
        motion = model.simulate(30.0, x0=spinning(model), method="GeneralizedAlpha", step=3.0)
    assert motion.status == "not_solved"
    assert len(motion) >= 1


def test_multipliers_are_kept(model: cd.CompiledModel, tmp_path: Any) -> None:
    motion = model.simulate(0.02, x0=spinning(model), method="GeneralizedAlpha", step=1e-4)
    found = motion.multipliers
    assert list(found) == list(model.multipliers_of)
    loaded = cd.load_motion(motion.save(tmp_path / "top.nc"))
    for name, history in found.items():
        assert history.shape == motion.t.shape
        np.testing.assert_array_equal(loaded.multipliers[name], history)


def test_stepper_and_checkpoint(model: cd.CompiledModel) -> None:
    stepper = model.stepper(x0=spinning(model), method="GeneralizedAlpha", rtol=1e-6)
    stepper.step(0.01)
    saved = stepper.save()
    first = stepper.step(0.01)
    stepper.restore(saved)
    np.testing.assert_array_equal(stepper.step(0.01), first)
    exact = model.simulate([0, 0.02], x0=spinning(model), rtol=1e-12).x[-1]
    # relative to speeds of 150 rad/s
    assert np.abs(first - exact).max() < 150 * 1e-4


def test_events_end_segments() -> None:
    """Sticking is a constraint that comes and goes."""
    scene = cd.Scene("oscillator")
    block = scene.body("block", mass=2)
    scene.joint("x", cd.Prismatic("x"), scene.ground, block)
    scene.force("spring", cd.JointSpring("x", stiffness=50))
    scene.force("rail", cd.Friction("x", coulomb=4.0))
    model = cd.compile(scene)
    motion = model.simulate(4.0, q={"x": 1.0}, method="GeneralizedAlpha", rtol=1e-8)
    # every half cycle takes 2 x 4 / 50 of the amplitude, until the spring is too weak
    half = np.pi * np.sqrt(2 / 50)
    stops = [event.t for event in motion.events if event.name == "rail.stop"]
    assert stops == pytest.approx(half * np.arange(1, 7), abs=1e-4)
    assert motion["x"][-1] == pytest.approx(1.0 - 6 * 0.16, abs=1e-5)
    assert motion["x.u"][-1] == pytest.approx(0.0, abs=1e-12)
    # what holds it there is what the spring pulls
    assert motion.multipliers["rail.stick"][-1] == pytest.approx(50 * motion["x"][-1], abs=1e-6)
