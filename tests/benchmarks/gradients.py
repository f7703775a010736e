"""Gradients of motions beside CasADi with CVODES, products of derivatives in lanes, sensitivities.

CasADi has the same equations, as expressions of its own and as our exported C: with this what is
compared is the way through the motion, a discrete adjoint against the adjoint equations that CVODES
integrates.
Writes docs/performance/gradients.md, or nothing with ``--quick``.

usage: gradients.py [--quick]
"""

from __future__ import annotations

import argparse
import importlib
import platform
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from time import process_time
from typing import Any

# the zoo stands in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import casadi as ca
import numpy as np

import cardan as cd
from benchmarks.all_figures import save
from benchmarks.casadi_expressions import rates
from benchmarks.gradient_figures import figures
from benchmarks.page import markdown
from benchmarks.provenance import signed
from cardan.peers.processor import name as processor
from mechanisms import robots

PAGE = Path(__file__).parents[2] / "docs" / "performance" / "gradients.md"
Array = np.ndarray
OURS = 1e-9
# of CVODES, from loose to tight
TOLERANCES = (1e-8, 1e-9, 1e-10, 1e-11, 1e-12)
WAYS: dict[str, dict[str, object]] = {
    "BDF, Newton": {},
    "Adams, functional": {
        "linear_multistep_method": "adams",
        "nonlinear_solver_iteration": "functional",
    },
}
ROUNDS = 9
LANES = 4096
TEXT = """# Gradients

The gradient of a cost of a motion by its start and all parameters, beside CasADi {casadi} with
CVODES on the same equations: as *its expressions*, which CasADi differentiates and evaluates, and
as *our C*, which cardan exports to it with exact products of derivatives. Written by
`tests/benchmarks/gradients.py`; {processor}, one core, Python {python}.

The cost is a sum of squares of all coordinates and speeds at the end. Errors are the largest of all
entries of the gradient, of its largest entry, against a run of cardan's DOP853 at rtol 1e-13.
cardan runs DOP853 at rtol {ours:.0e}; of CVODES each way of stepping is shown with the loosest
tolerance whose error is not larger than ours, or the tightest where none is. All run in turn in one
process, {rounds} rounds, twice in each, of which the second is timed: least / median of the time of
the processor, which others on the machine do not lengthen by their turns. The four-bar is
differentiated by the angle and speed of its crank, and by masses, their places and inertias.
A gradient should take 3 times its simulation, of the Panda 4 and of the four-bar 5. CVODES should
take 80 times ours, of the Panda 100; a product in lanes by the state and all parameters 100 ns.

"""
NOTES = """
## Products with derivatives, in lanes

Weights of all results of `rhs` times its derivative by the state and all parameters, of {lanes:,}
states in one call, per state:

{lanes_table}

## Sensitivities forward

`simulate(sensitivity=)`, in times of the simulation itself:

{forward_table}

Times are those of calls from Python: of a double pendulum that moves for a microsecond the
gradient takes {fixed:.2f} ms, for arguments, start and accounts. Its steps and the sweep over them
are the smaller part of the figure above.
"""


@dataclass(frozen=True)
class Case:
    """A motion whose gradient is measured.

    Attributes:
        name: In the page.
        scene: The scene.
        t: End [s].
        start: As runs take it.
        starts, parameters: What the cost is differentiated by.
    """

    name: str
    scene: cd.Scene
    t: float
    start: Mapping[str, Any]
    starts: tuple[str, ...]
    parameters: tuple[str, ...]

    @property
    def wrt(self) -> tuple[str, ...]:
        """Names as the gradient takes them."""
        every = tuple(cd.compile(self.scene).parameters) == self.parameters
        return (*self.starts, *(("p",) if every else self.parameters))


