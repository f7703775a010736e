"""Superelements of a scene as tables of elements that routines of the kernels compute."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...arrays import Array, Integers
from ...elements.formulas import Lines, Shapes
from ...errors import DerivationError
from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...ir.routine import Routine, result
from ...topology.superelements.part_of_system import PartOfSystem
from ...topology.system import GROUND
from ..functions.blocks import parameters
from .blocks import Holds
from .nodal_scene import JOINT, NODE, Key, Scene
from .record import BlockKind, Group, Kind, unique

HEADERS = ("frame_motion.h", "rows.h", "superelement.h")
TANGENT = ("superelement_terms.h", "superelement_drift.h", "superelement_tangent.h")
# pairs of axes in the order of the header
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1))
NAMES = ("xx", "yy", "zz", "yz", "zx", "xy")
DATA = (*(f"R{i}{j}" for i in "123" for j in "123"), *("px", "py", "pz"), *("gx", "gy", "gz"))
# of the mass, below which its dependence on directions is rounding
ISOTROPIC = 1e-12
# work that the routines need, by coordinates
ROOM, TANGENT_ROOM = 13, 37
FORMULAS: Lines = (
    ("moment of first order of the deformed body, in axes of its frame", "s = s_0 + P @ z"),
    ("velocity of the frame in its axes", "v = R.T @ pdot"),
    ("kinetic energy, H and J by z: H_k = H_0k + z.T A_k, J_kl = J_0kl + 2 j_kl.T z + z.T S_kl z",
     "T = m * dot(v, v) / 2 + dot(v, skew(omega) @ s + P @ zdot)"
     " + dot(omega, J @ omega) / 2 + dot(omega, H @ zdot) + dot(zdot, M @ zdot) / 2"),
    ("potential energy", "V = dot(z, K @ z) / 2 - dot(g, m * p + R @ s)"),
    ("acceleration of the frame beyond gravity, in its axes", "alpha = R.T @ (pddot - g)"),
    ("force on the frame, in its axes",
     "f = m * alpha + skew(omegadot) @ s + skew(omega) @ skew(omega) @ s"
     " + 2 * skew(omega) @ P @ zdot + P @ zddot"),
)  # fmt: skip
SOURCE = (
    "A. Zwoelfer, J. Gerstmayr, The nodal-based floating frame of reference formulation with "
    "modal reduction, Acta Mechanica 232 (2021); Géradin and Cardona, Flexible Multibody Dynamics "
    "(2001), chapter 8"
)


@dataclass(frozen=True)
class _Member:
    """A superelement on its places."""

    part: PartOfSystem
    keys: tuple[Key, ...]
    constants: Array


def superelements(
    scene: Scene, at: dict[Key, int], holds: Holds, powers: dict[str, int], taken: set[str]
) -> Iterator[Group]:
    """A table for each set of matrices and places of one size.

    Args:
        scene: The scene.
        at: Its places.
        holds: What places hold.
        powers: Numbers of the sources of power; damped superelements are added.
        taken: Names of kinds that there are.
    """
    alike: dict[tuple[object, ...], list[_Member]] = {}
    for part in scene.system.superelements:
        member = _Member(part, _keys(scene, part), constants(part))
        names = tuple(holds.space[key].name for key in member.keys)
        alike.setdefault((names, member.constants.tobytes()), []).append(member)
    for members in alike.values():
        first = members[0]
        blocks = tuple(holds.space[key] for key in first.keys)
        kind = _kind(unique("superelement", taken), blocks, first)
        damped = "power" in kind.functions
        yield Group(
            kind=kind,
            members=[member.part.name for member in members],
            places=_integers([[at[key] for key in member.keys] for member in members]),
            rows=np.zeros((len(members), 2), dtype=np.intp),
            common=_data(scene, f"{kind.name}__data", [member.part for member in members]),
            powers=_powers(members, powers) if damped else None,
        )


def _keys(scene: Scene, part: PartOfSystem) -> tuple[Key, ...]:
    """Places of a superelement: the node that carries its frame, then its joints."""
    body = scene.system.frames[scene.frame(part.frame)].body
    joints = tuple((JOINT, i) for i in part.joints)
    return joints if body == GROUND else ((NODE, body), *joints)


def _powers(members: Sequence[_Member], powers: dict[str, int]) -> Integers:
    return _integers([[powers.setdefault(one.part.name, len(powers))] for one in members])


def _integers(rows: Sequence[Sequence[int]]) -> Integers:
    return np.array(rows, dtype=np.intp)


def _data(scene: Scene, name: str, members: Sequence[PartOfSystem]) -> Function:
    """Where the axes are on the node or ground, and gravity, by the parameters."""
    system, nodes = scene.system, list[int]()
    for part in members:
        frame = system.frames[scene.frame(part.frame)]
        nodes += (*frame.rotation, *frame.position, *system.gravity)
    output = Output("data", (len(members), len(DATA)), tuple(nodes))
    return Function(name, system.graph, (parameters(system),), (output,), ("ground",))


def constants(part: PartOfSystem) -> Array:
    """Numbers of a record as ``superelement.h`` reads them, for its coordinates that move."""
    rows, record = list(part.rows), part.record
    inertia, both = part.inertia, np.ix_(rows, rows)
    spin = inertia.spin_modal[:, rows][:, :, rows]
    squares = np.array([_symmetric(inertia.spin_spin[k, m][both]) for k, m in PAIRS])
    if part.stiffening:
        # a product of two axes is there twice
        for pair, (name, (k, m)) in enumerate(zip(NAMES, PAIRS, strict=True)):
            if name in record.geometric:
                squares[pair] -= record.geometric[name][both] * (1.0 if k == m else 0.5)
    # (S X + e) against S_k Psi, symmetric in both axes
    bent = [(inertia.spin_angular[k, m] + inertia.spin_angular[m, k])[rows] / 2 for k, m in PAIRS]
    first = inertia.first
    flat = [
        # planar components have none across their plane
        inertia.mass.diagonal().max(),
        np.array([first[1, 2] - first[2, 1], first[2, 0] - first[0, 2], first[0, 1] - first[1, 0]])
        / 2,
        np.array([inertia.second[k, m] for k, m in PAIRS]),
        inertia.momentum[:, rows],
        inertia.angular[:, rows],
        np.array(bent),
        record.M[both],
        record.K[both],
        record.C[both],
        spin,
        spin.transpose(0, 2, 1),
        squares,
    ]
    if drifts(part):
        flat.append(inertia.drift[:, :, rows])
    return np.concatenate([np.ravel(np.asarray(x, dtype=float)) for x in flat]) + 0.0


def drifts(part: PartOfSystem) -> bool:
    """True when its inertia depends on the velocity of its frame."""
    return bool(
        np.abs(part.inertia.drift).max(initial=0.0) > ISOTROPIC * part.record.properties.mass
    )


def _symmetric(matrix: Array) -> Array:
    return np.asarray((matrix + matrix.T) / 2)


def _kind(name: str, blocks: tuple[BlockKind, ...], member: _Member) -> Kind:
    """The kind of superelements of some matrices on such places."""
    n, on_node = len(member.part.rows), member.keys[0][0] == NODE
    graph, letters = Graph(), {}
    for letter in ("q", "u", "udot"):
        entries = [
            f"{k + 1}.{entry}"
            for k, block in enumerate(blocks)
            for entry in (block.coordinates if letter == "q" else block.speeds)
        ]
        letters[letter] = Block(letter, tuple(entries), ("",) * len(entries))
    letters["p"] = Block("p", DATA, ("",) * len(DATA))
    size = n + 6 * on_node
    unmoved = [i * size + j for i in range(size) for j in range(3, 6)] if on_node else []
    still = [] if drifts(member.part) else unmoved
    damped = bool(member.part.record.C.any())
    # products with matrices (n, n) that a call makes
    results = {
        "balance": ((result(graph, "b", (size,)),), ("q", "u", "udot", "p"), 17),
        "balance_tangent": (
            (
                result(graph, "K", (size, size), unmoved),
                result(graph, "C", (size, size), still),
                result(graph, "M", (size, size)),
            ),
            ("q", "u", "udot", "p"),
            35,
        ),
        "energy": ((result(graph, "energy", (2,)),), ("q", "u", "p"), 11),
        "momentum": ((result(graph, "momentum", (6,)),), ("q", "u", "p"), 9),
        "power": ((result(graph, "power", (1,)),), ("q", "u", "p"), 1),
    }
    if not damped:
        del results["power"]
    functions = {
        key: Routine(
            name=f"{name}__{key}",
            graph=graph,
            inputs=tuple(letters[letter] for letter in read),
            outputs=outputs,
            owners=(name,),
            about="Reduced flexible body in a frame that moves far.",
            call=f"cardan_superelement_{key.removeprefix('balance_')}",
            headers=(*HEADERS, *TANGENT) if key == "balance_tangent" else HEADERS,
            sizes=(n, int(on_node), int(drifts(member.part))),
            constants=tuple(member.constants.tolist()),
            work=(TANGENT_ROOM * n + n * n if key == "balance_tangent" else ROOM * n),
            counts={"mul": products * n * n, "add": products * n * n},
        )
        for key, (outputs, read, products) in results.items()
    }
    return Kind(
        name=name,
        blocks=blocks,
        rows=(),
        mp=0,
        data=DATA,
        functions=functions,
        source=SOURCE,
        formulas=FORMULAS,
        symbol_shapes=_shapes(n),
        element="superelement",
        part="superelement",
    )


def _shapes(n: int) -> Shapes:
    return {
        "z": (n, 1),
        "zdot": (n, 1),
        "zddot": (n, 1),
        "s_0": (3, 1),
        "P": (3, n),
        "H": (3, n),
        "J": ("symmetric", 3),
        "M": ("symmetric", n),
        "K": ("symmetric", n),
    }


def refuse_plane(scene: Scene) -> None:
    """A superelement moves in space.

    Raises:
        DerivationError: there is one.
    """
    for part in scene.system.superelements:
        raise DerivationError(f"superelement '{part.name}' is in space; leave out plane=")
