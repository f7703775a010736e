"""Derivatives of superelements: routines of the kernels, as those of other kinds are functions."""

from __future__ import annotations

from dataclasses import replace

from ...ir.function import Block
from ...ir.routine import Routine, result
from .record import Kind
from .superelements import DATA, HEADERS, MORE_HEADERS, TANGENT_ROOM

DERIVATIVE_HEADERS = (
    *HEADERS,
    *MORE_HEADERS["generalized_momenta"],
    *MORE_HEADERS["tangent"],
    "superelement_derivatives.h",
    "superelement_momentum_derivatives.h",
)
# what derivatives read besides weights or directions; results: of forces as many as speeds
DERIVATIVE_READS = {
    **dict.fromkeys(("dynamics", "impulse"), ("q", "u", "udot", "p")),
    **dict.fromkeys(("energy", "momentum", "power"), ("q", "u", "p")),
}
RESULTS = {"energy": 2, "momentum": 6, "power": 1}


def superelement_derivative(kind: Kind, form: str, inputs: int) -> Routine:
    """A gradient, a change or a curvature of a kind of superelement, like those of other kinds.

    Args:
        kind: The kind.
        form: Which.
        inputs: How many the scene has.
    """
    quantity, _, mode = form.rpartition("_")
    tangent = kind.functions["balance_tangent"]
    assert isinstance(tangent, Routine)
    n, on_node, drifting = tangent.sizes
    N, graph = n + 6 * on_node, tangent.graph
    weights = RESULTS.get(quantity, N)
    sizes = {"q": N + on_node, "u": N, "udot": N, "r": inputs, "t": 1, "p": len(DATA)}
    direction, slopes = sum(sizes.values()), {f"d_{letter}": k for letter, k in sizes.items() if k}
    count = {"gradient": weights, "change": direction, "curvature": weights + direction}[mode]
    if mode == "change":
        slopes = {"change": weights}
    work = 3 * N * N + 8 * N + inputs + len(DATA) + TANGENT_ROOM * n + 64
    before, behind = tuple[str, ...](), tuple[str, ...]()
    if mode == "curvature":
        # the gradient of complex numbers, with these and its results
        work = 2 * (work + 2 * direction + weights)
        before, behind = ("complex_numbers.h",), ("real_numbers.h", "superelement_curvature.h")
    v = Block("v", tuple(f"{mode}{k + 1}" for k in range(count)), ("",) * count)
    return replace(
        tangent,
        name=kind.c_name(form),
        inputs=(*(one for one in tangent.inputs if one.name in DERIVATIVE_READS[quantity]), v),
        outputs=tuple(result(graph, name, (k,)) for name, k in slopes.items()),
        about=f"derivative of {quantity}",
        call=f"cardan_superelement_{form}",
        headers=(*before, *DERIVATIVE_HEADERS, *behind),
        sizes=(n, on_node, drifting, inputs),
        work=work,
    )
