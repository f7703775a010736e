"""Runs of closed systems: closed at all times, assembled at the start, the same everywhere."""

from __future__ import annotations

import pickle
import subprocess
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from analyses.test_assemble import driven_four_bar
from analyses.test_sweep import input_four_bar
from cardan.build import cache
from mechanisms.closed import CLOSED
from mechanisms.closed_planar import four_bar, four_bar_angles, parallelogram

SIZE = 0.3  # of the four-bar [m]
BOTH = pytest.mark.parametrize(
    "options", [{"rtol": 1e-8}, {"method": "RK4", "step": 1e-3}], ids=str
)


@pytest.fixture(scope="module")
def bars() -> cd.CompiledModel:
    return cd.compile(four_bar())


def residuals(model: cd.CompiledModel, x: np.ndarray) -> tuple[float, float]:
    """Largest residual of positions and of velocities."""
    q, u = model.split(x)
    rates = model.constraint_rates(q, u)
    return float(np.abs(model.constraints(q)).max()), float(np.abs(rates).max())


def test_a_thousand_seconds_of_a_crank_rocker(bars: cd.CompiledModel) -> None:
    """No singular position on the way: closed to 1e-10 of the size all the time."""
    motion = bars.simulate(1000.0, q={"A": 0.5}, u={"A": 12.0}, rtol=1e-8, check=True)
    position, velocity = residuals(bars, motion.x)
    between = residuals(bars, motion.at(np.linspace(0, 1000, 20001)))
    scale = motion.energy.kinetic.max()
    print(f"{motion.statistics['milliseconds']:.0f} ms, {len(motion)} steps")
    print(f"residuals {position:.1e} m, {velocity:.1e} m/s; between steps {between}")
    print(f"drift of energy {np.abs(motion.energy_residual).max() / scale:.1e}")
    fastest = np.abs(motion.u).max()
    assert max(position, between[0]) < 1e-10 * SIZE
    assert max(velocity, between[1]) < 1e-10 * SIZE * fastest
    # the crank turns round and round; energy is kept to 1e4 local errors
    assert motion["A"][-1] > 100
    assert np.abs(motion.energy_residual).max() < 1e-4 * scale
    assert "position of 'C." in repr(motion)
    assert "before projection" in repr(motion)


@pytest.mark.parametrize("name", CLOSED)
def test_every_mechanism_stays_closed(name: str) -> None:
    member = CLOSED[name]
    model = cd.compile(member.build())
    slots = {row["joint"] for row in model.manifest["coordinates"]}
    state = member.state(0.1, 0.5, slots)
    motion = model.simulate(0.02, q=state.q, u=state.u, rtol=1e-8, check=True)
    position, velocity = residuals(model, motion.x)
    assert position < 1e-11
    assert velocity < 1e-10 * max(1, np.abs(motion.u).max())
    ledger = motion.ledger
    assert ledger is not None
    assert [*ledger.velocity] == [row["name"] for row in model.manifest["multipliers"]]


@BOTH
def test_named_coordinates_are_held_and_the_rest_assembled(
    bars: cd.CompiledModel, options: dict
) -> None:
    motion = bars.simulate(0.1, q={"A": 1.0}, u={"A": 3.0}, **options)
    assert motion["A"][0] == pytest.approx(1.0, abs=1e-15)
    assert motion["A.u"][0] == pytest.approx(3.0, abs=1e-13)
    assert max(residuals(bars, motion.x[:1])) < 1e-13
    assert set(motion.solver_info.defaulted) == {"B", "D", "B.u", "D.u"}
    assert "assembled: B = " in repr(motion)


def test_rounded_numbers_are_taken(bars: cd.CompiledModel) -> None:
    known = {name: round(value, 6) for name, value in four_bar_angles(1.0).items() if name != "C"}
    for q in (known, [known[name] for name in bars.coordinates]):
        motion = bars.simulate(0.1, q=q)
        np.testing.assert_allclose(motion.q[0], [known[n] for n in bars.coordinates], atol=2e-6)
        assert max(residuals(bars, motion.x[:1])) < 1e-13
    again = bars.simulate(0.1, x0=motion.x[-1])
    # one more projection: some roundings of speeds
    np.testing.assert_allclose(again.x[0], motion.x[-1], rtol=1e-14, atol=1e-14)


def test_a_start_that_contradicts_itself(bars: cd.CompiledModel) -> None:
    said = r"'A' \(asked 1.*'D' \(asked 2\.5.*are inconsistent\. Name fewer coordinates"
    with pytest.raises(cd.ModelError, match=said):
        bars.simulate(1.0, q={"A": 1.0, "D": 2.5})
    with pytest.raises(cd.ModelError, match=r"Name fewer coordinates at the start"):
        bars.simulate(1.0, x0=np.array([0.5, 0.5, 0.5, 0, 0, 0]))
    with pytest.raises(cd.ModelError, match="speeds of 'A', 'D' are inconsistent"):
        bars.simulate(1.0, q={"A": 1.0}, u={"A": 1.0, "D": 1.0})
    with pytest.raises(cd.ModelError, match=r"all speeds are given.* 'C' would come apart"):
        bars.simulate(1.0, q={"A": 1.0}, u=[1.0, 1.0, 1.0])
    with pytest.raises(cd.ModelError, match="no joint or coordinate 'E'"):
        bars.stepper(q={"E": 1.0})


