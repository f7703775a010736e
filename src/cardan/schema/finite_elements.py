"""Records of the elements of a model in absolute coordinates: what the manifest says of them.

Their numbers, such as which places an element couples, stand in tables beside the manifest.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence

from .fields import NOTHING, Record, count, field, listed, number, pair, table, text

# in place of a node: the ground, and a body that the joints of a rigid tree place; where there are
# several such bodies these are counted downward
GROUND, ON_TREE = -1, -2
# numbers of a row of "jumps" besides its gradient: kind, active, missing speed, release speed
JUMP_NUMBERS = 4
# numbers of the motion of a body in "bodies": R (9), p (3), velocity (6), acceleration (6)
MOTION_NUMBERS = 24
# gradients of weighted sums of results of elements -> the functions whose results these are; they
# are written when products with derivatives are asked for
GRADIENTS = {
    "dynamics_gradient": ("balance", "balance_tangent", "gamma", "zdot"),
    "energy_gradient": ("energy",),
    "momentum_gradient": ("momentum",),
    "power_gradient": ("power",),
    "outputs_gradient": ("outputs",),
    "reaction_gradient": ("reaction",),
    "reactions_gradient": ("reactions",),
    "element_forces_gradient": ("element_forces",),
    "bodies_gradient": ("bodies",),
    # of M udot - Gᵀ lam and G udot - H lam, which impulses obey, and whose slopes M and G are
    "impulse_gradient": ("balance_tangent",),
    # of events: their values, impulses that these ask for, states behind them, and friction by
    # reactions
    "signs_gradient": ("signs",),
    "jumps_gradient": ("jumps",),
    "states_gradient": ("change",),
    "friction_gradient": ("reaction_friction",),
}
# changes of these gradients along a direction, at fixed weights
CURVATURES = {name.replace("gradient", "curvature"): sums for name, sums in GRADIENTS.items()}
# changes of these results along a direction
CHANGES = {name.replace("gradient", "change"): sums for name, sums in GRADIENTS.items()}
DERIVATIVES = GRADIENTS | CHANGES | CURVATURES
# derivatives that are also by what events read besides: speeds behind them, how certain friction is
# that follows from reactions, and responses
EVENT_DERIVATIVES = tuple(
    f"{name}_{mode}"
    for name in ("signs", "jumps", "states")
    for mode in ("gradient", "change", "curvature")
)
IMPULSE_DERIVATIVES = ("impulse_gradient", "impulse_change", "impulse_curvature")
# those of the rates of coordinates of a place, by q and u
RATES = ("qdot_gradient", "qdot_change", "qdot_curvature")
# a formula in the names of the model with outputs in v, its gradient, and changes of that
FORMULAS = ("expression", "expression_gradient", "expression_curvature")
EXPRESSION, EXPRESSION_GRADIENT, EXPRESSION_CURVATURE = FORMULAS


def requested_name(form: str, of: str) -> str:
    """C name of a function that is written when derivatives are asked for.

    Args:
        form: Such as ``dynamics_gradient``.
        of: The kind of element or place, or the formula.
    """
    if form in FORMULAS:
        return f"{form}__{hashlib.sha256(of.encode()).hexdigest()[:16]}"
    return f"{of}__{form}"


class Plane(Record):
    """A node of a plane, told by x, y and angle."""

    spread: Sequence[Sequence[float]] = field(
        listed(listed(number, 3), 6),
        "speeds in space, angular velocity in axes of the node and velocity in those of the "
        "ground, from the rates of x, y and angle (6, 3)",
    )
    home: Sequence[float] = field(listed(number, 4), "unit quaternion at x = y = angle = 0 (4)")


class PlaceKind(Record):
    """Kind of a place."""

    name: str = field(text, "node, plane_node, line<k> or that of a joint")
    nq: int = field(count, "number of coordinates")
    nu: int = field(count, "number of speeds")
    quaternion: int | None = field(
        count, "entry of its q that is the scalar part of a unit quaternion", default=None
    )
    functions: Mapping[str, str] = field(
        table(text), "C names of move and qdot where speeds are not rates", default=NOTHING
    )
    plane: Plane | None = field(Plane, "of nodes of a plane how they stand in space", default=None)

    @property
    def derivatives(self) -> Mapping[str, str]:
        """Derivatives that may be asked for -> C names."""
        moves = "qdot" in self.functions
        return {form: requested_name(form, self.name) for form in RATES if moves}

    @property
    def node(self) -> bool:
        """True when it is a node, which moves by itself."""
        return self.name == "node" or self.plane is not None


class ElementKind(Record):
    """Kind of an element."""

    name: str = field(text, "C identifier")
    nq: int = field(count, "number of local coordinates")
    nu: int = field(count, "number of local speeds")
    m: int = field(count, "rows of constraints")
    mp: int = field(count, "those of positions among them, which come first")
    nz: int = field(count, "number of internal states", default=0)
    ns: int = field(count, "number of modes", default=0)
    ne: int = field(count, "number of events", default=0)
    states: tuple[int, int] = field(
        pair(), "how many of its z and of its s are its own, the first ones", default=(0, 0)
    )
    switched: int = field(count, "rows that modes hold, the last of m", default=0)
    jumps: int = field(count, "number of impulses and responses", default=0)
    responses: int = field(count, "number of responses among them", default=0)
    frictions: int = field(count, "frictions that follow from its reaction", default=0)
    strain: str = field(
        text,
        "'alone' where all it does at rest is the force of a strain whose energy it tells, 'mixed' "
        "where it does more, or tells other energies too; '' where nothing is strained",
        default="",
    )
    functions: Mapping[str, str] = field(table(text), "name -> C name", default=NOTHING)
    parts: Mapping[str, int] = field(
        table(count), "matrices of the tangent -> where they begin in it", default=NOTHING
    )

    @property
    def derivatives(self) -> Mapping[str, str]:
        """Derivatives that may be asked for -> C names."""
        return {
            form: requested_name(form, self.name)
            for form, sums in DERIVATIVES.items()
            if not self.functions.keys().isdisjoint(sums) and self._has(form)
        }

    def _has(self, form: str) -> bool:
        """False of impulses where nothing has mass or is held."""
        return form not in IMPULSE_DERIVATIVES or not {"M", "G"}.isdisjoint(self.parts)

    @property
    def released(self) -> int:
        """Number of the last rows of m that modes may let go; files may leave it out."""
        return self.switched or ("H" in self.parts and self.m) or 0


class GroupRow(Record):
    """The elements of a kind that follow each other; their tables stand in mesh.npz."""

    kind: str = field(text, "name of what they share")
    common: str = field(text, "saved Function p -> data of the elements", default="")
    members: Sequence[str] = field(listed(text), "their names")


class FiniteElements(Record):
    """Elements of a model in finite-element coordinates."""

    places: Sequence[PlaceKind] = field(listed(PlaceKind), "kinds of places")
    kinds: Sequence[ElementKind] = field(listed(ElementKind), "kinds of elements")
    groups: Sequence[GroupRow] = field(listed(GroupRow), "tables of elements")
    beam_nodes: Sequence[int] = field(listed(count), "places of nodes that only beams hold")
    segments: int = field(count, "segments of beams, whose nodes are line_<k> in mesh.npz")
    frames: str = field(text, "saved Function: where frames sit on their nodes")
    states: str = field(text, "saved Function: states of nodes by coordinates of joints")
    reference: Sequence[float] = field(
        listed(number),
        "coordinates of the joints in the reference configuration, as states takes them",
    )
    power_sources: Sequence[str] = field(
        listed(text), "sources of power: elements, <joint>.motion, <relation>.motion"
    )
    reactions: Mapping[str, tuple[int, int]] = field(
        table(pair()), "joint -> group and member whose reaction it is"
    )
    reaction_frames: Mapping[str, str] = field(
        table(text), "joint -> child frame, where its reaction acts", default=NOTHING
    )
    tree_joints: Sequence[str] = field(
        listed(text),
        "joints inside of rigid trees, whose reactions add up over elements",
        default=(),
    )
    forces: Mapping[str, tuple[int, int]] = field(
        table(pair()), "element -> group and member whose force it is", run=NOTHING
    )
