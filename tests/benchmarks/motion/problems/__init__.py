"""The motions: one file and one line each."""

from __future__ import annotations

from benchmarks.motion.problem import Problem
from benchmarks.motion.problems import (
    andrews,
    double_pendulum,
    four_bar,
    panda,
    spring_pendulum,
    ten_links,
)

MODULES = (double_pendulum, ten_links, panda, andrews, spring_pendulum, four_bar)
PROBLEMS: dict[str, Problem] = {module.PROBLEM.name: module.PROBLEM for module in MODULES}
