"""The records that C and Python share, as the headers of the kernels declare them.

The headers are the one place where fields are said: :func:`fields` reads them from there, and
``kernels/layouts.c``, which :func:`layouts` writes, tells at load where C has them.
"""

from __future__ import annotations

import ctypes
import re
import textwrap
from functools import cache
from typing import Any

from ..errors import BuildError
from . import kernel_files

POINTER, COUNT, REAL = ctypes.c_void_p, ctypes.c_ssize_t, ctypes.c_double
KINDS: dict[str, Any] = {
    "ptrdiff_t": COUNT,
    "real": REAL,
    "double": REAL,
    "int32_t": ctypes.c_int32,
    "cardan_any_function": POINTER,
    "cardan_function": POINTER,
}
# a function of the model: two pointers, of which Python calls the second <name>_w
CALL = "cardan_call"
# header of each record that Python has; those of lanes are in builds of lanes only
RECORDS = {
    "cardan_run": "run.h",
    "cardan_method": "run.h",
    "cardan_signal": "run.h",
    "cardan_tick": "run.h",
    "cardan_short_runs": "short_runs.h",
    "cardan_account": "account.h",
    "cardan_steps": "steps.h",
    "cardan_adjoint": "adjoint.h",
    "cardan_tangent": "tangent.h",
    "cardan_input_function": "input_functions.h",
    "cardan_input_functions": "input_functions.h",
    "cardan_run_pointer": "ensemble.h",
    "cardan_lane": "ensemble.h",
    "cardan_ensemble": "ensemble.h",
    "cardan_form": "mesh.h",
    "cardan_group": "mesh.h",
    "cardan_movers": "mesh.h",
    "cardan_mesh": "mesh.h",
    "cardan_state": "mesh.h",
    **dict.fromkeys(("cardan_data_slopes", "cardan_summands"), "mesh_product.h"),
    **dict.fromkeys(("cardan_frame", "cardan_mesh_product"), "mesh_product.h"),
    "cardan_sparse": "sparse.h",
    "cardan_sparse_factors": "sparse.h",
    "cardan_target": "position.h",
    "cardan_position": "position.h",
    "cardan_solid": "solids.h",
    "cardan_wasm_function": "wasm_calls.h",
}
LANE_RECORDS = {"cardan_simd": "simd_steps.h", "cardan_lane_method": "simd_steps.h"}
# what the functions of an element give, in the order of mesh.h
FORMS = (
    "balance",
    "balance_tangent",
    "gamma",
    "energy",
    "momentum",
    "power",
    "reaction",
    "outputs",
    "stress",
    "mixed",
    "mixed_step",
    "element_forces",
    "zdot",
    "signs",
    "jumps",
    "change",
    "bodies",
    "reactions",
    "reaction_friction",
    "generalized_momenta",
)
# the matrices of a tangent
PARTS = ("K", "C", "M", "R", "G", "H", "L")
# records of exported models, of which Python writes constants alone
EXPORT_RECORDS = {
    **dict.fromkeys(
        (
            *("cardan_export", "cardan_exported_function", "cardan_exported_event"),
            *("cardan_exported_tick", "cardan_exported_method", "cardan_exported_cost"),
        ),
        "export.h",
    ),
    "cardan_simulation": "simulate.h",
}
# fields of SimdSteps that are one number per lane: of its run, of its trial
PER_LANE = (
    *("t", "size", "until", "error_before", "span", "idle", "rejected", "steps", "rejections"),
    *("evaluations", "h", "t_new", "at", "error", "culprit", "taken", "failed", "ended"),
)
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_FUNCTION = re.compile(r"\(\*(\w+)\)\(")
_DECLARED = re.compile(r"(?:(?:const|volatile|struct) )*(\w+) (.+)")
_ARRAY = re.compile(r"(\w+)\[(\w+)\]$")


@cache
def _text(header: str) -> str:
    """A header without its comments."""
    return _COMMENT.sub("", kernel_files.text(header))


@cache
def constants(header: str) -> dict[str, int]:
    """Values of the enumerations of a header, such as ``CARDAN_MORE``."""
    values: dict[str, int] = {}
    for body in re.findall(r"enum \{(.*?)\}", _text(header), re.DOTALL):
        number = 0
        for entry in filter(str.strip, body.split(",")):
            name, _, value = (part.strip() for part in entry.partition("="))
            number = int(value) if value else number
            values[name] = number
            number += 1
    return values


