"""What surrounds the C: calls, steps and runs from Python, beside other programs that Python calls.

Writes docs/performance/python_calls.md, or nothing with ``--quick``.

usage: python_calls.py [--quick]
"""

from __future__ import annotations

import argparse
import cProfile
import importlib
import platform
import pstats
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from time import thread_time
from typing import Any

# the zoo stands in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np

import cardan as cd
from benchmarks.all_figures import save
from benchmarks.page import markdown
from benchmarks.provenance import signed
from cardan.analyses.simulation.driving import runner_of
from cardan.analyses.simulation.recorder import can_wait
from cardan.analyses.simulation.run import SOME_STEPS
from cardan.analyses.simulation.settings import settings
from cardan.analyses.simulation.signals import signals
from cardan.analyses.simulation.spare_runners import rewind
from cardan.peers.processor import name as processor
from cardan.runtime.build import cache
from cardan.runtime.calls import samples
from cardan.runtime.calls.batch import one_by_one
from mechanisms import robots

PAGE = Path(__file__).parents[2] / "docs" / "performance" / "python_calls.md"
Array = np.ndarray
ROUNDS, ROUND = 40, 1e-2  # rounds, and what each takes at least [s]
END, RTOL = 10.0, 1e-9
TIGHT = 1e-13
US = 1e6
TEXT = """# Calls from Python

What surrounds the C: a call of a generated function, a step, a whole run from Python, and beside
them the C alone and what other programs take for the same from Python. Written by
`tests/benchmarks/python_calls.py`: {processor}, {compiler}, Python {python}, {versions}.

Times are those of the thread, which others on the machine do not lengthen by their turns: the
least and the median of {rounds} rounds, in which all rows take turns. *C alone* is the same
function called in a loop in C; of a run all of its steps in one call of the kernels. Errors are
relative to the largest entry: of functions against their expressions in 40 digits, of CasADi
against cardan, of runs at their end against rtol {tight:.0e}: of a double pendulum they grow
with the motion. Functions are called at a random state.

A run of the double pendulum over 10 s at 1e-9 takes 628 trials, of which 84 are rejected. Their
7450 evaluations, 29 ns each, are its floor, some 215 us: every stage waits for the one before it,
and in it accelerations wait for sines, cosines and a solution. Values between the steps wait until
somebody asks. Twice the error would save 8 % of the trials, and those digits. Rows take 10 us, the
account of the energy 20; arguments, start and motion are 400 calls of 3 us at most in Python.
"""


@dataclass(frozen=True)
class Row:
    """What is measured.

    Attributes:
        name: In the page.
        call: From Python.
        aim: Time to reach [us], None where none was set.
        alone: The same in C, None where there is none.
        states: That one call of ``alone`` does.
        error: Of its result; NaN where it says nothing.
    """

    name: str
    call: Callable[[], Any]
    aim: float | None = None
    alone: Callable[[], Any] | None = None
    states: int = 1
    error: float = float("nan")


def timed(calls: Mapping[Any, Callable[[], Any]], rounds: int) -> dict[Any, tuple[float, float]]:
    """Least and median times of the thread [s] of calls that take turns."""
    counts: dict[Any, int] = {}
    for key, call in calls.items():
        call()
        begin = thread_time()
        call()
        counts[key] = max(1, round(ROUND / max(thread_time() - begin, 1e-7)))
    times: dict[Any, list[float]] = {key: [] for key in calls}
    for _ in range(rounds):
        for key, call in calls.items():
            count = range(counts[key])
            begin = thread_time()
            for _ in count:
                call()
            times[key].append((thread_time() - begin) / len(count))
    return {key: (min(t), float(np.median(t))) for key, t in times.items()}


def alone(model: Any, *key: str) -> tuple[Callable[[], Any], int]:
    """A function at one state again and again, in a loop in C, and how often."""
    function = model._function(*key)
    values = samples.values(model, function, np.random.default_rng(0), 1024)
    many = samples.states(function, values, 1024)
    still = one_by_one(function.caller.call, replace(many, strides=[0] * len(many.strides)))
    return lambda: still(0, 1024), 1024