def double_pendulum() -> Case:
    """Two rods."""
    scene = cd.Scene("double pendulum", gravity=(0, 0, -9.81))
    m1, m2, l1, l2 = (scene.parameter(name, 1.0) for name in ("m1", "m2", "l1", "l2"))
    upper = scene.body("A", mass=m1, com=(0, 0, -l1 / 2), inertia=cd.inertia.rod(m1, l1, axis="z"))
    lower = scene.body("B", mass=m2, com=(0, 0, -l2 / 2), inertia=cd.inertia.rod(m2, l2, axis="z"))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute("y"), upper.at(0, 0, -l1), lower)
    start = {"q": {"a": 1.0, "b": 0.5}, "u": {"a": 0.2, "b": -0.1}}
    names = ("m1", "m2", "l1", "l2", "gravity.z")
    return Case("double pendulum", scene, 2.0, start, ("x0",), names)


def panda() -> Case:
    """The arm with its hand, falling from a pose."""
    file = robots.folder() / "panda_description" / "urdf" / "panda.urdf"
    scene = cd.load(file)
    joints = [f"panda_joint{k}" for k in range(1, 8)]
    pose = (0.3, -0.5, 0.2, -1.8, 0.1, 1.4, 0.6)
    q = dict(zip([*joints, "panda_finger_joint1"], (*pose, 0.02), strict=True))
    start = {"q": q, "u": {name: 0.1 * k for k, name in enumerate(joints, 1)}}
    names = tuple(cd.compile(scene).parameters)
    return Case("Panda with its hand", scene, 1.0, start, ("x0",), names)


def four_bar() -> Case:
    """A closed loop, by its crank and by what moves with it: lengths would move the start too."""
    scene = cd.load(cd.examples.path("four_bar"))
    kinds = ("mass", "gravity", "com", "inertia", "m_")
    names = [n for n in cd.compile(scene).parameters if any(kind in n for kind in kinds)]
    start = {"q": {"A": 0.6}, "u": {"A": 1.0}}
    return Case("four-bar, closed loop", scene, 1.0, start, ("q0.A", "u0.A"), tuple(names))


@dataclass(frozen=True)
class Contender:
    """What gives a gradient.

    Attributes:
        name: With its settings.
        simulate, gradient: What is timed.
        error: Of its gradient.
    """

    name: str
    simulate: Callable[[], Any]
    gradient: Callable[[], Any]
    error: float


def flat(slope: Mapping[str, Any]) -> Array:
    """All entries of a gradient."""
    return np.concatenate([np.ravel(x) for x in slope.values()])


def cost_of(model: cd.CompiledModel) -> tuple[Any, Array]:
    """Half a weighted sum of squares at the end, and the weights (nx,)."""
    weights = 1 + 0.1 * np.arange(model.nx)
    names = (*model.coordinates, *model.speeds)
    terms = [f"{0.5 * w!r}*{name}^2" for w, name in zip(weights.tolist(), names, strict=True)]
    return cd.cost(final=" + ".join(terms)), weights


def worst(found: Array, exact: Array) -> float:
    """Largest error of the largest entry."""
    return float(np.abs(found - exact).max() / np.abs(exact).max())


def contenders(case: Case, model: cd.CompiledModel) -> list[Contender]:
    """cardan, and CasADi with its ways of stepping."""
    (cost, weights), wrt = cost_of(model), case.wrt

    def gradient(rtol: float) -> Array:
        how = {"rtol": rtol, "atol": 1e-2 * rtol}
        return flat(model.gradient(case.t, cost, wrt=wrt, **case.start, **how).slope)

    def simulate() -> Any:
        how = {"method": "DOP853", "rtol": OURS, "atol": 1e-2 * OURS}
        return model.simulate(case.t, **case.start, **how)

    exact = gradient(1e-13)
    error = worst(gradient(OURS), exact)
    ours = Contender(f"cardan, DOP853, rtol {OURS:.0e}", simulate, lambda: gradient(OURS), error)
    result = [ours]
    moved = np.eye(model.nx)
    if "x0" not in case.starts:
        # what follows from the crank: changes of the start
        first = model.simulate(1e-6, sensitivity=case.starts, **case.start).sensitivity
        moved = np.stack([first[name][0] for name in case.starts], axis=1)
    x0 = simulate().x[0]
    for (kind, rhs), (name, options) in product(forms(case, model), WAYS.items()):
        for tolerance in TOLERANCES:
            theirs = cvodes(case, model, rhs, weights, x0, moved, {**options, **limits(tolerance)})
            error = worst(theirs[1](), exact)
            if error <= ours.error or tolerance == TOLERANCES[-1]:
                break
        result.append(Contender(f"CVODES, {name}, {tolerance:.0e}, {kind}", *theirs, error))
    return result


