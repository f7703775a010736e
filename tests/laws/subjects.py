"""Everything that users hold and call, each with arguments that fit, for calls that do not."""

from __future__ import annotations

import copy
import inspect
import tempfile
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy

import cardan as cd
from laws.subject_scenes import arm_scene, cantilever_scene, four_bar_scene

JOINTS = (
    *("Fixed", "Revolute", "Prismatic", "Cylindrical", "Screw", "Universal", "ConstantVelocity"),
    *("Spherical", "Planar", "Free", "PointOnPlane", "PointOnCurve", "Distance", "Gear", "Wheel"),
    *("RollingDisk", "Translation", "Custom"),
)
Call = tuple[str, Callable[..., Any], dict[str, Any]]


@cache
def arm() -> cd.CompiledModel:
    return cd.compile(arm_scene())


@cache
def four_bar() -> cd.CompiledModel:
    return cd.compile(four_bar_scene())


@cache
def cantilever() -> cd.CompiledModel:
    return cd.compile(cantilever_scene())


def _bound(name: str, owner: Any, given: dict[str, dict[str, Any]]) -> Iterator[Call]:
    """The public methods of an object, with the arguments that they need."""
    for method in sorted(dir(type(owner))):
        if method.startswith("_") or isinstance(
            inspect.getattr_static(type(owner), method), property
        ):
            continue
        function = getattr(owner, method, None)
        module = getattr(function, "__module__", None) or ""
        if callable(function) and module.startswith("cardan"):
            yield f"{name}.{method}", function, given.get(method, given["*"] | {})


def _needed(call: Call, defaults: dict[str, Any]) -> Call:
    """A call with what is needed besides what is given."""
    name, function, given = call
    needs = {}
    for n, p in inspect.signature(function).parameters.items():
        plain = p.kind in (p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY)
        if p.default is p.empty and plain and n not in given and n in defaults:
            needs[n] = defaults[n]
    return name, function, needs | given


def _model(name: str, model: cd.CompiledModel, frame: str, joint: str, free: str) -> Iterator[Call]:
    x, first = model.initial(), next(iter(model.parameters))
    q, u = model.split(x)
    motion = model.simulate(0.01)
    defaults: dict[str, Any] = {
        "q": q, "u": u, "udot": 0 * u, "du": 0 * u, "q0": q, "q1": q, "t": 0.1, "x": x,
        "dt": 1e-3, "frame": frame, "joint": joint, "function": "rhs", "values": None,
        "events": np.zeros(len(model.event_names)), "motion": motion, "data": motion,
        "coordinate": free, "over": (0.1, 0.2), "parameters": "m",
        "y": x, "name": "beam", "driver": free, "path": "/no/such/file",
    }  # fmt: skip
    own: dict[str, dict[str, Any]] = {
        "*": {},
        "inertial_parameters": {},
        "excitation": {"starts": 1, "steps": 1, "harmonics": 1, "period": 1.0},
        "sweep": {"driver": free, "values": np.array([0.1, 0.12])},
        "statics": {"swept": {first: (0.5, 1.0)}} if model.parameters else {},
        "root_locus": {"swept": {first: np.array([0.5, 1.0])}},
        "campbell": {"swept": {first: np.array([0.5, 1.0])}},
        "workspace": {"samples": 5},
        "verify": {"states": 1},
        "assemble": {"starts": 2},
        "ensemble": {"t": 0.01, "runs": 2},
        "report": {"t": 0.01},
        "hybrid_dynamics": {"udot": {free: 0.0}},
        "simulate": {"t": 0.01},
    }
    if name == "four_bar":
        own["reduced_rhs"] = {"partition": model.partition(q), "y": model.partition(q).reduce(x)}
    for call in _bound(name, model, own):
        yield _needed(call, defaults)


