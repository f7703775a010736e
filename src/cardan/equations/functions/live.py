"""Functions of a page that computes: the state under forces of a hand, and where everything is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from ...ir.function import Block, Function, Output
from ...ir.rewrite import rebuild
from ...ir.stage import stage
from ...schema.blocks import ABI_ORDER
from ...topology.system import System
from ..kinematics.kinematics import Kinematics
from . import blocks
from . import outputs as of_system
from .context import Context, frame_number, settled
from .dynamics import Dynamics
from .functions import internal_rates

if TYPE_CHECKING:
    from ..record import EquationRecord

# numbers of a frame: rotation (3, 3), position, angular velocity, velocity of the origin
NUMBERS = 18


def rhs(equations: EquationRecord) -> Function:
    """Derivative of the state; inputs of the model are followed by generalized forces (nu,).

    Args:
        equations: Of the model.
    """
    ways = [_rhs(equations, system) for _, system in equations.ways("rhs", None)]
    return min(ways, key=lambda function: sum(stage(function).operations().values()))


def _rhs(equations: EquationRecord, system: System) -> Function:
    c = _context(equations, system)
    rates = c.vector("qdot", c.k.rates, "qdot") + c.vector("udot", c.d.forward(c.d.tau), "udot")
    results = settled(c, rates + (internal_rates(c) if system.nz else ()))
    # tau stands behind the inputs
    graph, before = c.k.graph, len(equations.blocks["r"])
    forces = {
        graph.var("tau", k): graph.var("r", before + k) for k in range(len(equations.blocks["tau"]))
    }
    nodes = [node for output in results for node in output.nodes]
    _, nodes = rebuild(graph, nodes, forces, into=graph)
    at, outputs = 0, []
    for output in results:
        outputs.append(replace(output, nodes=tuple(nodes[at : at + output.size])))
        at += output.size
    inputs, tau = dict(equations.blocks), equations.blocks["tau"]
    inputs["r"] = Block("r", (*inputs["r"].entries, *tau.entries), (*inputs["r"].units, *tau.units))
    return _function(inputs, "rhs", tuple(outputs), c)


def frames(equations: EquationRecord, names: Sequence[str]) -> Function:
    """Where frames are and how they move: ``NUMBERS`` of each.

    Args:
        equations: Of the model.
        names: Of the frames.

    Raises:
        DerivationError: there is no such frame.
    """
    c = _context(equations, equations.system)
    nodes: list[int] = []
    for name in names:
        frame = frame_number(equations.system, name)
        numbers = (c.k.rotation(frame), c.k.position(frame), of_system.velocity(c.k, frame))
        nodes += [node for matrix in numbers for node in matrix.nodes]
    output = Output("frames", (len(names), NUMBERS), tuple(nodes))
    return _function(equations.blocks, "frames", (output,), c)


def _context(equations: EquationRecord, system: System) -> Context:
    k = Kinematics(system, equations.chosen)
    labels = blocks.labels(equations.blocks)
    return Context(Dynamics(k, equations.method, equations.treatment), *labels)


def _function(
    inputs: Mapping[str, Block], name: str, outputs: tuple[Output, ...], c: Context
) -> Function:
    return Function(name, c.k.graph, tuple(inputs[letter] for letter in ABI_ORDER), outputs)