@BOTH
def test_checkpoints_are_bit_for_bit(bars: cd.CompiledModel, options: dict) -> None:
    stepper = bars.stepper(q={"A": 1.0}, u={"A": 5.0}, **options)
    stepper.step(0.2)
    saved = stepper.save()
    first = [stepper.step(0.05) for _ in range(4)]
    stepper.restore(saved)
    again = [stepper.step(0.05) for _ in range(4)]
    np.testing.assert_array_equal(first, again)
    assert max(residuals(bars, np.array(again))) < 1e-12


@pytest.mark.parametrize("t", [0.3, np.linspace(0, 0.3, 7)], ids=["steps", "times"])
@BOTH
def test_without_a_compiler(bars: cd.CompiledModel, bare, options: dict, t) -> None:
    start = {"q": {"A": 1.0}, "u": {"A": 5.0}}
    compiled = bars.simulate(t, **start, **options)
    plain = bare(bars).simulate(t, **start, **options)
    np.testing.assert_allclose(plain.x[-1], compiled.x[-1], rtol=0, atol=1e-6)
    assert max(residuals(bars, plain.x)) < 1e-12
    assert plain.ledger is not None
    assert [*plain.ledger.position] == ["C.px", "C.py"]


def test_a_singular_start_needs_all_speeds() -> None:
    """All links on one line: every crank could turn either way."""
    model = cd.compile(parallelogram())
    flat = dict.fromkeys(model.coordinates, 0.0)
    said = r"start is a singular position: 2 of 4 independent .* joint 'C\d'\. Give all speeds"
    with pytest.raises(cd.ModelError, match=said):
        model.simulate(1.0, q=flat, u={"A0": 1.0})
    turning = {name: 1.0 if name.startswith(("A", "C")) else -1.0 for name in model.coordinates}
    motion = model.simulate(1.0, q=flat, u=turning, rtol=1e-8, check=True)
    np.testing.assert_allclose(motion["A2"], motion["A0"], rtol=0, atol=1e-9)
    # what is redundant everywhere is not singular
    assert cd.compile(CLOSED["bricard"].build()).simulate(0.01).success


@BOTH
def test_prescribed_motions_are_followed(options: dict) -> None:
    """No freedom is left: the run follows the closed form, driven by time or by an input."""
    times = np.linspace(0, 1.5, 31)
    driven, by_input = cd.compile(driven_four_bar()), cd.compile(input_four_bar())
    start = driven.assemble(branch={"D": "+"}).x
    by_time = driven.simulate(times, x0=start, **options)
    given = {"angle": (times, 1 + 2 * times)}
    follows = by_input.simulate(1.5, x0=start, inputs=given, **options)
    expected = np.array([four_bar_angles(1 + 2 * t)["D"] for t in times])
    np.testing.assert_allclose(by_time["D"], expected, rtol=0, atol=1e-12)
    q, u = by_input.split(follows.at(times))
    np.testing.assert_allclose(q[:, by_input.coordinates.index("D")], expected, rtol=0, atol=1e-12)
    r = follows.resample(times).r
    assert np.abs(by_input.constraints(q, r=r)).max() < 1e-13
    assert np.abs(by_input.constraint_rates(q, u, r=r)).max() < 1e-12


def test_penalties_give_way() -> None:
    """Such a system is not projected: what holds it together is that its constraints are open."""
    model = cd.compile(cd.derive(four_bar(), constraints="penalty"))
    motion = model.simulate(0.5, q={"A": 1.0}, u={"A": 5.0}, rtol=1e-8)
    exact = cd.compile(four_bar()).simulate(0.5, q={"A": 1.0}, u={"A": 5.0}, rtol=1e-8)
    worst = max(np.abs(values).max() for values in motion.constraints.values())
    # forces of some N at 1e7 kg (20 rad/s)^2
    assert 1e-13 < worst < 1e-6
    assert motion.ledger is None
    assert "not projected" in repr(motion)
    np.testing.assert_allclose(motion.x[-1], exact.x[-1], rtol=0, atol=1e-4)


def test_files_and_pickles_keep_the_ledger(bars: cd.CompiledModel, tmp_path: Path) -> None:
    motion = bars.simulate(0.2, q={"A": 1.0})
    history = motion.constraints
    saved = cd.load_motion(motion.save(tmp_path / "run.nc"))
    for other in (saved, pickle.loads(pickle.dumps(motion))):
        assert other.ledger == motion.ledger
        for name, values in history.items():
            np.testing.assert_array_equal(other.constraints[name], values)


def test_exported_integrators_keep_circuits_closed(tmp_path: Path) -> None:
    scene = cd.Scene("pendulum", gravity=(0, -9.81, 0))
    bob = scene.body("bob", mass=1.0, com=(0, 0, 0), inertia=(0.01, 0.01, 0.01))
    scene.joint("plane", cd.Planar(), scene.ground, bob, q0=(0.6, -0.8, 0.0))
    scene.joint("pin", cd.Revolute("z"), scene.ground, bob.at(-0.6, 0.8, 0))
    equations = cd.derive(scene)
    folder = equations.export(tmp_path / "c", ["rhs"], language="c", integrators=["dop853"])
    files = sorted(map(str, folder.glob("*.c")))
    command = [*cache.compiler().command, "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror"]
    command += ["-DCARDAN_EXAMPLE", "-o", str(tmp_path / "run"), *files, "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    said = subprocess.run([str(tmp_path / "run")], capture_output=True, text=True, check=True)
    x = [float(line.split("=")[1]) for line in said.stdout.splitlines() if line.startswith("x[")]
    model = cd.compile(equations)
    motion = model.simulate(1.0, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(x, motion.x[-1], rtol=0, atol=1e-7)
