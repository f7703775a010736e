"""Everybody who computes motions: one file and one line each, ours first."""

from __future__ import annotations

from benchmarks.motion.programs import (
    casadi_cvodes,
    exudyn_solvers,
    mujoco_rk4,
    ours,
    scipy_same_c,
    sundae,
)
from benchmarks.motion.programs.program import Entry, Program

MODULES = (ours, mujoco_rk4, exudyn_solvers, casadi_cvodes, scipy_same_c, sundae)
PROGRAMS: tuple[Program, ...] = tuple(module.PROGRAM for module in MODULES)
# those that need not be here
PEERS = tuple(program for program in PROGRAMS if program.name != ours.NAME)

__all__ = ["PEERS", "PROGRAMS", "Entry", "Program"]