def _members(record: str) -> list[tuple[str, str, str]]:
    """Name in Python, designator in C and type of every field; a pointer has the type ``*``."""
    header = {**RECORDS, **LANE_RECORDS, **EXPORT_RECORDS}[record]
    body = re.search(rf"struct {record} \{{(.*?)\n\}}", _text(header), re.DOTALL)
    assert body is not None, f"{header} declares no {record}"
    members: list[tuple[str, str, str]] = []
    for statement in filter(str.strip, body[1].split(";")):
        line = " ".join(statement.split())
        if function := _FUNCTION.search(line):
            members.append((function[1], function[1], "*"))
            continue
        declared = _DECLARED.match(line)
        assert declared is not None, f"{header}: {line}"
        for part in declared[2].split(","):
            name = part.strip().lstrip("*")
            if declared[1] == CALL:
                members += [(name, f"{name}.function", "*"), (f"{name}_w", f"{name}.w", "*")]
            else:
                members.append((name, name, "*" if "*" in part else declared[1]))
    return members


@cache
def kinds(record: str) -> dict[str, str]:
    """Type in C of every field of a record; a pointer has the type ``*``."""
    return {name: kind for name, _, kind in _members(record)}


def fields(record: str, **nested: type[ctypes.Structure]) -> list[tuple[str, Any]]:
    """The fields of a record for ``ctypes.Structure``.

    Args:
        record: Its name in C.
        nested: Records by the names of the fields that are arrays of them.
    """
    header = {**RECORDS, **LANE_RECORDS}[record]
    listed: list[tuple[str, Any]] = []
    for name, _, kind in _members(record):
        array = _ARRAY.match(name)
        if array:
            listed.append((array[1], nested[array[1]] * constants(header)[array[2]]))
        else:
            listed.append((name, POINTER if kind == "*" else KINDS[kind]))
    return listed


# __slots__: setting a name that is not a field is an error
class Run(ctypes.Structure):
    """``cardan_run``; see ``kernels/run/run.h`` for the meaning of every field."""

    __slots__ = ()
    _fields_ = fields("cardan_run")


class Method(ctypes.Structure):
    """``cardan_method``: the functions of an integrator, and how much it keeps."""

    __slots__ = ()
    _fields_ = fields("cardan_method")


class LaneMethod(ctypes.Structure):
    """``cardan_lane_method``: the functions of one whose trial steps go side by side."""

    __slots__ = ()
    _fields_ = fields("cardan_lane_method")


class Signal(ctypes.Structure):
    """``cardan_signal``: an input given by pieces."""

    __slots__ = ()
    _fields_ = fields("cardan_signal")


class Tick(ctypes.Structure):
    """``cardan_tick``: an event at known times."""

    __slots__ = ()
    _fields_ = fields("cardan_tick")


class InputFunction(ctypes.Structure):
    """``cardan_input_function``: a function in C of the user."""

    __slots__ = ()
    _fields_ = fields("cardan_input_function")


class Steps(ctypes.Structure):
    """``cardan_steps``: steps of a run that are computed again."""

    __slots__ = ()
    _fields_ = fields("cardan_steps")


class Tangent(ctypes.Structure):
    """``cardan_tangent``: a sweep forward over the steps of a run."""

    __slots__ = ()
    _fields_ = fields("cardan_tangent")


class Adjoint(ctypes.Structure):
    """``cardan_adjoint``: a sweep backward over the steps of a run."""

    __slots__ = ()
    _fields_ = fields("cardan_adjoint")


class InputFunctions(ctypes.Structure):
    """``cardan_input_functions``: everything that a run asks for its inputs."""

    __slots__ = ()
    _fields_ = fields("cardan_input_functions")


class SimdSteps(ctypes.Structure):
    """``cardan_simd``: trial steps side by side."""

    __slots__ = ()
    _fields_ = fields("cardan_simd")


class RunPointer(ctypes.Structure):
    """``cardan_run_pointer``: numbers of a run that a pointer of its record shall point to."""

    __slots__ = ()
    _fields_ = fields("cardan_run_pointer")


