"""Functions of long trees by kernels: which are, why some are not, and how they are made.

The mass matrix and the derivatives of inverse and forward dynamics of a long tree are assembled by
a kernel that loops over a table of its bodies. Their numbers come from expressions in axes of the
ground: as loops where many bodies are alike, else straight-line.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from ...errors import counted
from ...ir.function import Output, live
from ...ir.matrix import Matrix
from ...ir.trees.assembly import Assembly
from ...ir.trees.table import (
    BODY,
    MASS_BODY,
    MASS_SPEED,
    MOST_SPEEDS,
    SPEED,
    Entry,
    OutputRow,
    Tree,
    chunks,
)
from ...schema.request import Request
from ...topology.system import System
from ..constraints.reaction_friction import friction_forces
from ..functions.directions import Direction, directions
from ..functions.dynamics import Dynamics
from ..functions.newton_euler_derivatives import joint_change
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, applied, none
from ..recursion.recursion_boundary import Cuts
from ..recursion.representatives import Representatives, representatives
from .body_numbers import BODY as BODY_NAMES
from .body_numbers import COLUMN, INERTIA, Slopes, mass_numbers
from .body_numbers import SPEED as SPEED_NAMES
from .ground_motion import GroundMotion, begins
from .parts import Names, Numbers, numbers_of_bodies
from .tree_table import Widths, all_entries, entry_pattern, inboard_pairs, speeds_of, tree_table

# pairs of a speed and one inboard of it above which kernels are taken: below, straight-line code is
# faster, as measured on arms, legged robots and chains
LONG = {"mass_matrix": 1000, "derivative": 110}
# functions whose derivatives the kernel gives, and the block by which they give M or its inverse
DERIVED = {"forward_dynamics": "tau", "inverse_dynamics": "udot"}
# blocks whose entries may change the forces of elements along joints, and nothing else
OF_FORCES = ("z", "r")


def refusal(system: System, name: str, of: str | None, chosen: bool, short: bool = False) -> str:
    """Why a function of a system is not assembled by a kernel, "" where it may be.

    Args:
        system: The system graph.
        name, of: The function.
        chosen: Whether the user chose the speeds.
        short: Whether short trees may be, too.
    """
    if name not in LONG:
        return "no kernel assembles it"
    if not system.nu:
        return "nothing moves"
    pairs = inboard_pairs(system)
    if pairs <= LONG[name] and not short:
        return f"{counted(pairs, 'pair')} of speeds inboard of each other are few"
    if chosen:
        return "speeds are chosen"
    if system.closed or system.closures:
        return "loops tie joints together"
    if system.written:
        return "its equations are written"
    for joint in system.joints:
        if joint.coupling is not None:
            return f"joint '{joint.name}' is coupled"
        if joint.u >= 0 and len(joint.element.speeds) > MOST_SPEEDS:
            return f"joint '{joint.name}' has more than {MOST_SPEEDS} speeds"
    if friction_forces(system):
        return "friction follows from reactions"
    far = _far(system)
    if far:
        return f"joint '{far}' rotates where a slide may have taken it far from the tree's base"
    if name == "derivative":
        request = Request.read(of or "")
        if request.function not in DERIVED:
            return f"no kernel assembles derivatives of '{request.function}'"
        taken = ("q", "u", DERIVED[request.function], *OF_FORCES)
        for wrt in request.wrt:
            if wrt not in taken:
                return f"no kernel assembles derivatives by '{wrt}'"
    return ""


def _far(system: System) -> str:
    """A joint that rotates at or behind a slide on a body that rotates, "" if there is none.

    Numbers count from the tree's base in axes of the ground. Of a body at a distance d they leave
    eps d^2 m of its moments of inertia, which is too little where nothing limits d.
    """
    rotated, distant = list[bool](), list[bool]()
    for body, joint in zip(system.bodies, system.joints, strict=True):
        units = {coordinate.unit for coordinate in joint.element.coordinates}
        rotates, slides = bool(units - {"m"}), "m" in units
        inboard = body.parent >= 0
        behind = inboard and rotated[body.parent]
        distant.append((inboard and distant[body.parent]) or (slides and behind))
        rotated.append(behind or rotates)
        if rotates and distant[-1]:
            return joint.name
    return ""


def mass_matrix(system: System, names: Names, loops: bool | None) -> Assembly:
    """M of a tree, ``tree_mass.h``."""
    k = Kinematics(system)
    loads = none(k)
    rotors = {i: loads.rotors[i].rows for i in loads.rotors if speeds_of(system, i)}
    table = tree_table(system, Widths(MASS_BODY, MASS_SPEED), rotors=rotors)

    def numbers(k: Kinematics, cuts: Cuts | None, numbering: Sequence[int]) -> Numbers:
        gravity, bases = Dynamics(k, "composite").gravity, begins(system, numbering)
        motion, loads = GroundMotion(k, gravity, cuts, False, bases), none(k)
        return lambda i: mass_numbers(motion, loads, i)

    alike = representatives(system) if loops is not False else None
    parts = numbers_of_bodies(system, names, table, numbers, (INERTIA, COLUMN), loops, alike)
    tree = Tree(table.bodies, table.speeds, table.rotors)
    speeds = names.entries["u"]
    entries = tuple(f"{a},{b}" for a in speeds for b in speeds)
    shape = (system.nu, system.nu)
    nodes = entry_pattern(table, system, related=True)
    output = Output("M", shape, nodes, entries)
    return Assembly(names.symbol, names.inputs, (output,), parts, "tree_mass", tree, names.about)


def derivative(
    system: System, names: Names, request: Request, loops: bool | None
) -> Assembly | str:
    """A derivative of the inverse or forward dynamics of a tree, ``tree_derivatives.h``.

    Returns:
        Why there is none, where forces of elements depend on more than the kernel takes.
    """
    k = Kinematics(system)
    loads, n = applied(k), system.nu
    columns, blocks_at = _columns_of(k, names, request)
    reason = _unsuitable(k, loads, [*columns.values()])
    if reason:
        return reason
    moving_modes = _moving_modes(k, columns)
    alike = representatives(system) if loops is not False else None
    pattern = _changing(k, loads, columns, alike)
    rotors = {i: loads.rotors[i].rows for i in loads.rotors if speeds_of(system, i)}
    counts = {i: len(entries) for i, entries in pattern.items()}
    table = tree_table(system, Widths(BODY, SPEED), moving_modes, rotors, counts)

    def numbers(k: Kinematics, cuts: Cuts | None, numbering: Sequence[int]) -> Numbers:
        gravity, bases = Dynamics(k, "composite").gravity, begins(system, numbering)
        motion = GroundMotion(k, gravity, cuts, True, bases)
        at = {body: i for i, body in enumerate(numbering)}
        along = _columns_of(k, names, request)[0]
        slopes = Slopes(
            motion,
            applied(k),
            {(d.block, d.index): d for d in along.values()},
            frozenset(at[i] for i in moving_modes if i in at),
            {
                at[i]: [(row, along[column]) for row, column in entries]
                for i, entries in pattern.items()
                if i in at
            },
        )
        return slopes.numbers

    parts = numbers_of_bodies(
        system, names, table, numbers, (BODY_NAMES, SPEED_NAMES), loops, alike
    )
    half = chunks(n)

    def side(column: int) -> int:
        """Right side of a column: those along q and u begin at chunks."""
        return column + (half - n) * min(column // n, 2)

    changes = [
        Entry(
            table.speed_of_slot[system.joints[i].u + row], side(column), table.changes[i] + number
        )
        for i, entries in pattern.items()
        for number, (row, column) in enumerate(entries)
    ]
    forward = request.function == "forward_dynamics"
    outputs, rows = list[Output](), list[OutputRow]()
    for wrt in request.wrt:
        count, first = (n, 0) if wrt not in blocks_at else (blocks_at[wrt][1], blocks_at[wrt][0])
        of_mass = wrt == DERIVED[request.function]
        rows.append(OutputRow(int(of_mass), count, 0 if of_mass else side(first)))
        labels = names.entries["u" if wrt == "q" else wrt]
        labels_of_entries = tuple(
            f"{row},{label}" for row in names.entries["u"] for label in labels
        )
        related = not forward
        nodes = (
            entry_pattern(table, system, related)
            if count == n and wrt in ("q", "u", "tau", "udot")
            else all_entries(n * count)
        )
        outputs.append(Output(f"d_{wrt}", (n, count), nodes, labels_of_entries))
    width = len(columns) - 2 * n
    tree = Tree(
        table.bodies, table.speeds, table.rotors, tuple(rows), tuple(changes), width, forward
    )
    return Assembly(
        names.symbol, names.inputs, tuple(outputs), parts, "tree_derivatives", tree, names.about
    )


def _columns_of(
    k: Kinematics, names: Names, request: Request
) -> tuple[dict[int, Direction], dict[str, tuple[int, int]]]:
    """Right sides by their number, and block -> (first, count): q and u come first."""
    columns: dict[int, Direction] = {}
    blocks: dict[str, tuple[int, int]] = {}
    for wrt in ("q", "u", *(w for w in request.wrt if w in OF_FORCES)):
        if wrt in blocks:
            continue
        along = directions(k, wrt, names.entries)
        blocks[wrt] = (len(columns), len(along))
        columns |= {len(columns) + n: d for n, d in enumerate(along)}
    return columns, blocks


def _leaves(k: Kinematics, nodes: Sequence[int]) -> set[int]:
    """Entries of input blocks that some nodes are made from."""
    return {i for i in live(k.graph, nodes) if k.graph.nodes[i][0] == "var"}


def _unsuitable(k: Kinematics, loads: Loads, columns: Sequence[Direction]) -> str:
    """Name what depends on more than the kernel takes, "" where nothing does."""
    seeds = {leaf for d in columns for leaf in d.seeds}
    for i, wrench in loads.wrenches.items():
        if not seeds.isdisjoint(_leaves(k, [node for x in wrench for node in x.nodes])):
            return f"forces on body '{k.owner(i)}' change with the state"
    for i, joint in enumerate(k.system.joints):
        if i in loads.joints and joint.motion is None and speeds_of(k.system, i) == 0:
            return f"joint '{joint.name}' has no speeds of its own"
    foreign = {leaf for d in columns if d.block in OF_FORCES for leaf in d.seeds}
    moved = [node for i in range(len(k.joints)) for node in _of_motion(k, i)]
    moved += k.vector(k.system.gravity).nodes
    if not foreign.isdisjoint(_leaves(k, moved)):
        return "inputs move bodies"
    return ""


def _of_motion(k: Kinematics, i: int) -> list[int]:
    """Expressions of the motion and the inertia of a body."""
    joint, body = k.joints[i], k.system.bodies[i]
    inertia = k.resolve([body.mass, *body.first_moment, *body.inertia])
    parts = (joint.rotation, joint.position, joint.S, joint.velocity, joint.drift)
    return [*inertia, *(node for x in parts for node in x.nodes)]


def _moving_modes(k: Kinematics, columns: dict[int, Direction]) -> frozenset[int]:
    """Bodies whose columns of S are not fixed to them."""
    moving_modes = set[int]()
    for i, joint in enumerate(k.joints):
        still = Matrix.zeros(k.graph, joint.S.columns)
        for slot, column in joint.columns:
            direction = columns[slot]
            assert (direction.block, direction.index) == ("q", slot)
            modes = joint_change(k, i, still, direction.seeds, column)[1]
            if not all(x.is_zero for x in modes.values()):
                moving_modes.add(i)
    return frozenset(moving_modes)


def _changing(
    k: Kinematics, loads: Loads, columns: dict[int, Direction], alike: Representatives | None
) -> dict[int, list[tuple[int, int]]]:
    """Body -> (row among its speeds, column): where forces of elements along joints may change.

    Bodies that are alike have them in the same order: what is theirs alone as they read it.
    """

    def order(i: int, column: int) -> tuple[int, int]:
        entry = (columns[column].block, columns[column].index)
        entries = alike.entries[i] if alike is not None else ()
        return (1, entries.index(entry)) if entry in entries else (0, column)

    by_leaf: dict[int, list[int]] = {}
    for number, direction in columns.items():
        for leaf in direction.seeds:
            by_leaf.setdefault(leaf, []).append(number)
    pattern: dict[int, list[tuple[int, int]]] = {}
    for i, force in loads.joints.items():
        if not speeds_of(k.system, i):
            continue
        entries = [
            (row, column)
            for row, node in enumerate(force.nodes)
            for column in sorted(
                {c for leaf in _leaves(k, [node]) for c in by_leaf.get(leaf, ())},
                key=partial(order, i),
            )
        ]
        if entries:
            pattern[i] = entries
    return pattern