def _records(model: cd.CompiledModel, free: str) -> Iterator[Call]:
    """What analyses return, with methods of its own."""
    x, first = model.initial(), next(iter(model.parameters))
    makers: dict[str, Callable[[], Any]] = {
        "Trajectory": lambda: model.simulate(0.02),
        "Ensemble": lambda: model.ensemble(0.01, runs=2),
        "Equilibrium": model.equilibrium,
        "LinearModel": model.linearize,
        "Modes": model.modes,
        "Assembly": model.assemble,
        "Stepper": model.stepper,
        "Redundancy": model.redundancy,
        "Sweep": lambda: model.sweep(free, np.array([0.1, 0.12])),
        "Workspace": lambda: model.workspace("crank", samples=5),
        "Partition": lambda: model.partition(model.split(x)[0]),
        "Statics": lambda: model.statics({first: (0.5, 1.0)}, steps=2),
        "Locus": lambda: model.root_locus({first: np.array([0.5, 1.0])}),
        "Campbell": lambda: model.campbell({first: np.array([0.5, 1.0])}),
        "Sensitivity": lambda: model.sensitivity(first),
        "Trim": model.trim,
        "Base": model.base_parameters,
        "Excitation": lambda: model.excitation(1.0, starts=1, steps=1, harmonics=1),
        "Torques": lambda: model.torques(model.simulate(np.linspace(0, 1, 101))),
        "Verification": lambda: model.verify(1),
        "Report": model.report,
        "Derivative": lambda: model.derivative("rhs"),
        "Singular": lambda: model.singular_positions(free, (0.1, 0.2)),
    }
    place = Path(tempfile.mkdtemp())
    defaults = {
        "t": 0.005, "times": np.array([0.0, 0.01]), "frame": "crank", "joint": free, "i": 0,
        "beam": "beam", "name": "crank", "path": place / "file", "key": free, "dt": 1e-3, "x": x,
        "y": x, "omega": 1.0, "k": 0,
    }  # fmt: skip
    for title, make in makers.items():
        try:
            record = make()
        except cd.CardanError:
            continue
        own: dict[str, dict[str, Any]] = {"*": {}, "animate": {"path": place / "a.html"}}
        for call in _bound(f"{model.name}:{title}", record, own):
            yield _needed(call, defaults)


def _scene() -> Iterator[Call]:
    """Methods of a scene and its places: every call on a scene of its own."""
    s = cantilever_scene()
    body = s.body("a", mass=1, inertia=(1, 1, 1))
    other = s.body("b", mass=1, inertia=(1, 1, 1), pose=(0, 0, 1))
    s.joint("hinge", cd.Revolute("x"), s.ground, body)
    s.joint("slide", cd.Prismatic("x"), body, other)
    own: dict[str, dict[str, Any]] = {
        "*": {},
        "body": {"name": "new", "mass": 1.0, "inertia": (1, 1, 1)},
        "joint": {"name": "new", "kind": cd.Revolute("x"), "parent": "ground", "child": "b"},
        "force": {"name": "new", "element": cd.JointDamper("hinge", 1.0)},
        "beam": {
            "name": "new", "start": s.ground, "end": (2, 0, 0), "elements": 2,
            "section": cd.section.rectangle(0.1, 0.01), "material": cd.material(E=7e10, nu=0.3),
        },
        "cable": {"name": "new", "start": s.ground, "end": "b", "EA": 1e3, "rhoA": 0.1},
        "superelement": {
            "name": "new", "record": cd.superelement.from_beams(s, "beam", modes=1),
            "interfaces": {"start": body},
        },
        "reduce": {"beams": "beam"},
        "constraint": {"name": "new", "expression": s.q("hinge") - 1},
        "output": {"name": "new", "expression": s.q("hinge")},
        "input": {"name": "new"},
        "parameter": {"name": "new", "value": 1.0},
        "include": {"other": arm_scene(), "prefix": "p"},
        "q": {"coordinate": "hinge"}, "u": {"speed": "hinge"},
        "state": {"name": "z"}, "save": {"path": Path(tempfile.mkdtemp()) / "x.yaml"},
        "place": {"who": "me", "place": "a"},
        "new_place": {"what": "frame", "name": "new"},
        "add_frame": {"body": body, "position": (0, 0, 0), "rotation": None, "name": "new"},
    }  # fmt: skip
    # for frames and readers of files
    inner = ("Model.placeholders", "Model.new_place", "Model.add_frame")
    frame = body.at(0, 0, 1)
    places = {"*": {}, "at": {"x": 0.0, "y": 0.0, "z": 0.0}}
    beam = s.beams["beam"]
    for title, owner, fitting in (
        ("Model", s, own),
        ("Body", body, places),
        ("Frame", frame, places),
        ("Beam", beam, {"*": {}, "at": {"s": 0.5}}),
    ):
        for name, function, given in _bound(title, owner, fitting):
            if name not in inner:
                yield name, _anew(owner, name.split(".")[1], function, given), given


def _anew(
    owner: Any, method: str, like: Callable[..., Any], fitting: dict[str, Any]
) -> Callable[..., Any]:
    """A method of a copy of its owner: a name that one call took is free for the next."""

    def called(**given: Any) -> Any:
        memo: dict[int, Any] = {}
        copied = copy.deepcopy(owner, memo)
        # what fits is copied with its owner, what does not is as it is
        rest = {
            k: copy.deepcopy(v, memo) if k in fitting and v is fitting[k] else v
            for k, v in given.items()
        }
        return getattr(copied, method)(**rest)

    called.__signature__ = inspect.signature(like)  # type: ignore[attr-defined]
    called.__doc__ = like.__doc__
    return called