def digits(model: Any, *key: str) -> float:
    """Error of a function against 40 digits; NaN where its expressions are not saved."""
    from cardan.runtime.calls.function_costs import _error

    function = model._function(*key)
    saved = model._objects.saved().get(function.symbol)
    values = samples.values(model, function, np.random.default_rng(0), 3)
    return _error(model, function, saved, values) if saved else float("nan")


def worst(found: Array, exact: Array) -> float:
    """Largest error of the largest entry."""
    return float(np.abs(np.subtract(found, exact)).max() / np.abs(exact).max())


def of_functions(
    title: str, model: Any, rng: np.random.Generator, aim: float | None = None
) -> Iterator[Row]:
    """Calls at one state, and at ten; ``aim`` is that of derivatives [us]."""
    q, u = (x.copy() for x in model.split(model.random_state(rng)))
    udot, wrt = rng.uniform(-1, 1, model.nu), ("q", "u")
    frame, joint = model.frames[-1], model.joints[0]
    lists = q.tolist(), u.tolist()
    many = [np.tile(x, (10, 1)) for x in (q, u)]
    name = "forward_dynamics"
    functions: list[tuple[str, tuple[str, ...], Callable[[], Any], float | None]] = [
        ("forward dynamics", (name,), lambda: model.forward_dynamics(q, u), None),
        ("forward_dynamics of lists", (name,), lambda: model.forward_dynamics(*lists), 3.0),
        ("the same, ten states", (name,), lambda: model.forward_dynamics(*many), 8.0),
        ("inverse dynamics", ("inverse_dynamics",),
         lambda: model.inverse_dynamics(q, u, udot), None),
        ("mass matrix", ("mass_matrix",), lambda: model.mass_matrix(q), None),
        ("energy", ("energy",), lambda: model.energy(q, u), None),
        ("pose", ("pose", frame), lambda: model.pose(frame, q), None),
        ("reaction", ("reaction", joint), lambda: model.reaction(joint, q, u), None),
    ]  # fmt: skip
    for what, key, call, reach in functions:
        loop, count = alone(model, *key)
        error = digits(model, *key)
        states = count // 10 if "ten" in what else count
        yield Row(f"{title}: {what}", call, reach, loop, states, error)
    derivative = model.derivative(name, wrt=wrt)
    key = ("derivative", derivative.request)
    for what, call in (
        ("derivative, the object", lambda: derivative(q, u)),
        ("derivative, from the verb", lambda: model.derivative(name, wrt=wrt)(q, u)),
    ):
        yield Row(f"{title}: {what}", call, aim, *alone(model, *key), digits(model, *key))
    for what, product, more in (
        ("vjp", model.vjp, udot), ("jvp", model.jvp, (udot, u)), ("hessian", model.hessian, udot),
    ):  # fmt: skip
        key = (what, product(name, wrt=wrt).request)
        yield Row(
            f"{title}: {what}, from the verb",
            lambda product=product, more=more: product(name, wrt=wrt)(q, u, more),  # type: ignore[misc]
            None, *alone(model, *key), digits(model, *key),
        )  # fmt: skip


def exported(equations: Any) -> Iterator[Row]:
    """Of the package for NumPy that an export writes."""
    place = equations.export(Path(tempfile.mkdtemp()) / "package", ["forward_dynamics"], "cython")
    build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace"]
    subprocess.run(build, cwd=place, check=True, capture_output=True)
    sys.path.insert(0, str(place))
    module = importlib.import_module(equations.system.name)
    sys.path.remove(str(place))
    q, u = np.array([0.3, 0.2]), np.array([0.1, -0.2])
    yield Row("double pendulum: exported NumPy package", lambda: module.forward_dynamics(q, u), 1.0)


def of_runs(model: Any) -> Iterator[Row]:
    """A step, a batch of steps, and a whole run."""
    q = dict(zip(model.coordinates, (1.0, 0.5), strict=True))
    x = model.initial(q=q)
    batch = np.tile(x, (1000, 1))
    exact = model.simulate(END, q=q, rtol=TIGHT).x[-1]
    step = {"rtol": TIGHT, "atol": 1e-16}
    error = worst(model.step(x, 0.01), model.step(x, 0.01, **step))
    yield Row(
        "double pendulum: step of 10 ms", lambda: model.step(x, 0.01), 8.0,
        lambda: model.step(batch, 0.01), 1000, error,
    )  # fmt: skip
    motion = model.simulate(END, q=q, rtol=RTOL)
    yield Row(
        "double pendulum: simulate, 10 s at 1e-9", lambda: model.simulate(END, q=q, rtol=RTOL),
        270.0, kernels(model, x), 1, worst(motion.x[-1], exact),
    )  # fmt: skip


