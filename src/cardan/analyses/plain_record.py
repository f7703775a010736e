"""The record of a run without a compiler, as ``record`` has the one of the kernels."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class Progress:
    """How far a run is: the fields of ``cardan_run`` that others read."""

    t: float = 0.0
    t_start: float = 0.0
    h: float = 0.0
    steps: int = 0
    rejections: int = 0
    evaluations: int = 0
    count: int = 0
    nr: int = 0
    nlam: int = 0
    culprit: int = -1
    model_status: int = 0
    open_row: int = -1
    correction: float = 0.0
    projections: int = 0
    passed: int = 0
    looked: int = 0
    limited: int = 0
    jacobians: int = 0
    factorizations: int = 0
    occurred: int = 0
    log_count: int = 0
