"""The JSON schema of scene files, made of the tables and families that the reader goes by."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from cardan.elements.flexible import BEAMS, INERTIAS
from cardan.elements.forces import FORCES
from cardan.elements.forces.relative_springs import DIRECTIONS
from cardan.elements.joints import JOINTS
from cardan.elements.tables import KINDS as CURVES
from cardan.elements.validation import AXES
from cardan.scene.beam_arguments import RELEASES
from cardan.scene.body import INERTIA_ENTRIES
from cardan.scene.dh import CONVENTIONS
from cardan.scene.dh import KINDS as DH_TYPES
from cardan.scene.files.yaml import keys
from cardan.scene.files.yaml.keys import Key
from cardan.scene.files.yaml.superelements import SOURCES
from cardan.scene.superelement import INERTIAS as FORMS
from cardan.schema.integrators import INTEGRATORS
from cardan.superelements import METHODS
from cardan.version import SCENE

Schema = dict[str, Any]
EXPRESSION: Schema = {"$ref": "#/$defs/expression"}
NUMBER: Schema = {"$ref": "#/$defs/number"}
TEXT: Schema = {"type": "string"}
COUNT: Schema = {"type": "integer"}
NAMES: Schema = {"type": "array", "items": TEXT}
DEFINITIONS: dict[str, Schema] = {
    "number": {
        "description": "A number, or arithmetic of numbers such as pi/2.",
        "type": ["number", "string"],
    },
    "expression": {
        "description": "A number, or an expression such as -l/2 or k*sin(q(elbow)).",
        "type": ["number", "string"],
    },
    "vector": {"type": "array", "items": EXPRESSION, "minItems": 3, "maxItems": 3},
    "matrix": {"type": "array", "items": {"$ref": "#/$defs/vector"}, "minItems": 3, "maxItems": 3},
    "rows": {"anyOf": [EXPRESSION, {"type": "array", "items": {"$ref": "#/$defs/rows"}}]},
    "direction": {"anyOf": [{"enum": list(AXES)}, {"$ref": "#/$defs/vector"}]},
    "rotation": {
        "description": "[XYZ, a, b, c] (xyz: about fixed axes), or a 3x3 matrix.",
        "anyOf": [
            {
                "type": "array",
                "prefixItems": [{"type": "string", "pattern": "^([XYZ]{3}|[xyz]{3})$"}],
                "items": EXPRESSION,
                "minItems": 4,
                "maxItems": 4,
            },
            {"$ref": "#/$defs/matrix"},
        ],
    },
}


def one_or(single: Schema, **listed: Any) -> Schema:
    return {"anyOf": [single, {"type": "array", "items": single, **listed}]}


def by_name(values: Schema) -> Schema:
    return {"type": "object", "additionalProperties": values}


def record(known: Sequence[Key], **fixed: Schema) -> Schema:
    """A mapping with known keys."""
    return {
        "type": "object",
        "properties": {key.name: fixed.get(key.name) or KINDS[key.kind] for key in known},
        "required": [key.name for key in known if key.required],
        "additionalProperties": False,
    }


def reference(name: str) -> Schema:
    return {"$ref": f"#/$defs/{name}"}


def solids() -> list[Schema]:
    return [
        record([Key(name, name, True)], **{name: record(keys.of_function(function))})
        for name, function in keys.INERTIAS.items()
    ]


def shapes() -> Schema:
    single = {
        "anyOf": [
            record([Key(name, name, True)], **{name: record(keys.of_function(function))})
            for name, function in keys.SHAPES.items()
        ]
    }
    return one_or(single)


def members(family: dict[str, Any], known: Any) -> Schema:
    """Items of a section, each of one of the types of a family."""
    return by_name({"oneOf": [record(known(kind), type={"const": kind}) for kind in family]})


def chosen(what: str) -> Schema:
    """{kind: {...}}, a member of a family."""
    return {
        "anyOf": [
            record([Key(kind, kind, True)], **{kind: record(keys.of_element(member))})
            for kind, member in keys.CHOICES[what].items()
        ]
    }


# kinds of values; filled in the order in which records need them
KINDS: dict[str, Schema] = {
    "version": {"const": SCENE.version},
    "text": TEXT,
    "texts": NAMES,
    "members": one_or(TEXT),
    "curves": {
        "type": "object",
        "properties": dict.fromkeys(DIRECTIONS, TEXT),
        "additionalProperties": False,
    },
    "names": {**NAMES, "minItems": 1, "maxItems": 6},
    "mesh": TEXT,
    "flag": {"type": "boolean"},
    "scalar": EXPRESSION,
    "law": EXPRESSION,
    "motion": {
        "anyOf": [EXPRESSION, {"type": "array", "items": {"anyOf": [EXPRESSION, {"type": "null"}]}}]
    },
    "value": reference("rows"),
    "vector": reference("vector"),
    "direction": reference("direction"),
    "rotation": reference("rotation"),
    "real": NUMBER,
    "bound": NUMBER,
    "numbers": one_or(NUMBER),
    "times": one_or(NUMBER),
    "column": {"type": "array", "items": NUMBER},
    "reals": by_name(NUMBER),
    "initial": by_name(one_or(NUMBER)),
    "signals": by_name(
        {"anyOf": [NUMBER, {"type": "array", "items": {"type": "array", "items": NUMBER}}]}
    ),
}
DEFINITIONS["place"] = {
    "description": "The name of a body or frame, or a frame on a body.",
    "anyOf": [TEXT, record(keys.FRAME)],
}
KINDS["place"] = reference("place")
DEFINITIONS |= {
    "limits": {"anyOf": [{"type": "array", "minItems": 2, "maxItems": 4}, record(keys.LIMITS)]},
    "couple": {"anyOf": [{"type": "array", "minItems": 2, "maxItems": 3}, record(keys.COUPLE)]},
    "pose": {"anyOf": [{"type": "array", "minItems": 2, "maxItems": 4}, record(keys.POSE)]},
    "inertia": {
        "anyOf": [
            reference("vector"),
            reference("matrix"),
            record([Key(name, "scalar") for name in INERTIA_ENTRIES]),
            *solids(),
        ]
    },
    "shapes": shapes(),
}
KINDS |= {name: reference(name) for name in ("limits", "couple", "pose", "inertia", "shapes")}
KINDS |= {
    "parameters": by_name({"anyOf": [NUMBER, record(keys.PARAMETER)]}),
    "inputs": by_name({"anyOf": [NUMBER, {"type": "null"}, record(keys.INPUT)]}),
    "tables": by_name(record(keys.TABLE, kind={"enum": list(CURVES)})),
    "bodies": by_name(record(keys.BODY)),
    "links": {
        "type": "array",
        "items": {
            "anyOf": [
                record(keys.LINK, type={"enum": list(DH_TYPES)}),
                {"type": "array", "items": EXPRESSION, "minItems": 4, "maxItems": 4},
            ]
        },
    },
    "frames": by_name(record(keys.FRAME)),
    "include": by_name(record(keys.INCLUDE)),
    "joints": members(JOINTS, keys.of_joint),
    "forces": members(FORCES, keys.of_force),
    "constraints": by_name({"anyOf": [EXPRESSION, record(keys.OUTPUT)]}),
    "outputs": by_name({"anyOf": [EXPRESSION, record(keys.OUTPUT)]}),
    "simulate": record(keys.SIMULATE, method={"enum": ["auto", *INTEGRATORS]}),
}
KINDS |= {
    "end": {"anyOf": [reference("vector"), reference("place")]},
    "section": chosen("section"),
    "line": chosen("line"),
    "material": record(keys.MATERIAL),
    "prestrain": record(keys.PRESTRAIN),
}
NODES: Schema = {"anyOf": [{"type": ["string", "integer"]}, {"type": "array", "items": COUNT}]}
METHOD: Schema = {"enum": list(METHODS)}
KINDS |= {
    "count": COUNT,
    "labels": {"anyOf": [TEXT, by_name(TEXT)]},
    "points": by_name({"type": "array", "items": NUMBER, "minItems": 3, "maxItems": 3}),
    "places": by_name(reference("place")),
    "factors": by_name(EXPRESSION),
    "node_set": NODES,
    "node_sets": by_name(NODES),
    "materials": {"anyOf": [record(keys.MATERIAL), by_name(record(keys.MATERIAL))]},
}
KINDS |= {
    "matrices": record(keys.MATRICES, method=METHOD),
    "solid_mesh": record(keys.SOLID_MESH, method=METHOD),
}
KINDS["superelements"] = by_name(
    {
        **record(keys.SUPERELEMENT, inertia={"enum": list(FORMS)}),
        "oneOf": [{"required": [source]} for source in SOURCES],
    }
)
KINDS["cables"] = by_name(record(keys.CABLE))
KINDS["beams"] = by_name(
    record(
        keys.BEAM,
        element={"enum": list(BEAMS)},
        inertia={"enum": list(INERTIAS)},
        release_start={"type": "array", "items": {"enum": list(RELEASES)}},
        release_end={"type": "array", "items": {"enum": list(RELEASES)}},
    )
)
KINDS["dh"] = by_name(record(keys.DH, convention={"enum": list(CONVENTIONS)}))


def schema() -> Schema:
    """The whole schema."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "cardan scene",
        "description": "A scene file of cardan, see scene_files.md.",
        **record(keys.TOP),
        "$defs": DEFINITIONS,
    }