def kernels(model: Any, x: Array) -> Callable[[], Any]:
    """The steps of a run, without anything around them."""
    how = settings("DOP853", RTOL, None, None, None, END)
    runner = runner_of(model, how, signals(model.manifest.inputs, None, None, (0.0, END)))

    def run() -> None:
        rewind(runner)
        runner.want(None, dense=True, later=can_wait(runner))
        runner.start(0.0, x, [END])
        runner.drive(SOME_STEPS)

    return run


def of_loops() -> Iterator[Row]:
    """A closed mechanism, some of whose accelerations are given."""
    model = cd.compile(cd.load(cd.examples.path("four_bar")))
    q, u = (x.copy() for x in model.split(model.initial(q={"A": 0.6}, u={"A": 1.0})))
    many = [np.tile(x, (100, 1)) for x in (q, u)]
    given = {"A": 1.0}
    yield Row("four-bar: hybrid dynamics", lambda: model.hybrid_dynamics(q, u, given))
    yield Row("four-bar: hybrid dynamics, 100 states", lambda: model.hybrid_dynamics(*many, given))


def peers(pendulum: Any, equations: Any, panda: Any, panda_equations: Any) -> Iterator[Row]:
    """Other programs that are at hand, on the same mechanisms."""
    rng = np.random.default_rng(3)
    try:
        import pinocchio as pin

        theirs = pin.buildModelFromUrdf(str(urdf()))
        data, q, u = theirs.createData(), pin.neutral(theirs), rng.uniform(-1, 1, theirs.nv)
        tau = np.zeros(theirs.nv)
        yield Row("Panda: Pinocchio, aba", lambda: pin.aba(theirs, data, q, u, tau))
        yield Row(
            "Panda: Pinocchio, computeABADerivatives",
            lambda: pin.computeABADerivatives(theirs, data, q, u, tau),
        )
    except ImportError:
        pass
    try:
        from benchmarks.casadi_expressions import rates

        for title, model, one in (
            ("Panda", panda, panda_equations), ("double pendulum", pendulum, equations),
        ):  # fmt: skip
            function = rates(one, model.nq, model.nu, tuple(model.parameters))
            x, p = model.random_state(rng), np.array(list(model.parameters.values()))
            error = worst(np.ravel(function(x, p)), model.rhs(0.0, x))
            yield Row(
                f"{title}: CasADi, Function of rhs",
                lambda function=function, x=x, p=p: function(x, p),  # type: ignore[misc]
                error=error,
            )
    except ImportError:
        pass
    yield scipy_run(pendulum, equations)


def scipy_run(model: Any, equations: Any) -> Row:
    """SciPy's DOP853 on functions that SymPy makes of the same equations."""
    import sympy
    from scipy.integrate import solve_ivp

    theirs = equations.to_sympy()
    letters = [sympy.Symbol(f"x{k}") for k in range(2 * model.nu)]
    names = dict(zip([*theirs.u, *theirs.q], [*letters[model.nq :], *letters[: model.nq]],
                     strict=True))  # fmt: skip
    forms = [m.subs(theirs.parameters).subs(names) for m in (theirs.mass_matrix, theirs.forcing)]
    function = sympy.lambdify([letters], forms, modules="numpy", cse=True)

    def rhs(t: float, x: Array) -> Array:
        M, f = function(x)
        return np.concatenate([x[model.nq :], np.linalg.solve(M, f)[:, 0]])

    q = dict(zip(model.coordinates, (1.0, 0.5), strict=True))
    x0 = model.initial(q=q)
    exact = model.simulate(END, q=q, rtol=TIGHT).x[-1]

    def run() -> Any:
        how = {"method": "DOP853", "rtol": RTOL, "atol": 1e-3 * RTOL, "dense_output": True}
        return solve_ivp(rhs, (0.0, END), x0, **how)

    error = worst(run().y[:, -1], exact)
    return Row("double pendulum: SciPy, DOP853 over SymPy's lambdify", run, error=error)


