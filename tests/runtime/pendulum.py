"""A planar pendulum written by hand as a model directory: what the compiler would write.

A bob on a massless rod, angle q about y from the vertical; x = l sin q... p = (m, l, g).
"""

from __future__ import annotations

import hashlib
import json
import shutil
from pathlib import Path
from typing import Any

from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.serialize import to_dict
from cardan.schema import kernel_files

FUNCTIONS: dict[str, dict[str, Any]] = {
    "forward_dynamics": {
        "body": "out[0] = in->w[0] * in->tau[0] - in->w[1] * sin(in->q[0]);",
        "prepare": "w[0] = 1 / (p[0] * p[1] * p[1]); w[1] = p[2] / p[1];",
        "inputs": ["q", "tau"],
        "outputs": [("udot", [1], ["swing.udot"])],
    },
    "inverse_dynamics": {
        "body": "out[0] = in->w[0] * in->udot[0] + in->w[1] * sin(in->q[0]);",
        "prepare": "w[0] = p[0] * p[1] * p[1]; w[1] = p[0] * p[2] * p[1];",
        "inputs": ["q", "udot"],
        "outputs": [("tau", [1], ["swing.u.tau"])],
    },
    "mass_matrix": {
        "body": "out[0] = in->w[0];",
        "prepare": "w[0] = p[0] * p[1] * p[1];",
        "inputs": [],
        "outputs": [("M", [1, 1], ["swing.u,swing.u"])],
    },
    "rhs": {
        "body": "out[0] = in->u[0]; out[1] = -in->w[0] * sin(in->q[0]);",
        "prepare": "w[0] = p[2] / p[1];",
        "inputs": ["q", "u"],
        "outputs": [("qdot", [1], ["swingdot"]), ("udot", [1], ["swing.udot"])],
    },
    "qdot": {
        "body": "out[0] = in->u[0];",
        "prepare": "",
        "inputs": ["u"],
        "outputs": [("qdot", [1], ["swingdot"])],
    },
    "energy": {
        "body": (
            "work[0] = in->w[0] * in->u[0] * in->u[0]; work[1] = -in->w[1] * cos(in->q[0]);"
            "out[0] = work[0]; out[1] = work[1]; out[2] = work[0] + work[1];"
        ),
        "prepare": "w[0] = p[0] * p[1] * p[1] / 2; w[1] = p[0] * p[2] * p[1];",
        "inputs": ["q", "u"],
        "outputs": [
            ("kinetic", [], ["kinetic"]),
            ("potential", [], ["potential"]),
            ("total", [], ["total"]),
        ],
        "work_size": 2,
    },
    "pose__bob": {
        "body": (
            "real c = cos(in->q[0]), s = sin(in->q[0]);"
            "for (int i = 0; i < 16; i++) out[i] = 0;"
            "out[0] = c; out[2] = s; out[5] = 1; out[8] = -s; out[10] = c; out[15] = 1;"
        ),
        "prepare": "",
        "inputs": ["q"],
        "outputs": [("pose", [4, 4], [])],
        "of": "bob",
    },
    "frame_jacobian__tip": {
        "body": (
            "for (int i = 0; i < 6; i++) out[i] = 0;"
            "out[1] = 1; out[3] = -in->w[0] * cos(in->q[0]); out[5] = in->w[0] * sin(in->q[0]);"
        ),
        "prepare": "w[0] = p[1];",
        "inputs": ["q"],
        "outputs": [("jacobian", [6, 1], [])],
        "of": "tip",
    },
    "outputs": {
        "body": "out[0] = 1 / in->q[0]; return in->q[0] > 3 ? 7 : 0;",
        "prepare": "",
        "inputs": ["q"],
        "outputs": [("outputs", [1], ["hinge"])],
    },
}


def text(name: str, recipe: dict[str, Any]) -> str:
    """C of one function."""
    end = "" if "return" in recipe["body"] else "    return 0;\n"
    return (
        '#include "cardan.h"\n#include <math.h>\n\n'
        f"int {name}(const cardan_in *in, real *out, real *work);\n"
        f"void prepare_{name}(const real *p, wreal *w);\n\n"
        f"int {name}(const cardan_in *in, real *out, real *work)\n{{\n"
        f"    (void)in; (void)work;\n    {recipe['body']}\n{end}}}\n\n"
        f"void prepare_{name}(const real *p, wreal *w)\n{{\n"
        f"    (void)p; (void)w;\n    {recipe['prepare']}\n}}\n"
        f"#ifdef CARDAN_LOADED\nconst int {name}_sizes[] = {{{sizes(name, recipe)}}};\n#endif\n"
    )


SIZES = {"pose__bob": 16, "frame_jacobian__tip": 6, "rhs": 2, "energy": 3}
# q u udot tau of one number, p of three
BLOCKS = ["t", *"quzsrpw", "udot", "zdot", "lam", "tau", "wrench", "du", "q0", "e", "v"]


def sizes(name: str, recipe: dict[str, Any]) -> str:
    """What the object says about itself: out, work, w, and the blocks that are read."""
    read = {**dict.fromkeys(recipe["inputs"], 1), "p": 3 if "p[" in recipe["prepare"] else 0}
    own = (SIZES.get(name, 1), recipe.get("work_size", 0), recipe["prepare"].count("w["))
    return ", ".join(map(str, (*own, *(read.get(block, 0) for block in BLOCKS))))


