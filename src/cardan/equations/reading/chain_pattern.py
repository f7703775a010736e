"""A planar chain of equal links, told once with an index.

The formulas are Python like those of elements; ``total(j, 1, n, x)`` is the sum of x over
j = 1 ... n.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems (1988), section 8.3.
"""

from __future__ import annotations

from typing import TypeAlias

from ...elements.formulas import Lines
from ...elements.joints.revolute import Revolute
from ...ir.forms.python_text import formulas
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...spatial.axis import principal
from ...topology.conversion import IDENTITY
from ...topology.system import System

# links from which on the pattern is shorter than the rows
MIN_LINKS = 3
# letters of the pattern beside those of the parameters
LETTERS = ("m", "ell", "sigma", "J")
ABOUT = (
    "mass of a link",
    "from joint to joint",
    "first moment of a link about its joint",
    "moment of inertia about its joint",
)
PATTERN: Lines = (
    ("angles of the links, i = 1 ... n", "phi_i = total(j, 1, i, q_j)"),
    ("inertia that links i and j share", "a_ij = (J if i == j else ell * sigma)"
     " + (n - max(i, j)) * m * ell ** 2"),
    ("gravity on link i and on later ones, g_1 along angle 0",
     "w_i = (sigma + (n - i) * m * ell) * (g_1 * sin(phi_i) - g_2 * cos(phi_i))"),
    ("balance of link i", "b_i = total(j, 1, n, a_ij * (cos(phi_i - phi_j) * phiddot_j"
     " + sin(phi_i - phi_j) * phidot_j ** 2)) + w_i"),
    ("M udot + h of joint k", "r_k = total(i, k, n, b_i)"),
)  # fmt: skip


def chain_pattern(system: System) -> Lines:
    """The formulas of a planar chain of equal links; () of all other systems.

    Links are equal where they have the same expressions, or numbers of the same value.
    """
    k = _axis(system)
    if k is None:
        return ()
    links = [_link(system, i, k) for i in range(len(system.bodies))]
    # the first joint has no link before it
    first, *later = links
    if (
        None in links
        or any(x != later[0] for x in later)
        or _without_length(first) != _without_length(later[0])
    ):
        return ()
    texts, values = later[0] or ((), {})
    data = tuple(
        (about, f"{letter} = {text}")
        for letter, text, about in zip(LETTERS, texts, ABOUT, strict=True)
        if text != letter
    )
    # a letter that is a parameter too would have two meanings
    names = {p.name for p in system.parameters} | set(values)
    if names & {line.partition(" = ")[0] for _, line in data} or "n" in names:
        return ()
    return (*data, *PATTERN)


Link: TypeAlias = "tuple[tuple[str, ...], dict[str, float]]"


def _link(system: System, i: int, k: int) -> Link | None:
    """Mass, length, first moment and inertia of a link, with the numbers that stand in them."""
    body, joint, along = system.bodies[i], system.joints[i], (k + 1) % 3
    nodes = (body.mass, joint.position[along], body.first_moment[along], body.inertia[4 * k])
    values: dict[str, float] = {}

    def leaf(node: int) -> str | None:
        op, name, *indices = system.graph.nodes[node]
        if op != "var" or name != "p":
            return None
        parameter = system.parameters[indices[0]]
        # a number is called after the body or joint that has it
        owner, _, quantity = parameter.name.partition(".")
        if quantity:
            values[quantity.replace(".", "_")] = parameter.value
        return (quantity or owner).replace(".", "_")

    result = formulas(system.graph, nodes, leaf, "c")
    return None if result is None or result[0] else (tuple(result[1]), values)


def _without_length(link: Link | None) -> object:
    """A link without what is told of its length."""
    if link is None:
        return None
    texts, values = link
    remaining = [text for n, text in enumerate(texts) if n != 1]
    return remaining, {
        name: x for name, x in values.items() if any(name in text for text in remaining)
    }


def _axis(system: System) -> int | None:
    """Axis of all joints of a planar chain of equal straight links, None of other systems."""
    bodies, joints = system.bodies, system.joints
    if (
        len(bodies) < MIN_LINKS
        or system.closed
        or [b.parent for b in bodies] != list(range(-1, len(bodies) - 1))
    ):
        return None
    axes = set()
    for joint in joints:
        plain = joint.q >= 0 and joint.coupling is None and joint.motion is None
        if not isinstance(joint.element, Revolute) or not plain or joint.rotation != IDENTITY:
            return None
        axes.add(principal(Matrix(system.graph, 3, 1, joint.data["axis"][2])))
    (axis,) = axes if len(axes) == 1 else (None,)
    if axis is None or axis[1] < 0:
        return None
    if any(joint.offset != ZERO for joint in joints):
        return None
    across = [n for n in range(3) if n != (axis[0] + 1) % 3]
    vectors = [*(joint.position for joint in joints[1:]), *(b.first_moment for b in bodies)]
    return axis[0] if all(x[n] == ZERO for x in vectors for n in across) else None