def _elements() -> Iterator[Call]:
    """Joints, forces, sections and materials: made, put into a scene and derived."""
    made: dict[str, dict[str, Any]] = {
        "Screw": {"pitch": 0.1},
        "PointOnCurve": {"points": [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 1, 1]]},
        "Distance": {"length": 1.0},
        "Gear": {"leader": "hinge"},
        "Wheel": {"radius": 1.0},
        "RollingDisk": {"radius": 1.0},
        "Custom": {"symbols": ("s",), "position": (sympy.Symbol("s"), 0, 0)},
    }
    for name in JOINTS:
        yield name, _joined(getattr(cd, name)), made.get(name, {})
    forces: dict[str, dict[str, Any]] = {
        "Force": {"frame": "a", "force": (0, 0, 1)},
        "Torque": {"frame": "a", "torque": (0, 0, 1)},
        "SpringDamper": {"frame_a": "a", "frame_b": "b", "stiffness": 1.0},
        "Maxwell": {"frame_a": "a", "frame_b": "b", "stiffness": 1.0, "damping": 1.0},
        "Bushing": {
            "frame_a": "a",
            "frame_b": "b",
            "stiffness": (1.0,) * 6,
            "tables": {"z": cd.table((-1, 0, 1), (-2, 0, 3))},
            "branches": ((1.0,) * 6, 0.1),
        },
        "JointSpring": {"joint": "hinge", "stiffness": 1.0},
        "JointForce": {"joint": "hinge", "force": 1.0},
        "JointDamper": {"joint": "hinge", "damping": 1.0},
        "Friction": {"joint": "hinge", "coulomb": 1.0},
        "Actuator": {"joint": "hinge", "command": 1.0, "lag": 1.0},
        "Controller": {"joint": "hinge", "states": ("w",), "changes": (1.0,), "force": 1.0},
        "Stop": {"joint": "hinge", "lower": -1.0},
        "Lock": {"joint": "hinge", "when": sympy.Symbol("hinge")},
        "Contact": {"sphere": "a", "other": "ground", "radius": 0.1, "stiffness": 1e4},
        "Event": {"expression": 1.0},
        "Drive": {"joint": "hinge", "inertia": 1.0},
        "Rotor": {"frame": "a", "inertia": 1.0},
        "LineLoad": {"beam": "beam", "force": (0, 0, 1)},
        "CentralGravity": {"center": "ground", "mu": 1.0},
        "GravityGradient": {"center": "ground", "mu": 1.0},
        "J2": {"center": "ground", "mu": 1.0, "j2": 1e-3, "radius": 1.0},
    }
    for name, given in forces.items():
        yield name, _pushed(getattr(cd, name), name == "LineLoad"), given


def _joined(kind: Any) -> Callable[..., Any]:
    """A function with the arguments of a kind of joint that derives a scene with it."""

    def derived(**given: Any) -> Any:
        s = cd.Scene("joined")
        a = s.body("a", mass=1, inertia=(1, 1, 1))
        b = s.body("b", mass=1, inertia=(1, 1, 1))
        s.joint("hinge", cd.Revolute("x"), s.ground, a)
        s.joint("new", kind(**given), a, b)
        return cd.derive(s).function("forward_dynamics")

    derived.__signature__ = inspect.signature(kind)  # type: ignore[attr-defined]
    return derived


def _pushed(kind: Any, beams: bool) -> Callable[..., Any]:
    def derived(**given: Any) -> Any:
        s = cantilever_scene() if beams else cd.Scene("pushed")
        a = s.body("a", mass=1, inertia=(1, 1, 1))
        b = s.body("b", mass=1, inertia=(1, 1, 1), pose=(0, 0, 2))
        # no body lies at the origin, towards which elements may pull
        s.joint("hinge", cd.Revolute("x"), s.ground.at(0, 1, 0), a)
        s.joint("slide", cd.Prismatic("x"), s.ground.at(0, 0, 2), b)
        s.force("new", kind(**given))
        found = cd.derive(s)
        return found if beams else found.function("forward_dynamics")

    derived.__signature__ = inspect.signature(kind)  # type: ignore[attr-defined]
    return derived


