"""The records of ``kernels/mesh.h`` for Python: the same fields in the same order."""

from __future__ import annotations

import ctypes
from typing import Any

POINTER, COUNT, REAL = ctypes.c_void_p, ctypes.c_ssize_t, ctypes.c_double

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
)
# the matrices of a tangent
PARTS = ("K", "C", "M", "R", "G")


def _fields(*rows: tuple[Any, str]) -> list[tuple[str, Any]]:
    return [(name, kind) for kind, names in rows for name in names.split()]


class Form(ctypes.Structure):
    """``cardan_form``: a function of a kind with the prepared data of its elements."""

    _fields_ = _fields((POINTER, "one lanes w w_lanes"), (COUNT, "nw size"))


class Group(ctypes.Structure):
    """``cardan_group``: the elements of one kind."""

    _fields_ = [
        *_fields(
            (COUNT, "count places nq nu nz ns mp m inner inner_start"),
            (POINTER, "place rows z s parts spots"),
        ),
        ("forms", Form * len(FORMS)),
    ]


class Movers(ctypes.Structure):
    """``cardan_movers``: places that move by functions of their own."""

    _fields_ = _fields((COUNT, "count nq nu"), (POINTER, "place move rates w_move w_rates"))


class MeshRecord(ctypes.Structure):
    """``cardan_mesh``."""

    _fields_ = _fields(
        (COUNT, "nq nu nz ns nr mp m places nodes"),
        (POINTER, "q u node"),
        (COUNT, "group_count mover_count"),
        (POINTER, "groups movers plan unknown diagonal"),
        (COUNT, "lanes work local"),
    )


class StateRecord(ctypes.Structure):
    """``cardan_state``: what elements are asked at."""

    _fields_ = _fields((REAL, "t"), (POINTER, "q u udot lam z s r du inner"))
