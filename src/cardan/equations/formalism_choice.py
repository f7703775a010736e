"""Equations by the formalism asked for, or by the one that takes the fewest operations.

The coordinates of ``coordinates="auto"`` are chosen here too. Flexible parts need nodes. Of rigid
bodies joint coordinates have the fewest unknowns, but long or many loops tie all of them together:
eliminating them takes operations that grow with the cube of their number, and so does the code.
There body motions and joint forces stay unknowns of one sparse system, whose code does not grow.
Source: D. Baraff, Linear-time dynamics using Lagrange multipliers, SIGGRAPH 1996; H. Brandl,
R. Johanni, M. Otter, An algorithm for the simulation of multibody systems with kinematic loops,
World Congress on the Theory of Machines and Mechanisms, 1987.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Protocol

from ..errors import DerivationError, counted, near
from ..schema.functions import OF_ELEMENTS, STANDARD
from ..topology.system import Named, System
from .constraints.treatments import Treatment
from .formalisms import FORMALISMS, OTHER_NAMES
from .reading.counts import Counts
from .record import EquationRecord
from .rewrites import check_names

# operations by which eliminating a joint within its bodies exceeds writing its rows of M, measured
# on arms, legged robots and chains: 25 to 40 in space, less in a plane
ELIMINATION = 40
# what takes M of written equations as it stands
WRITTEN = "composite"
# ratios of the two between which the functions are counted
UNCLEAR = (0.85, 3.5)
# speeds in one loop, and in all of them, above which elements are taken: measured on chains and
# rows of four-bars, whose code is compiled for longer than a run takes
LONG_LOOP, LOOPED = 16, 60


def chosen_by(
    system: System,
    method: str,
    chosen: tuple[Named, ...],
    rewrites: Sequence[str] | None,
    treatment: Treatment,
) -> EquationRecord:
    """Equations of a system by the formalism asked for, or by the one that takes least.

    Raises:
        DerivationError: an unknown formalism or rewrite.
    """
    check_method(method)
    if system.written and method not in ("auto", WRITTEN):
        raise DerivationError(
            f"'{system.name}' is made of written equations, which are taken as they are: leave out "
            "method= and speeds="
        )
    names = None if rewrites is None else check_names(rewrites)
    plain = EquationRecord(system, method, chosen, "", names, treatment=treatment)
    if method != "auto":
        return plain
    best, reason = predicted(system)
    if best is not None:
        return replace(plain, method=best, reason=reason)
    both = {m: replace(plain.fresh, method=m) for m in ("composite", "articulated")}
    try:
        counts = {m: both[m].operations_of("forward_dynamics") for m in both}
    except DerivationError:
        # M is singular: everything but udot can be had
        return replace(plain, method="composite", reason=f"{counted(system.depth(), 'joint')} deep")
    best = min(counts, key=lambda m: counts[m].cycles)
    other = next(m for m in counts if m != best)
    reason = f"{_counts_text(counts[best])}; by {other} {_counts_text(counts[other])}"
    return replace(both[best], reason=reason)


def _counts_text(counts: Counts) -> str:
    return f"{counted(counts.total, 'operation')}, {counts.critical_path:.0f} in a row"


def check_method(method: str) -> None:
    """Complain about an unknown formalism; names of other schools are translated.

    Raises:
        DerivationError: it does not exist.
    """
    if method in FORMALISMS or method == "auto":
        return
    other = OTHER_NAMES.get(method.lower())
    hint = (
        f" '{method}' is called '{other}' here." if other else near(method, ("auto", *FORMALISMS))
    )
    raise DerivationError(f"method '{method}' does not exist.{hint}")


def check_chooses(method: str) -> None:
    """Complain about a formalism that does not take chosen speeds.

    Raises:
        DerivationError: it does not, or does not exist.
    """
    check_method(method)
    if not FORMALISMS[method].chooses:
        choosing = ", ".join(f"'{name}'" for name, other in FORMALISMS.items() if other.chooses)
        raise DerivationError(
            f"speeds= goes with method={choosing}, not '{method}', which eliminates the speeds of "
            "one joint after the other"
        )


def predicted(system: System) -> tuple[str | None, str]:
    """The formalism whose forward dynamics will take fewer operations, with the reason.

    M and its factorization grow with the cube of the depth, articulated bodies with the number of
    joints. Where the prediction is not clear the formalism is None: count.
    """
    if system.closed:
        return "composite", "its constraints need M"
    if system.closures:
        return "composite", "loops tie joints together"
    if system.written:
        return WRITTEN, "its equations are written with M"
    coupled = [j.name for j in system.joints if j.coupling is not None]
    if coupled:
        return "composite", f"joint {coupled[0]} is coupled"
    factor, joints = factorization(system), sum(j.u >= 0 for j in system.joints)
    ratio = factor / (ELIMINATION * max(joints, 1))
    depth = system.depth()
    cost = counted(factor, "operation")
    if ratio < UNCLEAR[0]:
        return "composite", f"{counted(depth, 'joint')} deep: solving with M takes {cost}"
    if ratio > UNCLEAR[1]:
        return "articulated", f"{counted(depth, 'joint')} deep: solving with M would take {cost}"
    return None, ""


def factorization(system: System) -> int:
    """Operations of M = Lᵀ D L and one solution, with the zeros of the branches of the tree.

    Source: Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 8.
    """
    total, above = 0, list[int]()
    for body, joint in zip(system.bodies, system.joints, strict=True):
        inner = above[body.parent] if body.parent >= 0 else 0
        speeds = len(joint.element.speeds) if joint.u >= 0 else 0
        # row by row: divide, subtract the products, and once each way through for the solution
        for n in range(inner, inner + speeds):
            total += n * (n + 1) + 5 * n + 1
        above.append(inner + speeds)
    return total


class HasElements(Protocol):
    """Something made of elements."""

    @property
    def elements(self) -> int:
        """The number of them."""


def chosen_options(with_auto: Mapping[str, object], with_none: Mapping[str, object]) -> list[str]:
    """Names of the options of joint coordinates that somebody chose."""
    names = [name for name, value in with_auto.items() if value != "auto"]
    return names + [name for name, value in with_none.items() if value is not None]


def element_reason(system: System, cables: Iterable[HasElements], chosen: bool) -> tuple[str, bool]:
    """Why a system is derived element by element, and whether rigid trees keep their joints.

    "" where it has joint coordinates. Rigid trees hang on the nodes of beams and cables; in long
    loops every body is a node.

    Args:
        system: The system graph.
        cables: Of the scene: nodes between elements of one couple with their neighbors alone.
        chosen: Whether options of joint coordinates were chosen, which rigid scenes keep.
    """
    if system.segments:
        return counted(len(system.segments), "beam"), True
    if system.superelements:
        return counted(len(system.superelements), "superelement"), True
    several = sum(cable.elements for cable in cables if cable.elements > 1)
    if several:
        return f"cables of {several} elements", True
    # elements have no written equations; nodes in a plane have no reaction across it, which
    # friction may follow from
    if chosen or system.written or any(force.element.by_reaction for force in system.forces):
        return "", False
    loops = [{number for number, _ in cut.path} for cut in system.cuts]
    longest = max((_speeds(system, loop) for loop in loops), default=0)
    if longest > LONG_LOOP:
        return f"a loop with {counted(longest, 'speed')}", False
    every = _speeds(system, set().union(*loops))
    return (f"loops with {counted(every, 'speed')}" if every > LOOPED else ""), False


def _speeds(system: System, numbers: Iterable[int]) -> int:
    """Number of the speeds of some joints."""
    joints = (system.joints[number] for number in numbers)
    return sum(len(joint.element.speeds) for joint in joints if joint.u >= 0)


def coordinates_with(functions: Collection[str], beams: bool) -> str | None:
    """The coordinates that have functions which elements lack, None where any kind will do."""
    if beams or functions is STANDARD:
        return None
    requested = {functions} if isinstance(functions, str) else {*functions}
    return None if requested <= {*OF_ELEMENTS} else "relative"


def requested(equations: EquationRecord, functions: Sequence[str]) -> tuple[str, ...]:
    """The functions asked for; of the usual ones those that the system has.

    Raises:
        DerivationError: one does not exist.
    """
    available = equations.names()
    if functions is STANDARD:
        return tuple(name for name in STANDARD if name in available)
    functions = (functions,) if isinstance(functions, str) else functions
    for name in functions:
        if name not in available:
            equations.function(name)  # raises, with the near name
    return tuple(functions)
