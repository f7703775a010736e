"""Gradients of whole motions over the zoo: backward, forward, and differences of runs.

Steps of RK4 are given, so that what a run computes is a smooth function of its start, parameters
and inputs: differences of runs tell its derivative.

Some motions are differentiated to the error of their steps only, and are judged by twice what half
the steps change: unit quaternions, whose lengths within a step are not 1, events, which divide
steps, and forces with kinks, over which steps go.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
import pytest
from scipy.linalg import null_space, qr

import cardan as cd
from laws import event_scenes
from laws.cases import compiled, states
from laws.circuits import EVERY, scene_of
from laws.circuits import compiled as closed
from laws.circuits import start as closed_start
from laws.test_energy import BENT
from mechanisms import ZOO
from spread import some

SEED = 23
# of differences to eighth order
WEIGHTS = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
CHANGE = 1e-3
# one in eleven is quick: derivatives are derived and compiled for every scene
SPREAD = 11
# forward, a column for each is compiled
FEW = 3
# what a comparison must be at least, of the size of all that adds up
CRUDE = 1e-3
# steps [s] of loops: this one moves fast
STEPS = {"andrews": 1e-5}
# loops that close for their lengths alone
REDUNDANT = ("bricard",)
# scenes with events move at the start: at rest friction has no derivative
SPEEDS = {
    "rubbing": {"x": 0.3},
    "rough_arm": {"J1": 0.4, "J2": -0.5},
    "bouncing": {"J.u.px": 2.0},
    "four_bar": {"A": 0.3},
    "slider_crank": {"A": -0.4},
}
# those whose loops follow from this crank
CRANK = ("four_bar", "slider_crank")
Array = np.ndarray


@dataclass(frozen=True)
class Run:
    """A run with given steps, costs of it, and how it changes.

    Attributes:
        model: The model.
        x0: Start (nx,).
        t: End [s].
        step: Of RK4 [s].
        named: Coordinates and their speeds that are named at the start; None where all are given.
        parameters: Those that change.
    """

    model: Any
    x0: Array
    t: float = 0.4
    step: float = 0.01
    named: tuple[tuple[int, int], ...] | None = None
    parameters: tuple[str, ...] = field(default=())

    def __post_init__(self) -> None:
        object.__setattr__(self, "parameters", self.parameters or tuple(self.model.parameters))

    @cached_property
    def tables(self) -> dict[str, tuple[Array, Array]]:
        """Values of inputs at times."""
        rng, knots = np.random.default_rng(SEED), np.linspace(0, self.t, 5)
        return {name: (knots, rng.uniform(-1, 1, 5)) for name in self.model.inputs}

    @property
    def how(self) -> dict[str, Any]:
        """Inputs, method and step."""
        return {"inputs": self.tables, "method": "RK4", "step": self.step}

    def start(self, x0: Array) -> dict[str, Any]:
        """A start as runs take it."""
        if self.named is None:
            return {"x0": x0}
        model, (q, u) = self.model, self.model.split(x0)
        return {
            "q": {model.coordinates[i]: float(q[i]) for i, _ in self.named},
            "u": {model.speeds[j]: float(u[j]) for _, j in self.named},
        }

    @property
    def few(self) -> tuple[str, ...]:
        """Some parameters."""
        return self.parameters[:: max(1, len(self.parameters) // FEW)]

    @cached_property
    def weights(self) -> Array:
        """Of the last state (nx,)."""
        return np.random.default_rng(SEED + 1).uniform(0.5, 1.5, self.model.nx)

    @property
    def linear(self) -> str:
        """Weights times the last state."""
        names = (*self.model.coordinates, *self.model.speeds, *self.model.internals)
        pairs = zip(self.weights.tolist(), names, strict=True)
        return " + ".join(f"{w!r}*{name}" for w, name in pairs)

    @property
    def running(self) -> str:
        """Of squares of speeds, inputs times sines of coordinates, time times a parameter."""
        model = self.model
        terms = [f"{0.3 + 0.1 * k:.1f}*{name}^2" for k, name in enumerate(model.speeds)]
        terms += [f"{i}*sin({q})" for i, q in zip(model.inputs, model.coordinates, strict=False)]
        terms += [f"t*{name}" for name in list(model.parameters)[:1]]
        return " + ".join(terms)

    def gradient(self, cost: Any, wrt: Any, **changed: Any) -> Any:
        """Gradient of a cost."""
        given = {**self.start(self.x0), **self.how, **changed}
        return self.model.gradient(self.t, cost, wrt=wrt, **given)

    def backward(self, cost: Any) -> dict[str, Array]:
        """Derivatives of a cost, backward: by the start, by parameters, by inputs."""
        wrt = ("x0", *self.parameters, *self.tables)
        return {name: np.asarray(x) for name, x in self.gradient(cost, wrt).slope.items()}

    def forward(self) -> dict[str, Array]:
        """Derivatives of the linear cost, forward: by the start, some parameters, and inputs."""
        wrt = ("x0", *self.few, *self.tables)
        motion = self.model.simulate(self.t, sensitivity=wrt, **self.start(self.x0), **self.how)
        return {name: self.weights @ motion.sensitivity[name][-1] for name in wrt}

    def direction(self, name: str) -> Array:
        """A random direction, of parameters by parts of what they are."""
        model, rng = self.model, np.random.default_rng(SEED + 2)
        if name == "x0":
            return rng.uniform(-1, 1, 2 * model.nu + model.nz)
        if name == "p":
            sizes = np.abs([model.parameters[one] for one in self.parameters])
            return rng.uniform(-1, 1, len(sizes)) * sizes
        return rng.uniform(-1, 1, len(self.tables[name][1]))

    def changed(self, name: str, by: Array) -> dict[str, Any]:
        """Arguments of a run in which something has changed."""
        model = self.model
        if name == "x0":
            q, u, z = np.split(self.x0, [model.nq, model.nq + model.nu])
            dq, du, dz = np.split(by, [model.nu, 2 * model.nu])
            return self.start(np.concatenate([model.integrate(q, dq), u + du, z + dz]))
        if name == "p":
            pairs = zip(self.parameters, by.tolist(), strict=True)
            return {"parameters": {one: model.parameters[one] + d for one, d in pairs if d}}
        times, values = self.tables[name]
        return {"inputs": {**self.tables, name: (times, values + by)}}


def difference(cost: Callable[[float], float]) -> float:
    """Slope at 0, to eighth order."""
    pairs = [(w, cost(k * CHANGE) - cost(-k * CHANGE)) for k, w in enumerate(WEIGHTS, 1)]
    return sum(w * change for w, change in pairs) / CHANGE


def judge(run: Run, allowed: float = 1e-9, exact: bool | None = None) -> None:
    """Backward, forward and by differences.

    Args:
        run: Whose derivatives.
        allowed: Error against differences, of the size of all that adds up.
        exact: Whether derivatives are those of the steps to rounding; by default where no
            coordinates are those of unit quaternions.
    """
    if exact is None:
        exact = not any(name.endswith(".qw") for name in run.model.coordinates)
    finer = None if exact else replace(run, step=run.step / 2)
    linear = cd.cost(final=run.linear)
    cost = cd.cost(final=f"({run.linear})^2", running=run.running or None)
    judge_forward(run, finer, linear)
    slope = run.backward(cost)
    half = slope if finer is None else finer.backward(cost)
    for name in ("x0", *["p"] * bool(run.parameters), *run.tables):
        by, by_half = (joined(run, name, one) for one in (slope, half))
        way = run.direction(name)

        def value(by: float, name: str = name, way: Array = way) -> float:
            return run.gradient(cost, "x0", **run.changed(name, by * way)).value

        expected, found = difference(value), float(by @ way)
        size = max(1.0, float(np.abs(by) @ np.abs(way)))
        bound = allowed * size + 2 * float(np.abs(by_half - by) @ np.abs(way))
        assert bound <= CRUDE * size, f"{name}: give shorter steps"
        print(f"{name}: differences {abs(found - expected) / size:.1e} ({bound / size:.1e})")
        assert abs(found - expected) <= bound, f"{name}: {found} is {expected}"


def judge_forward(run: Run, finer: Run | None, linear: Any) -> None:
    """Backward and forward are the same."""
    backward, forward = run.backward(linear), run.forward()
    half = backward if finer is None else finer.backward(linear)
    for name, ours in forward.items():
        size = max(1.0, float(np.abs(backward[name]).max(initial=0.0)))
        off = float(np.abs(half[name] - backward[name]).max(initial=0.0))
        bound = 1e-12 * size + 2 * off
        assert bound <= CRUDE * size, f"{name}: give shorter steps"
        error = float(np.abs(ours - backward[name]).max(initial=0.0))
        print(f"{name}: forward {error / size:.1e} ({bound / size:.1e})", end=", ")
        assert error <= bound, f"{name}: forward and backward"


def joined(run: Run, name: str, slope: dict[str, Array]) -> Array:
    """Derivatives by all parameters, or by what is called so."""
    return np.array([slope[one] for one in run.parameters]) if name == "p" else slope[name]


@pytest.mark.parametrize("name", some(ZOO, SPREAD))
def test_trees(name: str) -> None:
    (q, u), kinks = states(name), name in BENT
    t, step = (0.1, 1e-3) if kinks else (0.4, 0.01)
    run = Run(compiled(name), np.concatenate([q[0], u[-1]]), t, step)
    judge(run, exact=False if kinks else None)


def closed_run(name: str) -> Run:
    """A run of a mechanism with loops, whose freedoms are named at the start."""
    model, scene = closed(name), scene_of(name)
    q, u = closed_start(model, name, 0.3)
    for joint in model.manifest["joints"]:
        if joint["q"]:
            # the rest is found next to these
            q0 = tuple(q[joint["q"][0] :][: joint["q"][1]].tolist())
            scene.joints[joint["name"]] = replace(scene.joints[joint["name"]], q0=q0)
    model = cd.compile(scene)
    motions = null_space(model.derivative("constraint_rates", wrt="u")(q, u))
    rates = model.derivative("qdot", wrt="u")(q, u)
    pairs = [
        (i, int(row.argmax())) for i, row in enumerate(rates) if np.abs(row).sum() == row.max()
    ]
    # those that tell motions apart best
    order = qr(motions[[j for _, j in pairs]].T, mode="r", pivoting=True)[1]
    named = tuple(pairs[k] for k in order[: motions.shape[1]])
    step = STEPS.get(name, 2.5e-3)
    run = Run(model, np.concatenate([q, u]), 40 * step, step, named)
    if name not in REDUNDANT:
        return run
    return replace(run, parameters=tuple(x for x in model.parameters if x.endswith("mass")))


@pytest.mark.parametrize("name", some(EVERY, SPREAD))
def test_loops(name: str) -> None:
    judge(closed_run(name), 1e-8)


@pytest.mark.parametrize("name", some(event_scenes.SCENES, 5))
def test_events(name: str) -> None:
    scene, q = event_scenes.SCENES[name]()
    if name == "bouncing":
        # sliding that ends would take steps of a microsecond
        floor = scene.forces["floor"]
        smooth = replace(floor.element, transition_velocity=0.5)
        scene.forces["floor"] = replace(floor, element=smooth)
    model = cd.compile(scene)
    x0 = model.initial(q=q, u=SPEEDS.get(name, {}))
    crank = ((model.coordinates.index("A"), model.speeds.index("A.u")),) if name in CRANK else None
    t, step = (0.4, 2.5e-4) if name == "bouncing" else (1.0, 1e-3)
    judge(Run(model, x0, t, step, crank), 1e-7, exact=False)