class Lane(ctypes.Structure):
    """``cardan_lane``: the record at work, and how each run begins."""

    __slots__ = ()
    _fields_ = fields("cardan_lane")


class Driver(ctypes.Structure):
    """``cardan_ensemble``: many runs by one thread."""

    __slots__ = ()
    _fields_ = fields("cardan_ensemble")


class Form(ctypes.Structure):
    """``cardan_form``: a function of a kind with the prepared data of its elements."""

    __slots__ = ()
    _fields_ = fields("cardan_form")


class Group(ctypes.Structure):
    """``cardan_group``: the elements of one kind."""

    __slots__ = ()
    _fields_ = fields("cardan_group", forms=Form)


class Movers(ctypes.Structure):
    """``cardan_movers``: places that move by functions of their own."""

    __slots__ = ()
    _fields_ = fields("cardan_movers")


class MeshRecord(ctypes.Structure):
    """``cardan_mesh``."""

    __slots__ = ()
    _fields_ = fields("cardan_mesh")


class StateRecord(ctypes.Structure):
    """``cardan_state``: what elements are asked at."""

    __slots__ = ()
    _fields_ = fields("cardan_state")


class PlanRecord(ctypes.Structure):
    """``cardan_sparse``."""

    __slots__ = ()
    _fields_ = fields("cardan_sparse")


class FactorsRecord(ctypes.Structure):
    """``cardan_sparse_factors``."""

    __slots__ = ()
    _fields_ = fields("cardan_sparse_factors")


class TargetRecord(ctypes.Structure):
    """``cardan_target``: what a position is to reach."""

    __slots__ = ()
    _fields_ = fields("cardan_target")


class PositionRecord(ctypes.Structure):
    """``cardan_position``: a search for a position."""

    __slots__ = ()
    _fields_ = fields("cardan_position")


class SolidRecord(ctypes.Structure):
    """``cardan_solid``: finite elements of one kind and material."""

    __slots__ = ()
    _fields_ = fields("cardan_solid")


class WasmFunction(ctypes.Structure):
    """``cardan_wasm_function``: a function of WebAssembly as C calls it."""

    __slots__ = ()
    _fields_ = fields("cardan_wasm_function")


def check(library: ctypes.CDLL, record: str, structure: type[ctypes.Structure]) -> None:
    """Compare a record of Python with that of compiled kernels: its size, where its fields begin.

    Raises:
        BuildError: they differ.
    """
    names = [name for name, *_ in structure._fields_]
    numbers = list((ctypes.c_size_t * (len(names) + 1)).in_dll(library, f"{record}_layout"))
    here = [ctypes.sizeof(structure), *(getattr(structure, name).offset for name in names)]
    if numbers != here:
        at = next(k for k, pair in enumerate(zip(numbers, here, strict=True)) if pair[0] != pair[1])
        what = f"its field '{names[at - 1]}' begins at" if at else "it is as long as"
        raise BuildError(
            f"the kernels were built for another record {record}: {what} {numbers[at]} bytes "
            f"there, {here[at]} here: install cardan again, it is from two versions"
        )


def layouts() -> str:
    """Text of ``kernels/layouts.c``."""
    lines = [
        "/* Sizes of the records that Python shares, then where their fields begin [bytes].",
        " *",
        " * Part of cardan, written by cardan.schema.records from the headers.",
        " */",
        "#include <stddef.h>",
        "",
        "#if CARDAN_LANES > 1",
        *_tables(LANE_RECORDS),
        "#else",
        *_tables(RECORDS),
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def _tables(records: dict[str, str]) -> list[str]:
    lines = [f'#include "{header}"' for header in dict.fromkeys(records.values())]
    for record in records:
        members = [_ARRAY.sub(r"\1", designator) for _, designator, _ in _members(record)]
        lines += [
            f"extern const size_t {record}_layout[{len(members) + 1}];",
            f"const size_t {record}_layout[{len(members) + 1}] = {{",
            *textwrap.wrap(
                ", ".join((f"sizeof({record})", *(f"offsetof({record}, {m})" for m in members))),
                initial_indent="    ",
                subsequent_indent="    ",
                width=100,
            ),
            "};",
        ]
    return lines