def _functions() -> Iterator[Call]:
    """Functions of cardan and of its modules."""
    for module in (cd.inertia, cd.section, cd.shape, cd.orbit, cd.sample, cd.stability):
        if not inspect.ismodule(module):
            continue
        defaults = dict.fromkeys(
            ("mass", "length", "radius", "x", "y", "z", "width", "height", "depth", "thickness",
             "inner", "outer", "mu", "a", "b", "EA", "GA", "GJ", "EI", "lower", "upper", "mean",
             "std", "low", "high", "deviation"), 1.0,
        )  # fmt: skip
        defaults |= {
            "inner_radius": 0.5,
            "wall": 0.1,
            "flange": 0.1,
            "web": 0.1,
            "runs": 2,
            "n": 2,
            "count": 2,
        }
        defaults |= {
            "path": "a.obj",
            "semi_major": 1.0,
            "position": (1, 0, 0),
            "velocity": (0, 1, 0),
        }
        for name, function in vars(module).items():
            ours = getattr(function, "__module__", "") == module.__name__
            if inspect.isfunction(function) and not name.startswith("_") and ours:
                yield _needed((f"{module.__name__}.{name}", function, {}), defaults)
    yield "material", cd.material, {"E": 1.0, "nu": 0.3}
    yield "table", cd.table, {"x": (0, 1, 2), "y": (0, 1, 4)}
    yield "load", cd.load, {"path": "src/cardan/scenes/double_pendulum.yaml"}
    yield "load_motion", cd.load_motion, {"path": "/no/such/file"}
    yield "load_model", cd.load_model, {"directory": "/no/such/folder"}
    yield "from_dh", cd.from_dh, {"rows": [{"a": 1.0, "alpha": 0.0, "d": 0.0}]}
    x = sympy.Function("x")(cd.t)
    yield "from_sympy", cd.from_sympy, {"equations": [x.diff(cd.t, 2) + x]}
    yield "arc", cd.arc, {"through": (0.5, 0.5, 0)}
    yield "spline", cd.spline, {"points": [(0.3, 0.1, 0), (0.6, 0.1, 0)]}
    yield "GeneralizedAlpha", cd.GeneralizedAlpha, {}
    yield "Alpha", cd.stability.Alpha, {"am": 0.0, "af": 0.0, "beta": 0.25, "gamma": 0.5}
    for name in ["Baumgarte", "Penalty", "Augmented", "Perturbed"]:
        kind = getattr(cd.constraints, name)

        def treated(kind: Any = kind, **given: Any) -> Any:
            return cd.derive(four_bar_scene(), constraints=kind(**given)).function(
                "forward_dynamics"
            )

        treated.__signature__ = inspect.signature(kind)  # type: ignore[attr-defined]
        yield name, treated, {}
    yield "derive", cd.derive, {"scene": arm_scene()}
    yield "compile", cd.compile, {"scene": arm_scene()}
    yield "CompiledModel", cd.CompiledModel, {"directory": arm().directory}
    yield "identify", cd.identify, {"model": arm(), "data": arm().simulate(np.linspace(0, 1, 101))}
    yield (
        "excitation",
        cd.excitation,
        {"model": arm(), "period": 1.0, "starts": 1, "steps": 1, "harmonics": 1},
    )


def _equations() -> Iterator[Call]:
    found = cd.derive(arm_scene())
    place = Path(tempfile.mkdtemp())
    own: dict[str, dict[str, Any]] = {
        "*": {}, "explain": {"path": place / "a.html"},
        "export": {"directory": place / "e", "functions": ["rhs"]},
        "derivative": {"function": "rhs"},
    }  # fmt: skip
    defaults = {"name": "mass_matrix", "of": None, "rewrites": (), "motion": {"shoulder": cd.t}}
    internal = {"c_name", "form", "notes", "told", "ways", "named_function", "recursion", "loops"}
    for call in _bound("Equations", found, own):
        if call[0].split(".")[1] not in internal:
            yield _needed(call, defaults)


_GROUPS: dict[str, Callable[[], Iterator[Call]]] = {
    "scene": _scene,
    "elements": _elements,
    "functions": _functions,
    "equations": _equations,
    "arm": lambda: _model("arm", arm(), "lower", "elbow", "elbow"),
    "four_bar": lambda: _model("four_bar", four_bar(), "crank", "A", "A"),
    "cantilever": lambda: _model("cantilever", cantilever(), "beam.end", "beam.end", "beam.end"),
    "arm records": lambda: _records(arm(), "elbow"),
    "four_bar records": lambda: _records(four_bar(), "A"),
    "cantilever records": lambda: _records(cantilever(), "beam.end"),
}
GROUPS = tuple(_GROUPS)


def calls(group: str) -> Iterator[Call]:
    """Name, function and arguments that fit."""
    return _GROUPS[group]()