def entry(name: str, recipe: dict[str, Any]) -> dict[str, Any]:
    """Manifest entry of one function."""
    outputs = [
        {"name": n, "shape": shape, "entries": entries, "units": [""] * len(entries)}
        for n, shape, entries in recipe["outputs"]
    ]
    return {
        "file": f"{name}.c",
        "symbol": name,
        "of": recipe.get("of"),
        "inputs": recipe["inputs"],
        "outputs": outputs,
        "output_size": SIZES.get(name, 1),
        "work_size": recipe.get("work_size", 0),
        "prepared_size": recipe["prepare"].count("w["),
        "lanes": [1],
        "operations": {"mul": 2},
        "sha256": hashlib.sha256(text(name, recipe).encode()).hexdigest(),
    }


def saved() -> dict[str, Any]:
    """``functions.json``: the scene for verification, the forces (none) and forward dynamics."""
    g = Graph()
    m, l, gravity = (g.var("p", k) for k in range(3))
    p = Block("p", ("m", "l", "g"), ("kg", "m", "m/s^2"))
    minus = g.neg(g.mul(m, l))
    point = g.mul(g.mul(m, l), l)
    unit = [g.const(float(i % 4 == 0)) for i in range(9)]
    zeros = (0,) * 9
    values = {
        "gravity": ((3,), (0, 0, g.neg(gravity))),
        "mass": ((1,), (m,)),
        "first_moment": ((1, 3), (0, 0, minus)),
        "inertia": ((1, 3, 3), (point, 0, 0, 0, point, 0, 0, 0, 0)),
        "rotation": ((1, 3, 3), tuple(unit)),
        "position": ((1, 3), (0, 0, 0)),
        "axis": ((1, 3), (0, 1, 0)),
        "pitch": ((1,), (0,)),
        "ratio": ((1,), (0,)),
        "offset": ((1,), (0,)),
    }
    scene = tuple(Output(n, shape, nodes or zeros) for n, (shape, nodes) in values.items())
    f = (Output("f", (1,), (0,)),)
    q = Block("q", ("swing",), ("rad",))
    tau = Block("tau", ("swing.u.tau",), ("N*m",))
    swing = g.mul(g.div(gravity, l), g.apply("sin", g.var("q", 0)))
    udot = g.sub(g.div(g.var("tau", 0), point), swing)
    c, s = (g.apply(name, g.var("q", 0)) for name in ("cos", "sin"))
    turned = (c, 0, s, 0, g.const(1.0), 0, g.neg(s), 0, c)
    pose = Output("rotation", (3, 3), turned), Output("position", (3,), zeros[:3])
    functions = [
        Function("scene", g, (p,), scene),
        Function("scene_pose_0", g, (q, p), pose),
        Function("applied_forces", g, (p,), f),
        Function("forward_dynamics", g, (q, p, tau), (Output("udot", (1,), (udot,)),)),
    ]
    return {function.name: to_dict(function) for function in functions}


def manifest(names: list[str]) -> dict[str, Any]:
    """``manifest.json``."""
    joint = {
        "name": "swing",
        "kind": "revolute",
        "parent": "ground",
        "child": "bob",
        "parent_frame": "ground",
        "child_frame": "bob",
        "q": [0, 1],
        "u": [0, 1],
        "q0": None,
        "u0": None,
        "limits": {"lower": -3.0, "upper": 3.0},
        "quaternion": None,
        "coupled": None,
        "prescribed": False,
    }
    numbers = {"m": (2.0, "kg"), "l": (0.5, "m"), "g": (9.81, "m/s^2")}
    return {
        "abi": 2,
        "schema": 3,
        "cardan": "0.1.0",
        "name": "pendulum",
        "method": "by hand",
        "coordinates": [{"name": "swing", "unit": "rad", "default": 0.0, "joint": "swing"}],
        "speeds": [{"name": "swing.u", "unit": "rad/s", "joint": "swing"}],
        "z": [],
        "s": [],
        "inputs": [],
        "parameters": [
            {"name": n, "unit": unit, "default": value} for n, (value, unit) in numbers.items()
        ],
        "structural": {"swing.axis.y": 1.0},
        "multipliers": [],
        "cuts": [],
        "joints": [joint],
        "fixed": [],
        "bodies": [{"name": "bob", "parent": "ground", "parts": ["bob"]}],
        "frames": [
            {"name": "ground", "body": "ground", "part": None},
            {"name": "bob", "body": "bob", "part": "bob"},
            {"name": "tip", "body": "bob", "part": "bob"},
        ],
        "shapes": [],
        "outputs": [],
        "quaternions": [],
        "notes": [],
        "snaps": [],
        "functions": {n: entry(n, FUNCTIONS[n]) for n in names},
        "available": list(FUNCTIONS),
        "scene": {
            **{"parents": [-1], "kinds": ["revolute"], "rotations": [None]},
            **{"poses": ["scene_pose_0"], "forces": ["none"], "unknown": []},
        },
        "sha256": {},
    }


def write(directory: Path, names: list[str] | None = None) -> Path:
    """A model directory with some of the functions, all by default."""
    chosen = list(FUNCTIONS) if names is None else names
    directory.mkdir(parents=True, exist_ok=True)
    for header in ("cardan.h", "lanes.h", "sincos.h"):
        shutil.copy(kernel_files.file(header), directory / header)
    for name in chosen:
        (directory / f"{name}.c").write_text(text(name, FUNCTIONS[name]))
    (directory / "manifest.json").write_text(json.dumps(manifest(chosen)))
    (directory / "functions.json").write_text(json.dumps(saved()))
    return directory
