"""Operations of linear models by both routes: the table of docs/linear_models.md.

``pytest tests/golden/test_linearized_counts.py --accept`` writes it anew.
"""

from __future__ import annotations

from typing import Any

import pytest

import cardan as cd
from cardan.equations.linearized import differentiated
from cardan.equations.linearized.all_coordinates import DYNAMIC
from cardan.equations.linearized.reference import Reference
from cardan.ir.function import count, live
from golden.scenes import ROOT
from laws.cases import slots
from mechanisms import ZOO
from mechanisms.closed import CLOSED

PAGE = ROOT / "docs" / "linear_models.md"
HEAD = "| mechanism | speeds | nonlinear, differentiated | at the motion | from the start |"
TREES = ("double_pendulum", "mass_ratios", "spatial_chain", "branched", "backwards")
CIRCUITS = ("four_bar", "slider_crank", "andrews", "bricard", "delta", "stewart")


def moving(equations: Any, q: list[float]) -> dict[str, Any]:
    """A position with numbers of no special kind, and speeds that are all different."""
    place = dict(zip(equations.coordinates, q, strict=True))
    speeds = {name: 0.3 + 0.1 * k for k, name in enumerate(equations.speeds)}
    if equations.system.closed:
        chosen = equations.linearize(place).speeds
        speeds = {name: 0.3 + 0.1 * k for k, name in enumerate(chosen)}
    return {"q": place, "u": speeds, "udot": "free"}


def row(name: str, equations: Any, q: list[float]) -> str:
    """A line of the table."""
    motion = moving(equations, q)
    found = [
        sum(equations.linearize(**motion, route=route).operations.values())
        for route in ("differentiated", "from_start")
    ]
    rest = {"z": {}, "r": {}, "s": {}, "t": 0.0, "values": {}, "independent": None}
    at = Reference(equations, **motion, **rest)
    general = differentiated.dynamic(at)
    nodes = [x for matrix in DYNAMIC for x in general[matrix].nodes]
    whole = sum(count(at.graph, live(at.graph, nodes)).values())
    numbers = " | ".join(f"{n:,}" for n in (whole, *found))
    return f"| {name.replace('_', ' ')} | {equations.system.nu} | {numbers} |"


def table() -> list[str]:
    lines = [HEAD, "|---|---|---|---|---|"]
    for name in TREES:
        equations = cd.derive(ZOO[name].build(), method="composite")
        q, _ = slots(equations.system, ZOO[name].states[0])
        lines.append(row(name, equations, q.tolist()))
    for name in CIRCUITS:
        equations = cd.derive(CLOSED[name].build())
        joints = {joint.name for joint in equations.system.joints if joint.q >= 0}
        q, _ = slots(equations.system, CLOSED[name].state(0.1, 1.0, joints))
        lines.append(row(name, equations, q.tolist()))
    return lines


@pytest.mark.slow
def test_the_table_of_the_page(pytestconfig: pytest.Config) -> None:
    text = PAGE.read_text(encoding="utf-8")
    start = text.index(HEAD)
    end = text.index("\n\n", start)
    lines = table()
    if pytestconfig.getoption("--accept"):
        PAGE.write_text(text[:start] + "\n".join(lines) + text[end:], encoding="utf-8")
        return
    assert text[start:end].splitlines() == lines, "pytest tests/golden --accept writes it anew"
