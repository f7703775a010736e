"""The records of ``kernels/mesh.h`` for Python."""

from __future__ import annotations

import ctypes

from ...schema.records import fields

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


class Form(ctypes.Structure):
    """``cardan_form``: a function of a kind with the prepared data of its elements."""

    _fields_ = fields("cardan_form")


class Group(ctypes.Structure):
    """``cardan_group``: the elements of one kind."""

    _fields_ = fields("cardan_group", forms=Form)


class Movers(ctypes.Structure):
    """``cardan_movers``: places that move by functions of their own."""

    _fields_ = fields("cardan_movers")


class MeshRecord(ctypes.Structure):
    """``cardan_mesh``."""

    _fields_ = fields("cardan_mesh")


class StateRecord(ctypes.Structure):
    """``cardan_state``: what elements are asked at."""

    _fields_ = fields("cardan_state")