def forms(case: Case, model: cd.CompiledModel) -> list[tuple[str, Any]]:
    """Rates as functions of CasADi of x and p: our C, and of trees its own expressions."""
    equations = cd.derive(case.scene)
    with tempfile.TemporaryDirectory() as folder:
        functions = ["rhs", ("vjp", "rhs: q u p")]
        place = equations.export(Path(folder) / "casadi", functions, language="casadi")
        sys.path.insert(0, str(place))
        module = importlib.import_module(next(place.glob("*_casadi.py")).stem)
        sys.path.remove(str(place))
        result = [("our C", module.function("rhs", parameters=True))]
    if "x0" in case.starts:
        names = tuple(model.parameters)
        result.append(("its expressions", rates(equations, model.nq, model.nu, names)))
    return result


def limits(tolerance: float) -> dict[str, object]:
    """Tolerances of CVODES."""
    return {"reltol": tolerance, "abstol": 1e-2 * tolerance, "max_num_steps": 1_000_000}


def cvodes(
    case: Case, model: cd.CompiledModel, rhs: Any, weights: Array, x0: Array, moved: Array,
    options: dict[str, object],
) -> tuple[Callable[[], Any], Callable[[], Array]]:  # fmt: skip
    """A simulation and a gradient by CasADi.

    Args:
        case: What is measured.
        model: Its model.
        rhs: Rates as a function of CasADi, of x and p.
        weights: Of the cost (nx,).
        x0: The start (nx,).
        moved: Changes of the start by what is named (nx, k).
        options: Of CVODES.
    """
    names = list(model.parameters)
    values = np.array(list(model.parameters.values()))
    x, p = ca.MX.sym("x", model.nx), ca.MX.sym("p", len(names))
    problem = {"x": x, "p": p, "ode": rhs(x=x, p=p)["xdot"]}
    end = ca.integrator("end", "cvodes", problem, 0, case.t, options)
    begin, symbols = ca.MX.sym("begin", model.nx), ca.MX.sym("symbols", len(names))
    last = end(x0=begin, p=symbols)["xf"]
    cost = 0.5 * ca.dot(ca.DM(weights) * last, last)
    slopes = [ca.gradient(cost, begin), ca.gradient(cost, symbols)]
    motion = ca.Function("motion", [begin, symbols], [last])
    both = ca.Function("both", [begin, symbols], [cost, *slopes])
    rows = [names.index(name) for name in case.parameters]

    def gradient() -> Array:
        _, by_x, by_p = (np.asarray(value).ravel() for value in both(x0, values))
        return np.concatenate([moved.T @ by_x, by_p[rows]])

    return lambda: motion(x0, values), gradient


def timed(calls: Mapping[Any, Callable[[], Any]], rounds: int) -> dict[Any, tuple[float, float]]:
    """Least and median times of the processor [s] of calls that take turns."""
    times: dict[Any, list[float]] = {key: [] for key in calls}
    for _ in range(rounds):
        for key, call in calls.items():
            # memory is as the one before has left it
            call()
            begin = process_time()
            call()
            times[key].append(process_time() - begin)
    return {key: (min(t), float(np.median(t))) for key, t in times.items()}


def beside(case: Case, model: cd.CompiledModel, rounds: int) -> list[tuple[str, ...]]:
    """Rows of one case."""
    tried = contenders(case, model)
    both = ("simulate", "gradient")
    calls = {(k, one): getattr(c, one) for k, c in enumerate(tried) for one in both}
    times, rows = timed(calls, rounds), []
    for k, contender in enumerate(tried):
        run, slope = times[k, "simulate"], times[k, "gradient"]
        rows.append((
            f"{case.name} ({len(case.parameters)} parameters)" if k == 0 else "",
            contender.name,
            f"{1e3 * run[0]:.2f} / {1e3 * run[1]:.2f}",
            f"{1e3 * slope[0]:.2f} / {1e3 * slope[1]:.2f}",
            f"{slope[0] / run[0]:.1f}",
            f"{slope[0] / times[0, 'gradient'][0]:.0f}" if k else "1",
            f"{contender.error:.1e}",
        ))  # fmt: skip
    return rows


