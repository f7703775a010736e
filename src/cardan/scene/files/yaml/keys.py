"""Keys of a scene file: names, and the kind of value each takes.

Joints, forces, shapes and inertias are not listed here: their keys are the fields of their classes
and the arguments of their functions, so that a new one can be read on arrival. The JSON schema is
made of the same tables.
"""

from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Callable
from types import ModuleType
from typing import Any

from ....elements.centerlines import CENTERLINES, Centerline
from ....elements.forces import FORCES
from ....elements.joints import JOINTS
from ....elements.material import material
from ....elements.sections import SECTIONS, Section
from ....records import dataclass
from ... import inertia, shape
from ...beam_arguments import ROLES, STRAINS


@dataclass(frozen=True)
class Key:
    """A key of a mapping.

    Attributes:
        name: Its text.
        kind: Of its value: one of the methods of :class:`.values.Values`.
        required: It must be there.
    """

    name: str
    kind: str
    required: bool = False


TOP = (
    Key("cardan", "version", True),
    Key("name", "text"),
    Key("gravity", "vector"),
    Key("parameters", "parameters"),
    Key("inputs", "inputs"),
    Key("tables", "tables"),
    Key("bodies", "bodies"),
    Key("dh", "dh"),
    Key("frames", "frames"),
    Key("include", "include"),
    Key("superelements", "superelements"),
    Key("beams", "beams"),
    Key("cables", "cables"),
    Key("joints", "joints"),
    Key("constraints", "constraints"),
    Key("forces", "forces"),
    Key("outputs", "outputs"),
    Key("values", "reals"),
    Key("simulate", "simulate"),
    Key("notes", "texts"),
    Key("snaps", "texts"),
)
PARAMETER = (Key("value", "real", True), Key("unit", "text"))
INPUT = (Key("default", "real"), Key("unit", "text"))
TABLE = (Key("x", "column"), Key("y", "column"), Key("file", "text"), Key("kind", "text"))
BODY = (
    Key("mass", "scalar"),
    Key("com", "vector"),
    Key("inertia", "inertia"),
    Key("pose", "pose"),
    Key("shape", "shapes"),
)
FRAME = (Key("body", "text", True), Key("at", "vector"), Key("rotation", "rotation"))
DH = (Key("convention", "text"), Key("parent", "place"), Key("rows", "links", True))
LINK = (
    *(Key(name, "scalar") for name in ("a", "alpha", "d", "theta", "mass")),
    *(Key(name, "text") for name in ("type", "name", "link")),
    Key("com", "vector"),
    Key("inertia", "inertia"),
    *(Key(name, "scalar") for name in ("rotor_inertia", "gear_ratio", "friction", "damping")),
    Key("q0", "numbers"),
    Key("limits", "limits"),
)
INCLUDE = (
    Key("file", "text", True),
    Key("prefix", "text"),
    Key("at", "place"),
    *(Key(name, "text") for name in ("base", "mimic")),
    Key("parameters", "reals"),
)
BEAM = (
    *(Key(role, "end", True) for role in ROLES),
    Key("section", "section", True),
    Key("material", "material"),
    Key("elements", "real"),
    Key("up", "direction"),
    Key("line", "line"),
    *(Key(name, "text") for name in ("element", "inertia", "base")),
    *(Key(f"release_{role}", "texts") for role in ROLES),
    Key("temperature", "scalar"),
    Key("prestrain", "prestrain"),
    Key("nodes", "reals"),
)
CABLE = (
    *(Key(role, "end", True) for role in ROLES),
    Key("EA", "scalar", True),
    *(Key(name, "scalar") for name in ("rhoA", "length")),
    Key("tension", "real"),
    Key("damping", "scalar"),
    Key("elements", "real"),
    Key("base", "text"),
    Key("compression", "flag"),
)
SUPERELEMENT = (
    *(Key(name, "text") for name in ("file", "frame", "inertia")),
    Key("matrices", "matrices"),
    Key("mesh", "solid_mesh"),
    Key("interfaces", "places"),
    Key("weights", "column"),
    Key("stiffening", "flag"),
    Key("loads", "factors"),
)
_REDUCTION = (
    Key("method", "text"),
    Key("modes", "count"),
    Key("rigid", "labels"),
    Key("at", "points"),
    Key("damping", "numbers"),
    Key("rayleigh", "column"),
    Key("static_shapes", "texts"),
)
MATRICES = (
    Key("file", "text", True),
    *(Key(role, "text") for role in ("mass", "nodes", "dofs")),
    Key("interface", "node_sets", True),
    *_REDUCTION,
    *(Key(name, "text") for name in ("frame_dofs", "node_dofs", "order")),
    *(Key(name, "flag") for name in ("supported", "make_free")),
)
SOLID_MESH = (
    Key("file", "text", True),
    Key("scale", "real"),
    Key("material", "materials", True),
    Key("interfaces", "node_sets", True),
    *_REDUCTION,
    Key("stress", "node_set"),
    Key("stiffening", "text"),
)
PRESTRAIN = tuple(Key(name, "scalar") for name in STRAINS)
POSE = (Key("position", "vector", True), Key("rotation", "rotation"), Key("base", "text"))
JOINT = (
    Key("type", "text", True),
    *(Key(name, "place", True) for name in ("parent", "child")),
    Key("prescribed", "motion"),
    Key("cut", "flag"),
    *(Key(name, "numbers") for name in ("q0", "u0")),
    Key("limits", "limits"),
    Key("at", "vector"),
    Key("base", "text"),
    Key("couple", "couple"),
    Key("friction", "real"),
)
LIMITS = tuple(Key(name, "bound") for name in ("lower", "upper", "speed", "effort"))
COUPLE = (Key("leader", "text", True), Key("ratio", "scalar", True), Key("offset", "scalar"))
FORCE = (Key("type", "text", True),)
OUTPUT = (Key("expression", "law", True), Key("unit", "text"))
SIMULATE = (
    Key("time", "times"),
    *(Key(name, "initial") for name in ("q", "u", "z")),
    Key("method", "text"),
    *(Key(name, "real") for name in ("rtol", "atol", "step", "max_step")),
    Key("inputs", "signals"),
)

