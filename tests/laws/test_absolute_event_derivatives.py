"""Derivatives of events over elements and of friction by reactions, against differences."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

import cardan as cd
from cardan.elements.forces.force import Action, ForceElement, Places, one_coordinate
from cardan.elements.internal_states import (
    IMPACT,
    MODE,
    Change,
    EventSpec,
    Impulse,
    Jumped,
    Mode,
    Solved,
)
from cardan.elements.quantity import JointName
from cardan.ir.arithmetic import Scalar, select
from cardan.ir.matrix import Matrix
from cardan.runtime.verification.differences import BOUND, missing, slope
from cardan.schema.functions import FUNCTIONS
from faults.test_verify import braked
from laws.event_scenes import SCENES as EVENTS
from laws.event_scenes import Start
from laws.test_happening import inclined
from laws.test_reaction_friction import flexible_slider_crank, slider_crank
from mechanisms.machines import beam_on_a_stop
from mechanisms.superelements import FLYERS
from table import each

# products against each other: rounding of a solve
ROUNDING = 1e-9
# of results, below which derivatives are rounding of what cancels
FLOOR = 1e-2
T = 0.2
STATES = 3
Array = np.ndarray


def buffered() -> cd.Scene:
    """A flexible component on a rail that meets a stop."""
    scene = FLYERS["damped chord"].build(gravity=(0.3, 0.2, -9.81))
    body = next(iter(scene.bodies.values()))
    weight = scene.body("weight", mass=0.7, inertia=(0.02, 0.03, 0.04))
    scene.joint("rail", cd.Prismatic("x"), body, weight)
    scene.force("buffer", cd.Stop("rail", lower=-0.1, restitution=0.6))
    return scene


@dataclass(frozen=True)
class Gauge(ForceElement):
    """Strikes two joints, and keeps how they answer, a speed behind an event, and more.

    Of the catalog nothing but decisions follows from responses, which have no derivatives, and
    impulses act along speeds, which no coordinates turn.
    """

    kind: ClassVar[str] = "gauge"
    joint: JointName
    other: JointName

    def act(self, at: Places) -> tuple[Action, ...]:
        return ()

    def modes(self) -> tuple[Mode, ...]:
        return (Mode("kept", 0.5),)

    def events(self) -> tuple[EventSpec, ...]:
        return (EventSpec("taken", MODE, "it is read"), EventSpec("struck", IMPACT, "it strikes"))

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        x, v = self._of_joint(at)
        return (v * v - x * solved.derivative(v), x * x * v - 2)

    def impulses(self, at: Places, jumped: Jumped) -> tuple[Impulse, ...]:
        (x, v), (y, w) = self._of_joint(at), self._of_joint(at, "other")
        velocity = v * (x * x + 2) + w * y
        return (Impulse(velocity, velocity * velocity * x, jumped.fired(1)),)

    def change(self, at: Places, jumped: Jumped) -> Change:
        x, v = self._of_joint(at)
        behind, rate = jumped.after(v), jumped.before.derivative(v)
        response = jumped.response(v + self._of_joint(at, "other")[1] * x)
        kept = at.s[0] * (response * behind * behind + rate * rate * x)
        taken = select(jumped.fired(0), kept, at.s[0])
        return Change(s=Matrix.vector(at.motion.graph, [taken]))

    def _of_joint(self, at: Places, role: str = "joint") -> tuple[Scalar, Scalar]:
        return one_coordinate(at.motion, at.joints[role], "gauge")


def gauged() -> tuple[cd.Scene, Start]:
    """An arm of three rods in space with stops at shoulder and elbow, and with gauges."""
    scene = cd.Scene("gauged", gravity=(0.5, 0, -9.81))
    mass, bounce = scene.parameter("mass", 1.2), scene.parameter("bounce", 0.6)
    torque, end = scene.input("torque", unit="N*m"), scene.ground
    for joint, axis in (("shoulder", "y"), ("elbow", "x"), ("wrist", (0, 1, 1))):
        inertia = (0.03, 0.02, 0.01)
        rod = scene.body(f"{joint} rod", mass=mass, com=(0.02, 0.05, -0.2), inertia=inertia)
        scene.joint(joint, cd.Revolute(axis), end, rod)
        end = rod.at(0.1, 0, -0.4)
    scene.force("motor", cd.JointForce("elbow", torque * (1 + cd.t)))
    scene.force("buffer", cd.Stop("shoulder", upper=0.9, restitution=bounce))
    scene.force("end", cd.Stop("elbow", upper=1.0, restitution=bounce**2))
    for joint, other in (("elbow", "wrist"), ("wrist", "shoulder")):
        scene.force(f"gauge of {joint}", Gauge(joint, other))
    return scene, {"shoulder": 0.5, "elbow": 0.7, "wrist": 0.3}


# scenes with events, with friction by reactions, with beams and superelements, and their starts
SCENES: dict[str, Callable[[], tuple[cd.Scene, Start]]] = {
    **EVENTS,
    "inclined": lambda: (inclined("rough", True), {}),
    "braked": lambda: (braked(), {}),
    "two frictions in a loop": lambda: (slider_crank(), {"drive": 0.4}),
    "smooth frictions in a loop": lambda: (slider_crank(0.1), {"drive": 0.4}),
    "friction beside a beam": lambda: (flexible_slider_crank(0.1), {}),
    "beam on a stop": lambda: (beam_on_a_stop(True), {}),
    "superelement on a stop": lambda: (buffered(), {}),
    "gauged": gauged,
}
# loops in which no row is redundant there: of others differences would leave what rows agree on
PLANAR = (
    *("four_bar", "slider_crank", "two frictions in a loop", "smooth frictions in a loop"),
    "friction beside a beam",
)


@functools.cache
def model_of(name: str) -> cd.CompiledModel:
    plane = "y" if name in PLANAR else None
    return cd.compile(SCENES[name]()[0], coordinates="absolute", plane=plane)


def states(name: str) -> Iterator[dict[str, Any]]:
    """States near the start, on the constraints, with modes drawn."""
    model, rng = model_of(name), np.random.default_rng(7)
    start, r = SCENES[name]()[1], model._layout.start("r") + 0.1 * rng.uniform(-1, 1, model.nr)
    for k in range(STATES):
        # what is named moves, and all that follows from it
        q = {joint: x + 0.05 * rng.uniform(-1, 1) for joint, x in start.items()}
        u = {speed_of(joint): rng.uniform(-1, 1) for joint in start}
        s = np.array([
            float(rng.choice([int(v) for v in row.labels])) if row.labels else rng.uniform(-1, 1)
            for row in model.manifest.s
        ])  # fmt: skip
        # two that stick in one loop hold the same
        s[:1] = np.where((s == 2).all() and len(s) == 2 and model.nlam, 1.0, s[:1])
        # modes as they are at the start once
        s = model._layout.start("s") if k == 0 else s
        q, u, z = model.parts_of(model.initial(q=q, u=u))
        u = u + 0.1 * rng.uniform(-1, 1, model.nu)
        u = model.close_velocity(q, u, t=T, r=r, s=s)[: model.nu] if model.nlam else u
        yield {"t": np.array([T]), "q": q, "u": u, "z": z + 0.1, "s": s, "r": r}


def speed_of(coordinate: str) -> str:
    """The speed that is the rate of a coordinate."""
    joint, _, entry = coordinate.partition(".")
    return f"{joint}.u.{entry}" if entry else joint


def arguments(function: str, blocks: dict[str, Any]) -> dict[str, Any]:
    state = {**blocks, "t": float(np.ravel(blocks["t"])[0])}
    state["x"] = np.concatenate([state[letter] for letter in "quz"])
    return {name: state[name] for name in FUNCTIONS[function].arguments if name in state}


def value(model: Any, function: str, blocks: dict[str, Any]) -> Array:
    at = arguments(function, blocks)
    if "e" in at:
        at["events"] = at.pop("e")
    result = getattr(model, function)(**at)
    return np.ravel(np.asarray(result, dtype=float))


def along(
    model: Any, function: str, state: dict[str, Any], block: str, way: Array
) -> tuple[Array, Array]:
    """Slope of a function along a way of a block, and how far it may be off."""
    if block == "p":
        start = model.parameters.vector

        def moved(places: dict[str, Any]) -> Array:
            sets = [
                dict(zip(model.parameters, start + h * way, strict=True)) for h in places["h"][:, 0]
            ]
            return np.array([value(model.with_parameters(p), function, state) for p in sets])

        return slope(moved, {"h": np.zeros((1, 1))}, {"h": np.ones((1, 1))}, np.ones(1))
    rate = model.qdot(state["q"], way) if block == "q" else way

    def here(places: dict[str, Any]) -> Array:
        return np.array([value(model, function, {**state, block: x}) for x in places[block]])

    return slope(here, {block: state[block][None]}, {block: rate[None]}, np.ones(1))


def ways(model: Any, function: str, state: dict[str, Any]) -> dict[str, Array]:
    """Random ways of all that a function depends on; of modes those that are numbers."""
    rng, found = np.random.default_rng(5), dict[str, Array]()
    reads = {*FUNCTIONS[function].arguments} | ({*"quz"} if function == "rhs" else set())
    for block in "tquzsrp":
        if block not in reads | {"p"}:
            continue
        size = {"q": model.nu, "p": len(model.parameters)}.get(block)
        way = rng.uniform(0.3, 1, len(state[block]) if size is None else size)
        if block == "p":
            way *= np.where(model.parameters.vector == 0, 1e-2, 1e-2 * model.parameters.vector)
        if block == "s":
            way *= [not row.labels for row in model.manifest.s]
        if block == "u" and function == "transition" and model.nlam:
            # what modes hold lies there: an impulse that keeps it has a corner at rest
            closed = [
                model.close_velocity(**{**arguments("close_velocity", state), "u": u})
                for u in (state["u"], state["u"] + way)
            ]
            way = (closed[1] - closed[0])[: model.nu]
        if way.any():
            found[block] = way
    return found


def possible(model: Any, state: dict[str, Any]) -> Array:
    """Which events may happen in the modes of a state, one in each row."""
    if not model.event_names:
        return np.zeros((0, 0))
    may = value(model, "events", state) != 1.0
    may |= [row.kind == "tick" for row in model.manifest.events]
    return np.eye(len(may))[may]


def compare(model: Any, function: str, state: dict[str, Any]) -> set[str]:
    """Judge derivatives at a state; the blocks of which differences tell something."""
    judged, directions = set[str](), ways(model, function, state)
    at, result = arguments(function, state), value(model, function, state)
    wrt = tuple(directions)
    columns = model.derivative(function, wrt=wrt)(**at)
    floor = FLOOR * (1 + np.abs(result).max())
    weights = np.random.default_rng(1).uniform(-1, 1, result.size)
    products = model.vjp(function, wrt=wrt)(**at, weights=weights)
    for block, D, product in zip(wrt, columns, products, strict=True):
        way = directions[block]
        D = np.reshape(D, (result.size, way.size))
        expected, off = along(model, function, state, block, way)
        terms = np.abs(D * way).max(initial=0), floor
        error = missing(expected, off, (D @ way)[None], *terms)
        assert np.isnan(error) or error <= BOUND, (function, block, state["s"], error)
        judged |= set() if np.isnan(error) else {block}
        size = np.abs(weights[:, None] * D).max(initial=floor)
        assert np.abs(weights @ D - product).max() <= ROUNDING * size, (function, block)
        direction = way if block != "t" else float(way[0])
        change = np.ravel(model.jvp(function, wrt=block)(**at, direction=direction))
        size = np.abs(D * way).max(initial=floor)
        assert np.abs(change - D @ way).max() <= ROUNDING * size, (function, block)
    return judged


@each("name", SCENES)
def test_derivatives(name: str) -> None:
    """Of accelerations, values of events, and all that every event changes, by everything."""
    model = model_of(name)
    judged = dict[str, set[str]]()
    for state in states(name):
        for function in ("rhs", "events"):
            if function == "events" and not model.event_names:
                continue
            judged.setdefault(function, set()).update(compare(model, function, state))
        for fired in possible(model, state):
            blocks = compare(model, "transition", {**state, "e": fired})
            judged.setdefault("transition", set()).update(blocks)
    assert judged["rhs"] >= {"q", "u", "p"}
    for function in {*judged} - {"rhs"}:
        # differences of stiff forces may tell nothing
        assert judged[function] >= {"u", "p"}, (function, judged)


@each("name", ["inclined", "braked", "two frictions in a loop", "smooth frictions in a loop"])
def test_second_derivatives_with_friction(name: str) -> None:
    """Columns of Hessians are slopes of gradients where friction follows from reactions."""
    model, rng, wrt, judged = model_of(name), np.random.default_rng(3), ("q", "u", "p"), set[str]()
    product = model.vjp("rhs", wrt=wrt)
    for state in itertools.islice(states(name), 2):
        weights = rng.uniform(-1, 1, model.nx)
        H = model.hessian("rhs", wrt=wrt)(**arguments("rhs", state), weights=weights)
        for block, columns in zip(
            "qu", np.split(H, [model.nu, 2 * model.nu], axis=1), strict=False
        ):
            way = rng.uniform(0.3, 1, model.nu)
            rate = model.qdot(state["q"], way) if block == "q" else way

            def gradients(
                places: dict[str, Any], state: Any = state, weights: Any = weights
            ) -> Array:
                (moved, rows), *_ = places.items()
                at = [arguments("rhs", {**state, moved: row}) for row in rows]
                parts = [product(**one, weights=weights) for one in at]
                return np.array([np.concatenate([np.ravel(x) for x in one]) for one in parts])

            change, off = slope(
                gradients, {block: state[block][None]}, {block: rate[None]}, np.ones(1)
            )
            # gradients along speeds turn with coordinates
            rows = slice(model.nu if block == "q" else 0, None)
            terms = (columns * way)[rows]
            error = missing(change[:, rows], off, terms.sum(axis=1)[None], np.abs(terms).max())
            assert np.isnan(error) or error <= BOUND, (block, state["s"], error)
            judged |= set() if np.isnan(error) else {block}
    assert judged == {"q", "u"}
