"""What is written of the table of model functions: a stub for type checkers, and a page."""

from __future__ import annotations

import inspect
import textwrap
from collections.abc import Iterator

from cardan.runtime.calls.functions import Functions
from cardan.runtime.verification.routes import JUDGES
from cardan.schema.functions import FUNCTIONS, ModelFunction

# functions that have another route to their numbers
JUDGED = {*JUDGES}
HEAD = '''\
"""Written from the table of functions: pytest tests/golden/test_functions.py --accept"""

from abc import ABCMeta
from typing import Any

from numpy.typing import ArrayLike

from ...arrays import Array
from .evaluation import Evaluation, State, Values
from .methods import Axes, Energy

class Functions(Evaluation, metaclass=ABCMeta):
'''


def stub() -> str:
    """``runtime/calls/functions.pyi``."""
    methods = [name for name in FUNCTIONS if name in vars(Functions)]
    return HEAD + "\n".join(_method(name) for name in methods)


def _method(name: str) -> str:
    method = getattr(Functions, name)
    lines, starred = ["self"], False
    for one in list(inspect.signature(method).parameters.values())[1:]:
        if one.kind is one.KEYWORD_ONLY and not starred:
            lines.append("*")
            starred = True
        default = "" if one.default is one.empty else f" = {literal(one.default)}"
        lines.append(f"{one.name}: {one.annotation}{default}")
    text = f'"""{inspect.getdoc(method)}\n"""'
    return "\n".join(
        [
            f"    def {name}(",
            *(f"        {line}," for line in lines),
            f"    ) -> {method.__annotations__['return']}:",
            textwrap.indent(text, "        "),
            "",
        ]
    )


