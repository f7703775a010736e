"""The gravity of a planet or of another body along a beam."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import ClassVar

from ...ir.arithmetic import Scalar
from ...ir.function import Function, Output
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...records import dataclass
from ..forces.gravity.central_gravity import CentralGravity
from ..forces.gravity.fields import Pull
from ..forces.gravity.gravitation import Gravitation
from ..forces.gravity.gravity_gradient import GravityGradient
from ..formulas import Lines, Shapes
from .element import FlexibleElement, balance, energy, tangents
from .element_ends import CENTER, Ends
from .formulas import SPIN_SHAPES, gravity_lines
from .inertia import DENSITY, SHEAR, cubic_share, spin
from .node_set import FRAME, Ground, Pose

# of one half of the mass on the element, which goes from -1 to 1
GAUSS = 1.0 / math.sqrt(3.0)
# that of a point, for elements that stand alone
POINT = CentralGravity("ground", 0.0)


@dataclass(frozen=True)
class GravityField(FlexibleElement):
    """Halves of the mass of an element at two points along it, pulled by a gravity field.

    The points are the two of Gauss on the shape that the inertia of the beam has: polynomials along
    the element up to the third degree are integrated exactly, so that a straight element has its
    exact mass, mass center and second moment. The field itself is left with an error of order
    (length / distance)^4. Where inertia is lumped the points are the ends: first degree, and order
    (length / distance)^2. Sections at the points rotate with the ends next to them.

    ``potential = sum of the potentials of both halves``, and forces and moments are its exact
    derivatives. The center is a third end where it moves, which is pulled back.

    Attributes:
        field: What pulls; where it is and its numbers are among the data.
        lumped: The mass is at the ends.
        variable: Quantities of the field that more than parameters change: no data, the ends have
            their expressions, and what pulls has no potential.

    Source: P. C. Hughes, Spacecraft Attitude Dynamics, 1986, chapter 8.
    """

    kind: ClassVar[str] = "gravity_field"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    symbol_shapes: ClassVar[Shapes] = SPIN_SHAPES
    field: Gravitation = POINT
    lumped: bool = False
    variable: tuple[str, ...] = ()

    @property
    def common(self) -> tuple[str, ...]:
        fixed = (names for name, names in self._quantities().items() if name not in self.variable)
        quantities = [name for names in fixed for name in names]
        return (*DENSITY, *SHEAR, *quantities, *(f"{CENTER}_{entry}" for entry in FRAME))

    @property
    def variant(self) -> str:
        lumped, variable = "lumped" * self.lumped, "variable" * bool(self.variable)
        options = (self.field.kind, self.field.option, lumped, variable)
        return "_".join(option for option in options if option)

    @property
    def formula_lines(self) -> Lines:
        gradient = isinstance(self.field, GravityGradient)
        if not self.field.has_potential or not (gradient or isinstance(self.field, CentralGravity)):
            return ()
        return gravity_lines(gradient, self.lumped, not self.variable)

    def _quantities(self) -> dict[str, tuple[str, ...]]:
        """Names of the data of every quantity of the field."""
        names: dict[str, tuple[str, ...]] = {}
        for name, quantity in self.field.quantities().items():
            vector = isinstance(quantity.value, (list, tuple))
            names[name] = tuple(f"{name}_{k}" for k in (1, 2, 3)) if vector else (name,)
        return names

    def functions(self, ends: Ends) -> dict[str, Function]:
        with ends.graph.made_by("", "loads"):
            forces, potential = self._loads(ends)
            loads = ends.assembled(forces)
        read, changes = ends.blocks("q", "p"), "q"
        if self.variable:
            read, changes = ends.blocks("t", "q", "u", "z", "s", "r", "p"), "qu"
        functions = {
            "balance": self.function(ends, "balance", read, balance(ends, loads)),
            "balance_tangent": self.function(
                ends, "balance_tangent", read, *tangents(ends, loads, *changes)
            ),
        }
        if self.field.has_potential and not self.variable:
            column = Matrix.vector(ends.graph, [potential])
            functions["energy"] = self.function(ends, "energy", read, energy(None, column))
            return functions
        speeds = [ends.graph.var("u", k) for k in range(loads.rows)]
        rate = -(loads.T @ Matrix(ends.graph, loads.rows, 1, speeds))
        power = Output("power", (1,), rate.nodes, ("power",), ("W",))
        moving = read if self.variable else ends.blocks("q", "u", "p")
        return functions | {"power": self.function(ends, "power", moving, power)}

    def _loads(self, ends: Ends) -> tuple[list[Matrix], Scalar]:
        """Moments and forces that hold the ends and a center that moves; the potential energy."""
        g = ends.graph
        poses, center = [ends.pose(k) for k in range(2)], self._center(ends)
        axis = Matrix.vector(g, [1.0, 0.0, 0.0])
        tangents_of_ends = [pose.rotation @ axis for pose in poses]
        spans = [pose.position - center.position for pose in poses]
        zero = Matrix.zeros(g, 3)
        on_tangents, on_ends, turns = [zero, zero], [zero, zero], list[Matrix]()
        back, back_turn = zero, zero
        potential = Scalar(g, g.const(0.0))
        for k, weights in enumerate(self._weights(ends)):
            # the masses hang on positions and tangents of both ends, as their shape does
            r = zero
            for weight, vector in zip(weights, (*spans, *tangents_of_ends), strict=True):
                r = r + vector * weight
            pull = self._pull(ends, r, poses[k], center)
            for i in range(2):
                on_ends[i] = on_ends[i] + pull.force * weights[i]
                on_tangents[i] = on_tangents[i] + pull.force * weights[2 + i]
            turns.append(pull.torque)
            back = back + pull.force
            back_turn = back_turn + self.field.torque_about_center(r, pull)
            potential = potential + pull.potential
        loads: list[Matrix] = []
        for i, pose in enumerate(poses):
            moment = axis.cross(pose.rotation.T @ on_tangents[i]) + pose.rotation.T @ turns[i]
            loads += [-moment, -on_ends[i]]
        if len(ends.kinds) > 2:
            loads += [center.rotation.T @ back_turn, back]
        return loads, potential

    def _center(self, ends: Ends) -> Pose:
        """Pose of the center of the field: on the ground unless it is an end."""
        if len(ends.kinds) > 2:
            return ends.pose(2)
        attributes = tuple(ends.number(f"{CENTER}_{entry}") for entry in Ground.data)
        return Ground(ends.graph, attributes, 0, 0).pose()

    def _weights(self, ends: Ends) -> Iterator[list[Scalar]]:
        """Shares of p_1, p_2, t_1, t_2 in the place of each half of the mass."""
        g: Graph = ends.graph
        one, length = Scalar(g, g.const(1.0)), ends.number("length")
        eta = one * 0.0 if self.lumped else cubic_share(ends)
        for s in (-1.0, 1.0) if self.lumped else (-GAUSS, GAUSS):
            odd, even = s - s**3, 1.0 - s * s
            along, bent = eta * (odd / 4.0), length * (even / 8.0)
            from_cubic = eta * length * (odd / 8.0)
            yield [
                one * (0.5 - s / 2.0) - along,
                one * (0.5 + s / 2.0) + along,
                bent - from_cubic,
                -bent - from_cubic,
            ]

    def _pull(self, ends: Ends, r: Matrix, pose: Pose, center: Pose) -> Pull:
        """Action on half of the mass, in ground axes."""
        data = {name: ends.vector(*names) for name, names in self._quantities().items()}
        mass = ends.number("length") * 0.5 * ends.number("rhoA")
        data["mass"] = Matrix.vector(ends.graph, [mass])
        data["inertia"] = pose.rotation @ spin(ends, 0.5) @ pose.rotation.T
        return self.field.pull(r, data, lambda x: center.rotation @ x)
