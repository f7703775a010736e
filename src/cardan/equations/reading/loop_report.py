"""Report on the loops and constraints of a system: the cuts and their reasons."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ...errors import counted
from ...topology.system import Closure, Cut, System
from ..constraints.constraints import left_out

if TYPE_CHECKING:
    from ..record import EquationRecord

GROUPS = {"planar": "in a plane", "spherical": "about a point"}
MOST = 12


def loop_lines(equations: EquationRecord) -> list[str]:
    """One line for every loop, and one on how the constraints are treated."""
    system = equations.system
    lines = [_solved(system, closure) for closure in system.closures[:MOST]]
    lines += [_cut(system, cut) for cut in system.cuts[:MOST]]
    hidden = max(0, len(system.closures) - MOST) + max(0, len(system.cuts) - MOST)
    if hidden:
        lines.append(f"  ... and {hidden} more loops")
    if system.closures and system.cuts:
        lines.append("  no dyad or leg closes the loops that are cut: constraints do")
    if system.closable:
        lines.append(_closable(system))
    if system.closed:
        names, treatment = equations.multipliers, equations.treatment
        listing = _some(names)
        lines.append(f"  {counted(len(names), 'constraint')} by {treatment.name}: {listing}")
    return lines


def _closable(system: System) -> str:
    """Remark on what a closed form would leave, and its cost."""
    joints = [i for closure in system.closable for i in closure.unknown]
    left = system.nq - sum(len(system.joints[i].element.coordinates) for i in joints)
    open_count = len(system.cuts) - len(system.closable)
    circuits = f", {open_count} loop{'s' * (open_count > 1)} with multipliers" if open_count else ""
    return (
        f"  constraints='closed_form' would leave {left} of {counted(system.nq, 'coordinate')}"
        f"{circuits}; it does not pass dead points"
    )


def _solved(system: System, closure: Closure) -> str:
    names = ", ".join(system.joints[i].name for i in closure.unknown)
    signs = f"branch {_sign(closure.branch)}"
    if closure.third >= 0:
        signs += f", {system.joints[closure.third].name} {_sign(closure.side)}"
    note = f"; {_redundant(closure.cut)}" if left_out(closure.cut) else ""
    ring = _ring(system, closure.cut)
    return f"  loop of {ring}: in closed form, {names} follow ({signs}){note}"


def _sign(number: int) -> str:
    return "+" if number > 0 else "-"


def _cut(system: System, cut: Cut) -> str:
    """A loop that constraints close."""
    rows, all_rows = len(cut.rows), len(cut.element.locked)
    where = GROUPS.get(cut.group, "")
    if rows == all_rows:
        count = f"{rows} conditions"
    else:
        count = f"moves {where or 'in a group'}, so that {rows} of {all_rows} conditions close it; "
        count += _redundant(cut)
    if cut.carrier is None:
        at = f"cut at {cut.name} ({cut.element.kind}), as {cut.reason}"
    else:
        kind = system.joints[cut.carrier].element.kind
        at = f"cut at {cut.name} ({kind}), which keeps its coordinates, as {cut.reason}"
    return f"  loop of {_ring(system, cut)}: {at}; {count}"


def _redundant(cut: Cut) -> str:
    """Conditions that hold by themselves: two sides bear them, and nothing says how much each."""
    names = _some([row["name"] for row in left_out(cut)])
    return f"redundant: {names}, along which reactions are not determined"


def _ring(system: System, cut: Cut) -> str:
    return _some([*(system.joints[i].name for i, _ in cut.path if i != cut.carrier), cut.name])


def _some(names: Sequence[str]) -> str:
    return ", ".join(names[:MOST]) + (f", ... ({len(names)})" if len(names) > MOST else "")