def literal(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(value)


PAGE = """\
# Functions of a model

`cd.compile(scene)` gives a model with these functions. Each is derived, written and compiled when
it is first called. `help(model.rhs)` says what a function takes. `model.manifest.available` lists
the functions that this model can have, and calling another raises a `CardanError`. Other methods
of a model have their own pages:

| methods | page |
|---|---|
| `simulate`, `report`, `stiffness` | [integrators](integrators.md) |
| `stepper`, `resume` | [events](events.md) |
| `ensemble` | [ensembles](ensembles.md) |
| `continuation`, `stability_chart` | [branches](branches.md) |
| `cycle` | [motions that repeat](cycles.md) |
| `equilibrium`, `statics`, `trim`, `linearize`, `modes`, `campbell`, `root_locus`, `sensitivity` \
| [statics and modes](statics_and_modes.md) |
| `assemble`, `sweep`, `workspace`, `singular_positions`, `redundancy`, `actuation` \
| [closed loops](closed_loops.md) |
| `hybrid_dynamics`, `partition`, `reduced_rhs`, `residual` | [closed loops](closed_loops.md) |
| `beam` | [beams](flexible.md) |
| `with_parameters`: the same model with other values | [scene files](scene_files.md#running-it) |
| `torques`, `identify`, `excitation`, `base_parameters` | [identification](identification.md) |
| `derivative` | [derivatives](derivatives.md) |
| `verify` | [verification](verification.md) |
| `prepare`, `lanes` | [compiling](building.md) |

## Arguments

- `q`, `u`, `udot`, `z`, `s`, `r`: arrays, or values by name such as `{"elbow": 0.3}`. Names that
  are left out keep their initial values; accelerations and forces are then 0.
- `tau=`: generalized forces (nu,), along the speeds, in addition to those of the model.
- `wrenches=`: `{"hand": [Mx, My, Mz, Fx, Fy, Fz]}` acts at the origin of a frame, in ground axes.
- `z=`, `s=`: [internal states and modes](forces.md#states-and-modes) of force elements. The default
  is their start.
- `r=`: inputs; `t=`: time in s, 0 by default.
- `frame`: name of a body, or of a frame declared as `body.at(0, 0, -1, name="hand")`. For a point
  without a frame, declare one before `cd.compile`. `model.frames` lists the names.
- `in_=`: axes of the result, `"ground"` by default, or `"frame"`.
- `joint`: a name of `model.joints`.
- `parameters={"upper.mass": 2.0}`: other values than those of the model.

All arrays may have leading axes `...` for many states, such as x of shape (1000, nx) in
`model.rhs(0, x)`. They may lie state by state or entry by entry; results of many states lie [as the
arguments do](building.md#many-states-at-once). `out=` takes an array of the shape and type of the
result, which is filled and returned; it may be one of the arguments. Otherwise results are new
arrays.

Real numbers of any type are converted to float64, unless the model was compiled with
[`dtype="float32"`](building.md#many-states-at-once). Wrong shapes, masked entries, complex numbers
and text raise an `ArgumentError`, given NaN or infinity a `SolveError`. A result that is not finite
raises a `SolveError` for one state. In a batch its row is not finite, and a `SolveWarning` names
the first. Several threads may call one model at once.

Coordinates and speeds are in the order of the joints from the ground outward, which may differ
from that of their declaration. Inputs are in the order of declaration. `model.coordinates`,
`model.speeds`, `model.internals`, `model.mode_names` and `model.inputs` list the names in order.
`model.split(x)` gives q and u of a state, and `model.initial(q, u)` the state of a start.
[Conventions](conventions.md) describe the components of a joint.

```python
import cardan as cd

scene = cd.Scene("arm", gravity=(0, 0, -9.81))
upper = scene.body("upper", mass=1.0, com=(0, 0, -0.5))
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
upper.at(0, 0, -1, name="hand")
model = cd.compile(scene)
print(model.coordinates, model.frames)
print(model.pose("hand", {"shoulder": 0.3})[:3, 3])
print(model.inverse_dynamics([0.3], [0], [0], wrenches={"hand": [0, 0, 0, 0, 0, 5]}))
```

```
('shoulder',) ('ground', 'upper', 'hand')
[-0.29552021  0.         -0.95533649]
[-0.02807442]
```

## Table of functions

Sizes: nq coordinates, nu speeds, nz internal states, nx = nq + nu + nz, ns modes, nr inputs, ne
events, nlam multipliers (npositions of them at position level), ny outputs, nphi inertial
parameters.

The column *of systems with* says what a system must have for the function. Equations
[taken over from SymPy](sympy.md) have no bodies, inertias, kinetic energy or causes of forces.
Friction that follows from reactions in closed loops is not known from accelerations.
The column *over elements* says whether the function exists in
[absolute coordinates](coordinates.md) too, where it runs over tables of elements.
The column *verified* says whether an independent method checks it.

| function | gives | shape | unit | of systems with | over elements | [verified](verification.md) |
|---|---|---|---|---|---|---|
"""
INTERNAL = """
These have no method. Integrators and other functions call them, `equations.function(name)` gives
their expressions; `model.derivative` has [a page of its own](derivatives.md).

| function | gives | reads | over elements |
|---|---|---|---|
"""


def page() -> str:
    """``docs/functions.md``."""
    rows = FUNCTIONS.values()
    methods = [_row(row) for row in rows if row.name in vars(Functions)]
    others = [_internal(row) for row in rows if row.name not in vars(Functions)]
    return PAGE + "\n".join(methods) + "\n" + INTERNAL + "\n".join(others) + "\n"


def _row(row: ModelFunction) -> str:
    words = [
        one.name + ("=" if one.kind is one.KEYWORD_ONLY else "")
        for one in inspect.signature(getattr(Functions, row.name)).parameters.values()
        if one.name not in ("self", "out", "parameters")
    ]
    shape = ", ".join(["...", *row.shape.split()])
    cells = [f"`{row.name}({', '.join(words)})`", row.about, f"({shape})", row.unit]
    verified = row.name in JUDGED
    return _line([*cells, ", ".join(row.needs), "yes" * row.elements, "yes" * verified])


def _internal(row: ModelFunction) -> str:
    reads = ", ".join(row.arguments) or f"what its {row.of} reads"
    return _line([f"`{row.name}`", row.about, reads, "yes" * row.elements])


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def written() -> Iterator[tuple[str, str]]:
    """Files by their path in the project."""
    yield "src/cardan/runtime/calls/functions.pyi", stub()
    yield "docs/functions.md", page()