# annotation of a field or argument -> kind of its value
_KINDS = {
    **dict.fromkeys(("Value", "Value | None", "Rows", "Rows | None"), "value"),
    **dict.fromkeys(("Any", "Vector", "Pair"), "value"),
    **dict.fromkeys(("Direction", "Direction | None"), "direction"),
    **dict.fromkeys(("JointName", "BeamName", "str"), "text"),
    **dict.fromkeys(("Sequence[float]", "Sequence[float] | None"), "numbers"),
    "Sequence[Value]": "vector",
    "Place": "place",
    "Bodies": "members",
    "LocalNames": "names",
    "Curves": "curves",
    "bool": "flag",
}
# arguments of shapes that mean more than their annotation says
_ARGUMENTS = {"rotation": "rotation", "file": "mesh"}


def of_joint(kind: str) -> tuple[Key, ...]:
    """Keys of a joint kind: its fields, then those of every joint."""
    return (*of_element(JOINTS[kind]), *JOINT)


def of_force(kind: str) -> tuple[Key, ...]:
    """Keys of a force element: its fields and ``type``."""
    return (*FORCE, *of_element(FORCES[kind]))


def of_element(element: Any) -> tuple[Key, ...]:
    """The fields of a joint, force element, section or line."""
    return tuple(
        Key(entry.name, _KINDS[str(entry.type)], entry.default is dataclasses.MISSING)
        for entry in dataclasses.fields(element)
    )


def of_function(function: Callable[..., Any]) -> tuple[Key, ...]:
    """The arguments of a shape or an inertia."""
    return tuple(
        Key(
            argument.name,
            _ARGUMENTS.get(argument.name)
            or _KINDS[str(argument.annotation)].replace("value", "scalar"),
            argument.default is inspect.Parameter.empty,
        )
        for argument in inspect.signature(function).parameters.values()
    )


def functions(module: ModuleType) -> dict[str, Callable[..., Any]]:
    """The public functions of ``model.inertia`` or ``model.shape``, by name."""
    return {
        name: member
        for name, member in vars(module).items()
        if inspect.isfunction(member) and member.__module__ == module.__name__ and name[0] != "_"
    }


INERTIAS = functions(inertia)
SHAPES = functions(shape)
MATERIAL = of_function(material)
# what stands as {kind: {...}}, by kind of value; a straight line is said by saying nothing
CHOICES: dict[str, dict[str, type[Section] | type[Centerline]]] = {
    "section": dict(SECTIONS),
    "line": {kind: line for kind, line in CENTERLINES.items() if of_element(line)},
}
