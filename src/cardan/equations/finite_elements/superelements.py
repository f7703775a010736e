"""Superelements of a scene as tables of elements that routines of the kernels compute."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...arrays import Array, Integers
from ...elements.formulas import Lines, Shapes
from ...errors import DerivationError
from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...ir.routine import Routine, result
from ...records import dataclass
from ...topology.superelements.part_of_system import PartOfSystem
from ...topology.system import GROUND
from ..functions.blocks import parameters
from .blocks import Holds
from .nodal_scene import JOINT, NODE, Key, Scene
from .record import BlockKind, Group, Kind, unique

HEADERS = ("frame_motion.h", "rows.h", "superelement.h")
# headers that a routine needs beyond these
MORE_HEADERS = {
    "tangent": ("superelement_terms.h", "superelement_drift.h", "superelement_tangent.h"),
    "generalized_momenta": ("superelement_momenta.h",),
}
# pairs of axes in the order of the header
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1))
NAMES = ("xx", "yy", "zz", "yz", "zx", "xy")
DATA = (*(f"R{i}{j}" for i in "123" for j in "123"), *("px", "py", "pz"), *("gx", "gy", "gz"))
# of the mass, below which its dependence on directions is rounding
ISOTROPIC = 1e-12
# functions that the routine of the tangent computes
CALLS = {"balance_tangent": "tangent", "geometric": "tangent"}
# work that the routines need, by coordinates
ROOM, TANGENT_ROOM = 15, 37
PAIR_NAMES = ("11", "22", "33", "23", "31", "12")
ROWS: Lines = tuple(
    ("angular momentum by unit rates of z, row by row" * (k == 1), f"H_{k} = h_{k} + A_{k}.T @ z")
    for k in (1, 2, 3)
)
BENT: Lines = tuple(
    ("half of the slope of the inertia by z" * (kl == "11"), f"d_{kl} = j_{kl} + S_{kl} @ z")
    for kl in PAIR_NAMES
)
FORMULAS: Lines = (
    ("moment of first order of the deformed body, in axes of its frame, where R, p, v, omega are "
     "those of the frame, z the coordinates and all others constants of the record, with the "
     "geometric stiffness taken from S where it counts",
     "s = s_0 + P @ z"),
    *ROWS,
    ("", "H = row(H_1, H_2, H_3).T"),
    *BENT,
    *(("its inertia about the origin of the frame" * (kl == "11"),
       f"J_{kl} = I_{kl} + dot(z, j_{kl} + d_{kl})") for kl in PAIR_NAMES),
    ("", "J = matrix(J_11, J_12, J_31, J_12, J_22, J_23, J_31, J_23, J_33)"),
    ("kinetic energy",
     "T = m * dot(v, v) / 2 + dot(R.T @ v, skew(omega) @ s + P @ zdot)"
     " + dot(omega, J @ omega) / 2 + dot(omega, H @ zdot) + dot(zdot, M @ zdot) / 2"),
    ("potential energy", "V = dot(z, K @ z) / 2 - dot(g, m * p + R @ s)"),
    ("acceleration of the frame beyond gravity, in its axes", "alpha = R.T @ (vdot - g)"),
    ("rate of the inertia",
     "Jdot = 2 * matrix("
     + ", ".join(f"dot(d_{kl}, zdot)"
                 for kl in ("11", "12", "31", "12", "22", "23", "31", "23", "33")) + ")"),
    ("force on the frame, in its axes",
     "f = m * alpha + skew(omegadot) @ s + skew(omega) @ (skew(omega) @ s + 2 * P @ zdot)"
     " + P @ zddot"),
    ("moment on it",
     "n = skew(s) @ alpha + J @ omegadot + skew(omega) @ (J @ omega + H @ zdot) + Jdot @ omega"
     " + H @ zddot + column(dot(zdot, A_1 @ zdot), dot(zdot, A_2 @ zdot), dot(zdot, A_3 @ zdot))"),
    ("gyroscopic matrix of the coordinates",
     "C_g = " + " + ".join(f"omega_{k} * (A_{k}.T - A_{k})" for k in "123")),
    ("centrifugal stiffness of the coordinates",
     "K_c = "
     + " + ".join([*(f"omega_{k} ** 2 * S_{k}{k}" for k in "123"),
                   *(f"2 * omega_{kl[0]} * omega_{kl[1]} * S_{kl}" for kl in PAIR_NAMES[3:])])),
    ("what acts along z; the slopes d are those of centrifugal forces",
     "b_z = P.T @ alpha + H.T @ omegadot + C_g @ zdot"
     + "".join(f" - omega_{k} ** 2 * d_{k}{k}" for k in "123")
     + "".join(f" - 2 * omega_{kl[0]} * omega_{kl[1]} * d_{kl}" for kl in PAIR_NAMES[3:])
     + " + M @ zddot + D @ zdot + K @ z"),
    ("balance: moment in axes of the frame, force in ground axes, along z",
     "b = column(n, R @ f, b_z)"),
)  # fmt: skip
# what inertia adds that depends on the velocity of the frame
DRIFT: Lines = (
    ("velocity of the frame in its axes", "nu = R.T @ v"),
    ("its rate there", "nudot = R.T @ vdot - skew(omega) @ nu"),
    ("part of the inertia that depends on it",
     "G = matrix(" + ", ".join(f"dot(E_{r}{k}, z)" for r in "123" for k in "123") + ")"),
    ("", "Gdot = matrix(" + ", ".join(f"dot(E_{r}{k}, zdot)" for r in "123" for k in "123") + ")"),
)  # fmt: skip
DRIFTING = {
    "T": " + dot(nu, G @ omega)",
    "f": " + Gdot @ omega + G @ omegadot + skew(omega) @ G @ omega",
    "n": " + Gdot.T @ nu + G.T @ nudot + skew(omega) @ G.T @ nu + skew(nu) @ G @ omega",
    "b_z": "".join(
        f" - nu_{r} * (omega_1 * E_{r}1 + omega_2 * E_{r}2 + omega_3 * E_{r}3)" for r in "123"
    ),
}


def _formulas(drifting: bool) -> Lines:
    """Formulas of an element whose inertia depends on the velocity of its frame, or does not."""
    if not drifting:
        return FORMULAS
    longer = (
        (about, formula + DRIFTING.get(formula.partition(" = ")[0], ""))
        for about, formula in FORMULAS
    )
    return (*DRIFT, *longer)


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
        squares += _stiffening(part)
    # (S X + e) against S_k Psi, symmetric in both axes
    bent = [(inertia.spin_angular[k, m] + inertia.spin_angular[m, k])[rows] / 2 for k, m in PAIRS]
    flat = [
        # planar components have none across their plane
        inertia.mass.diagonal().max(),
        _first(inertia.first),
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


def _stiffening(part: PartOfSystem) -> Array:
    """Geometric stiffness as a part of S (6, n, n), by pairs of axes."""
    geometric, rows = part.record.geometric, list(part.rows)
    squares = np.zeros((len(PAIRS), len(rows), len(rows)))
    for pair, (name, (k, m)) in enumerate(zip(NAMES, PAIRS, strict=True)):
        if name in geometric:
            # a product of two axes is there twice
            squares[pair] = -geometric[name][np.ix_(rows, rows)] * (1.0 if k == m else 0.5)
    return squares


def drifts(part: PartOfSystem) -> bool:
    """True when its inertia depends on the velocity of its frame."""
    return bool(
        np.abs(part.inertia.drift).max(initial=0.0) > ISOTROPIC * part.record.properties.mass
    )


def _first(first: Array) -> Array:
    """m c (3,) of -(m c)^; planar components have only entries of their plane."""
    pairs = ((first[1, 2], -first[2, 1]), (first[2, 0], -first[0, 2]), (first[0, 1], -first[1, 0]))
    return np.array([max(pair, key=abs) for pair in pairs])


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
        "generalized_momenta": (
            (result(graph, "momenta", (size,)), result(graph, "slope", (size,))),
            ("q", "u", "udot", "p"),
            13,
        ),
    }
    if not damped:
        del results["power"]
    constants_of = dict.fromkeys(results, member.constants)
    if member.part.stiffening:
        # the part of the tangent by geometric stiffness alone
        results["geometric"] = results["balance_tangent"]
        constants_of["geometric"] = _geometric(member)
    functions = {
        key: Routine(
            name=f"{name}__{key}",
            graph=graph,
            inputs=tuple(letters[letter] for letter in read),
            outputs=outputs,
            owners=(name,),
            about="Reduced flexible body in a frame that moves far.",
            call=f"cardan_superelement_{CALLS.get(key, key)}",
            headers=(*HEADERS, *MORE_HEADERS.get(CALLS.get(key, key), ())),
            sizes=(n, int(on_node), int(drifts(member.part))),
            constants=tuple(constants_of[key].tolist()),
            work=(TANGENT_ROOM if key in CALLS else ROOM) * n,
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
        formulas=_formulas(drifts(member.part)),
        symbol_shapes=_shapes(n),
        element="superelement",
        part="superelement",
    )


def _geometric(member: _Member) -> Array:
    """Constants (k,) of an element that has geometric stiffness alone."""
    n, values = len(member.part.rows), np.zeros_like(member.constants)
    end = len(values) - 9 * n * drifts(member.part)
    values[end - 6 * n * n : end] = _stiffening(member.part).ravel()
    return values


def _shapes(n: int) -> Shapes:
    """Shapes of what the formulas read."""
    columns = ("z", "zdot", *(f"h_{k}" for k in "123"), *(f"j_{kl}" for kl in PAIR_NAMES))
    columns += tuple(f"E_{r}{k}" for r in "123" for k in "123")
    symmetric = ("M", "K", *(f"S_{kl}" for kl in PAIR_NAMES))
    return {
        "s_0": (3, 1),
        "P": (3, n),
        **dict.fromkeys(columns, (n, 1)),
        **dict.fromkeys(symmetric, ("symmetric", n)),
        **dict.fromkeys([f"A_{k}" for k in "123"], (n, n)),
    }


def refuse_plane(scene: Scene) -> None:
    """A superelement moves in space.

    Raises:
        DerivationError: there is one.
    """
    for part in scene.system.superelements:
        raise DerivationError(f"superelement '{part.name}' is in space; leave out plane=")
