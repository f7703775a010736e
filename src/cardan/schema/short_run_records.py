"""Records of many short runs, and of what a run has done with its energy."""

from __future__ import annotations

import ctypes

from .records import fields


class ShortRuns(ctypes.Structure):
    """``cardan_short_runs``: runs over one time from state after state."""

    __slots__ = ()
    _fields_ = fields("cardan_short_runs")


class Account(ctypes.Structure):
    """``cardan_account``: what a run has done with its energy."""

    __slots__ = ()
    _fields_ = fields("cardan_account")
