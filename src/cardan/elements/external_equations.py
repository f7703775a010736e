"""Equations that were derived elsewhere, as a block of coordinates and what acts on it.

The block is a joint that moves no body; M of the equations is an inertia of its speeds, all other
terms are forces along them. Everything behind the system graph needs to know no more.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any, ClassVar

from ..ir.derivative import forward
from ..ir.graph import ONE
from ..ir.matrix import Matrix
from ..ir.rewrite import rebuild
from ..ir.solve import solve
from ..records import dataclass
from ..schema.functions import FUNCTIONS
from .forces.force import Action, ForceElement, JointLoad, Places
from .joints.joint import Component, Joint
from .quantity import JointName, Quantity, Ready

# what functions need of a model that written equations do not tell
UNKNOWN = {
    "bodies": "written equations tell of no bodies and frames; declare what is wanted as an output",
    "inertias": "written equations do not tell masses and inertias from other parameters",
    "element forces": "written equations tell of no force elements",
    "kinetic energy": "written equations tell of no kinetic energy to differentiate",
    "causes of forces": "written equations do not tell gravity and velocity products from other "
    "forces; 'applied_forces' has all of them",
}
ABSENT = {
    row.name: UNKNOWN[need] for row in FUNCTIONS.values() for need in row.needs if need in UNKNOWN
}


@dataclass(frozen=True)
class Written(Joint):
    """Coordinates and speeds of written equations, with q' = N(q) u + n(t, q).

    Made by :func:`cardan.from_sympy`.

    Args:
        names, speed_names: Of all coordinates and speeds.
        kinematics: q' in coordinates, speeds, parameters and t, (nq, 1).
        reference: What SymPy says at some states; see :attr:`samples`.
        without: Functions that these equations do not give, and why.

    Source: T. R. Kane, D. A. Levinson, Dynamics: Theory and Applications, 1985, chapter 6.
    """

    kind: ClassVar[str] = "written"
    names: tuple[str, ...]
    speed_names: tuple[str, ...]
    kinematics: Ready
    reference: tuple[Mapping[str, Any], ...] = field(default=(), repr=False)
    without: Mapping[str, str] = field(default_factory=dict, repr=False)

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return tuple(Component(name, "", alone=True) for name in self.names)

    @property
    def speeds(self) -> tuple[Component, ...]:
        graph, owner_of = self.kinematics.graph, dict[str, str]()
        # q' = u of this coordinate and of no other
        for node, name in zip(self.kinematics.nodes, self.names, strict=True):
            if graph.nodes[node][0] == "atom":
                speed = str(graph.nodes[node][1])
                owner_of[speed] = "" if speed in owner_of else name
        return tuple(Component(n, "", alone=True, of=owner_of.get(n, "")) for n in self.speed_names)

    def quantities(self) -> dict[str, Quantity]:
        local = (*self.names, *self.speed_names, "t")
        return {"kinematics": Quantity(self.kinematics, local=local)}

    @property
    def bodiless(self) -> bool:
        return True

    @property
    def samples(self) -> Sequence[Mapping[str, Any]]:
        return self.reference

    @property
    def lacks(self) -> Mapping[str, str]:
        return ABSENT | dict(self.without)

    @property
    def coincident(self) -> bool:
        return False

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return Matrix.identity(q.graph, 3), Matrix.zeros(q.graph, 3)

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.zeros(q.graph, 6, len(self.speed_names))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        return Matrix.identity(q.graph, 6)

    # q' = N u + n

    def rates(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        return self._substituted(data["kinematics"], q, u)

    def _substituted(self, x: Matrix, q: Matrix, u: Matrix | None) -> Matrix:
        """Expressions in the names of coordinates and speeds at q and u."""
        graph = x.graph
        leaf_nodes = dict(zip(self.names, q.nodes, strict=True)) | {"t": graph.var("t", 0)}
        leaf_nodes |= dict(zip(self.speed_names, u.nodes, strict=True)) if u is not None else {}
        leaves = {graph.atom(name): node for name, node in leaf_nodes.items()}
        nodes = rebuild(graph, x.nodes, leaves, into=graph)[1]
        return Matrix(graph, x.rows, x.columns, nodes)

    def _kinematic_matrix(self, q: Matrix, x: Matrix) -> Matrix:
        """N (nq, nu) at q."""
        graph = x.graph
        columns = [forward(graph, x.nodes, {graph.atom(n): ONE}) for n in self.speed_names]
        nodes = [column[i] for i in range(x.rows) for column in columns]
        return self._substituted(Matrix(graph, x.rows, len(columns), nodes), q, None)

    def speeds_of(self, q: Matrix, qdot: Matrix, **data: Matrix) -> Matrix:
        kinematics = data["kinematics"]
        explicit = self._substituted(kinematics, q, Matrix.zeros(q.graph, len(self.speed_names)))
        return _along(self._kinematic_matrix(q, kinematics), qdot - explicit)

    def integrate(self, q: Matrix, du: Matrix, **data: Matrix) -> Matrix:
        return q + self._kinematic_matrix(q, data["kinematics"]) @ du

    def difference(self, q0: Matrix, q1: Matrix, **data: Matrix) -> Matrix:
        return _along(self._kinematic_matrix(q0, data["kinematics"]), q1 - q0)


def _along(kinematic: Matrix, change: Matrix) -> Matrix:
    """The smallest increment (nu, 1) that N turns into a change of the coordinates."""
    across = kinematic.T
    if kinematic.nodes == Matrix.identity(kinematic.graph, kinematic.rows).nodes:
        return change
    if kinematic.rows == kinematic.columns:
        return solve("rank_revealing", kinematic, change)
    if kinematic.rows > kinematic.columns:
        return solve("rank_revealing", across @ kinematic, across @ change)
    return across @ solve("rank_revealing", kinematic @ across, change)


@dataclass(frozen=True)
class WrittenForces(ForceElement):
    """M and everything else of written equations M u' = f.

    Args:
        joint: The block of coordinates.
        inertia: M (nu, nu), symmetric.
        forces: f (nu, 1).
        potential: Potential energy, where it is known.
        applied: The part of f (nu, 1) that has no potential, where that is known.

    Source: T. R. Kane, D. A. Levinson, Dynamics: Theory and Applications, 1985, chapter 6.
    """

    kind: ClassVar[str] = "written"
    strained: ClassVar[bool] = False
    joint: JointName
    inertia: Ready
    forces: Ready
    potential: Ready | None = None
    applied: Ready | None = None

    def quantities(self) -> dict[str, Quantity]:
        values = {"inertia": self.inertia, "forces": self.forces}
        optional = {"potential": self.potential, "applied": self.applied}
        values |= {name: value for name, value in optional.items() if value is not None}
        return {name: Quantity(value) for name, value in values.items()}

    def rotor_inertia(self, data: Mapping[str, Matrix]) -> dict[str, Matrix]:
        return {"joint": data["inertia"]}

    def acts_on(self) -> tuple[str, str]:
        return "", ""

    def act(self, at: Places) -> tuple[Action, ...]:
        forces, joint = at.data["forces"], at.joints["joint"]
        if "potential" not in at.data:
            return (Action(joint_loads=(JointLoad(joint, forces),)),)
        applied = at.data.get("applied", Matrix.zeros(forces.graph, forces.rows))
        stored = Action(
            joint_loads=(JointLoad(joint, forces - applied),), potential=at.data["potential"][0]
        )
        lost = Action(joint_loads=(JointLoad(joint, applied),))
        return (stored,) if applied.is_zero else (stored, lost)