def urdf() -> Path:
    """The file of the Panda."""
    return robots.folder() / "panda_description" / "urdf" / "panda.urdf"


def profile(row: Row) -> list[str]:
    """What takes the time of a row that misses its aim, by the profiler."""
    profiler = cProfile.Profile()
    profiler.enable()
    for _ in range(300):
        row.call()
    profiler.disable()
    stats: Any = pstats.Stats(profiler)
    entries = sorted(stats.stats.items(), key=lambda item: -item[1][2])
    total = sum(item[1][2] for item in entries)
    return [
        f"{100 * own / total:.0f} % `{name}` of {Path(file).name}"
        for (file, _, name), (_, _, own, _, _) in entries[:8]
    ]


def cells(row: Row, key: int, times: Mapping[Any, tuple[float, float]]) -> tuple[str, ...]:
    """A line of the table."""
    least, median = times[key, "call"]
    c = times[key, "alone"][0] / row.states if row.alone else None
    return (
        row.name,
        "" if row.aim is None else f"{row.aim:g}",
        f"{US * least:.2f}",
        f"{US * median:.2f}",
        "" if c is None else f"{US * c:.3g}",
        "" if c is None else f"{US * (least - c):.2f}",
        "" if np.isnan(row.error) else f"{row.error:.1e}",
    )


def aims(rows: list[Row], times: Mapping[Any, tuple[float, float]]) -> Iterator[tuple[str, ...]]:
    """Figures to reach, for the table of all."""
    for k, row in enumerate(rows):
        if row.aim is not None:
            spent = US * times[k, "call"][0]
            reached = "yes" if spent <= row.aim else "no"
            yield row.name, f"≤ {row.aim:g} us", f"{spent:.3g} us", reached


def packages() -> str:
    """Versions of what takes part."""
    found = []
    for name in ("numpy", "pin", "casadi", "scipy", "sympy"):
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            found.append(f"without {name}")
    return ", ".join(found)


def main() -> int:
    """Measure, print, write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="few rounds, no robot, no page")
    quick = parser.parse_args().quick
    rng = np.random.default_rng(2)
    equations = cd.derive(cd.load(cd.examples.path("double_pendulum")))
    pendulum = cd.compile(equations)
    rows = [*of_functions("double pendulum", pendulum, rng, 1.5), *exported(equations)]
    rows += [*of_runs(pendulum), *of_loops()]
    if not quick:
        panda_equations = cd.derive(cd.load(urdf()))
        panda = cd.compile(panda_equations)
        rows += [*of_functions("Panda", panda, rng)]
        rows += [*peers(pendulum, equations, panda, panda_equations)]
    calls: dict[Any, Callable[[], Any]] = {(k, "call"): row.call for k, row in enumerate(rows)}
    calls |= {(k, "alone"): row.alone for k, row in enumerate(rows) if row.alone}
    times = timed(calls, 5 if quick else ROUNDS)
    headings = (
        "work", "to reach [us]", "least [us]", "median [us]", "C alone [us]", "around it [us]",
        "error",
    )  # fmt: skip
    lines = [cells(row, k, times) for k, row in enumerate(rows)]
    table = "\n".join(markdown(headings, lines, 1))
    missed = [row for k, row in enumerate(rows) if row.aim and US * times[k, "call"][0] > row.aim]
    notes = [
        f"- Missed: {row.name}, where {row.aim:g} us were to reach. Its time is spent in "
        f"{'; '.join(profile(row))}."
        for row in missed
    ] or ["Every figure to reach is reached."]
    print(*notes, table, sep="\n")
    save("python_calls.md", aims(rows, times))
    if not quick:
        head = TEXT.format(
            processor=processor(), compiler=cache.compiler().identity.splitlines()[0],
            python=platform.python_version(), versions=packages(), rounds=ROUNDS, tight=TIGHT,
        )  # fmt: skip
        title, _, rest = head.partition("\n\n")
        text = f"{title}\n\n" + "\n".join(notes) + f"\n\n{rest}\n{table}\n"
        PAGE.write_text(signed(text), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
