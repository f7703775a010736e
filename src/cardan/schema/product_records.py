"""The records of derivatives of meshes that C and Python share; see :mod:`.records`."""

from __future__ import annotations

import ctypes

from .records import fields


class DataSlopes(ctypes.Structure):
    """``cardan_data_slopes``: derivatives of the data of elements by the parameters."""

    __slots__ = ()
    _fields_ = fields("cardan_data_slopes")


class SummandRecord(ctypes.Structure):
    """``cardan_summands``: the sums that results of elements add to."""

    __slots__ = ()
    _fields_ = fields("cardan_summands")


class FrameRecord(ctypes.Structure):
    """``cardan_frame``: a frame on a node, on the ground or on a body of a rigid tree."""

    __slots__ = ()
    _fields_ = fields("cardan_frame")


class ProductRecord(ctypes.Structure):
    """``cardan_mesh_product``: derivatives of a function of a mesh."""

    __slots__ = ()
    _fields_ = fields("cardan_mesh_product")