def lanes(case: Case, model: cd.CompiledModel, rounds: int) -> tuple[str, ...]:
    """Time of a product for a state among many, and of rates."""
    rng = np.random.default_rng(1)
    start = model.initial(**case.start)
    x = start + rng.uniform(-0.3, 0.3, (LANES, model.nx))
    weights = rng.uniform(-1, 1, (LANES, model.nx))
    products = [("vjp", "rhs: q u"), ("vjp", "rhs: q u p")]
    model.prepare("rhs", *products, batch=True)
    calls: dict[str, Callable[[], Any]] = {"rhs": lambda: model.rhs(0.0, x)}
    for name, wrt in (("state", ("q", "u")), ("all", ("q", "u", "p"))):
        product = model.vjp("rhs", wrt=wrt)
        calls[name] = lambda product=product: product(0.0, x, weights=weights)
    times = timed(calls, rounds)
    cells = (tuple(1e9 * x / LANES for x in times[key]) for key in calls)
    return case.name, *(f"{least:.0f} / {median:.0f}" for least, median in cells)


def forward(case: Case, model: cd.CompiledModel, rounds: int) -> tuple[str, ...]:
    """Simulations with sensitivities, in times of one without."""
    how = {"method": "DOP853", "rtol": OURS, "atol": 1e-2 * OURS, **case.start}
    calls: dict[int, Callable[[], Any]] = {0: lambda: model.simulate(case.t, **how)}
    for count in (1, 10):
        if count <= len(case.parameters):
            names = case.parameters[:: len(case.parameters) // count][:count]
            calls[count] = lambda names=names: model.simulate(case.t, sensitivity=names, **how)
    times = timed(calls, rounds)
    ratios = (f"{times[n][0] / times[0][0]:.1f}" if n in times else "" for n in (1, 10))
    return case.name, f"{1e3 * times[0][0]:.2f} / {1e3 * times[0][1]:.2f}", *ratios


def fixed() -> float:
    """Time of the gradient of a motion of a microsecond [s]."""
    case = double_pendulum()
    model = cd.compile(case.scene)
    (cost, _), wrt = cost_of(model), case.wrt
    call = {0: lambda: model.gradient(1e-6, cost, wrt=wrt, **case.start)}
    return timed(call, 20 * ROUNDS)[0][0]


HEADINGS = (
    "motion", "", "simulation [ms]", "gradient [ms]", "of its simulation", "of ours", "error",
)  # fmt: skip


def main() -> int:
    """Measure, print, write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one motion, few rounds, no page")
    quick = parser.parse_args().quick
    rounds = 3 if quick else ROUNDS
    cases = [double_pendulum()] if quick else [double_pendulum(), panda(), four_bar()]
    rows, by_lanes, by_columns = [], [], []
    for case in cases:
        model = cd.compile(case.scene)
        rows += beside(case, model, rounds)
        by_columns.append(forward(case, model, rounds))
        if "x0" in case.starts:
            by_lanes.append(lanes(case, model, 4 * rounds))
    main_table = "\n".join(markdown(HEADINGS, rows))
    headings = ("", "`rhs` [ns]", "product, by the state [ns]", "and by all parameters [ns]")
    lanes_table = "\n".join(markdown(headings, by_lanes, 1))
    headings = ("", "simulation [ms]", "1 parameter", "10 parameters")
    forward_table = "\n".join(markdown(headings, by_columns, 1))
    save("gradients.md", figures(rows, by_lanes))
    print(main_table, lanes_table, forward_table, sep="\n\n")
    if not quick:
        head = TEXT.format(
            casadi=ca.__version__, processor=processor(), python=platform.python_version(),
            ours=OURS, rounds=rounds,
        )  # fmt: skip
        notes = NOTES.format(
            lanes=LANES, lanes_table=lanes_table, forward_table=forward_table, fixed=1e3 * fixed()
        )
        PAGE.write_text(signed(head + main_table + "\n" + notes), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
