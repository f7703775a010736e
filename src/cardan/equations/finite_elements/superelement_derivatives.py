"""Derivatives of superelements: routines of the kernels, as those of other kinds are functions."""

from __future__ import annotations

from dataclasses import replace

from ...errors import DerivationError
from ...ir.function import Block
from ...ir.routine import Routine, result
from .record import Kind
from .superelements import DATA, HEADERS, MORE_HEADERS, TANGENT_ROOM

DERIVATIVE_HEADERS = (
    *HEADERS,
    *MORE_HEADERS["generalized_momenta"],
    *MORE_HEADERS["tangent"],
    "superelement_derivatives.h",
)
# what derivatives read besides weights or directions
DERIVATIVE_READS = {
    **dict.fromkeys(("dynamics", "impulse"), ("q", "u", "udot", "p")),
    "energy": ("q", "u", "p"),
}


def superelement_derivative(kind: Kind, form: str, inputs: int) -> Routine:
    """A gradient, a change or a curvature of a kind of superelement, like those of other kinds.

    Args:
        kind: The kind.
        form: Which; forces, energies and impulses have one.
        inputs: How many the scene has.

    Raises:
        DerivationError: there is none of that form.
    """
    quantity, _, mode = form.rpartition("_")
    if quantity not in DERIVATIVE_READS:
        raise DerivationError(
            f"superelements have derivatives of forces and energies, none of {quantity}. Take "
            "differences of that"
        )
    tangent = kind.functions["balance_tangent"]
    assert isinstance(tangent, Routine)
    n, on_node, drifting = tangent.sizes
    N, graph = n + 6 * on_node, tangent.graph
    weights = 2 if quantity == "energy" else N
    sizes = {"q": N + on_node, "u": N, "udot": N, "r": inputs, "t": 1, "p": len(DATA)}
    direction, slopes = sum(sizes.values()), {f"d_{letter}": k for letter, k in sizes.items() if k}
    count = {"gradient": weights, "change": direction, "curvature": weights + direction}[mode]
    if mode == "change":
        slopes = {"change": weights}
    work = 3 * N * N + 8 * N + inputs + len(DATA) + TANGENT_ROOM * n + 2
    if quantity == "impulse":
        # what it is the difference of
        work += 2 * N + direction
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
        about="derivative of forces or energies",
        call=f"cardan_superelement_{form}",
        headers=(*before, *DERIVATIVE_HEADERS, *behind),
        sizes=(n, on_node, drifting, inputs),
        constants=_without_stiffness(tangent) if quantity == "impulse" else tangent.constants,
        work=work,
    )


def _without_stiffness(tangent: Routine) -> tuple[float, ...]:
    """Constants of a superelement that nothing but inertia makes."""
    n, _, drifting = tangent.sizes
    end = len(tangent.constants) - 9 * n * drifting - 12 * n * n
    return (*tangent.constants[: end - 2 * n * n], *[0.0] * (2 * n * n), *tangent.constants[end:])
