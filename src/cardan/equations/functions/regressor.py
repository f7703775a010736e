"""Regressors: forces and energies as matrices times the inertial parameters.

Forces, kinetic and potential energy are linear in mass, first moments and inertia of every body
about a point fixed to it, in the inertia of rotors and in the coefficients that force elements call
linear. Each column is the force of a unit of one of them, projected on the partial velocities.

Source: Atkeson, An and Hollerbach, Estimation of Inertial Parameters of Manipulator Loads and
Links, Int. J. Robotics Research 5 (1986); Gautier and Khalil, On the Identification of the Inertial
Parameters of Robots, IEEE CDC (1988), for the form of energies.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from ...elements.forces.force import constant
from ...elements.quantity import written_unit
from ...errors import DerivationError
from ...ir.arithmetic import Scalar
from ...ir.function import Output
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.moments import moved, turn_symmetric
from ...topology.internal_states import dotted, slides
from ..constraints.reaction_friction import friction_forces
from ..kinematics.inertia import of_body
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, places, summed
from ..kinematics.partial_velocities import partials
from .base_parameters import ENTRIES
from .context import Context, recipe
from .outputs import system_accelerations

UNITS = ("kg", *("kg*m",) * 3, *("kg*m^2",) * 6)
# rows and columns of the tensor's entries, in the order of ENTRIES
CELLS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


@dataclass(frozen=True)
class Column:
    """Column of one parameter.

    Attributes:
        name, unit: Of the parameter.
        value: The parameter itself, an expression of p.
        force: Generalized force that it takes to move a unit of it (nu, 1).
        kinetic, potential: Energy of a unit.
        power: Of a unit, where it has no potential.
    """

    name: str
    unit: str
    value: int
    force: Matrix
    kinetic: Scalar
    potential: Scalar
    power: Scalar

    @property
    def empty(self) -> bool:
        """True when it does nothing, whatever the motion."""
        scalars = (self.kinetic, self.potential, self.power)
        return self.force.is_zero and all(x.node == ZERO for x in scalars)


class Columns:
    """The columns of a system, with what all of them share.

    Args:
        c: What builders of functions work with.
    """

    def __init__(self, c: Context) -> None:
        self.c, self.k = c, c.k
        c.with_friction_at(c.udot)
        self.acc = system_accelerations(c.d, c.udot)
        self.partials = partials(c.k)

    @cached_property
    def all(self) -> tuple[Column, ...]:
        """Columns of the bodies, then of the force elements that are not zero."""
        columns = [column for i in range(len(self.k.system.bodies)) for column in self._body(i)]
        elements = [column for n in range(len(self.k.system.forces)) for column in self._force(n)]
        return (*columns, *(column for column in elements if not column.empty))

    # bodies

    def _body(self, i: int) -> list[Column]:
        """Ten columns of a body with everything fixed to it, about its own frame and in its axes.

        A unit of mass is pulled along with the origin by f = a; a unit of first moment along e by
        f = U e, and it turns by n = e x a; one of inertia by n = E alpha + omega x E omega.
        """
        k, body = self.k, self.k.system.bodies[i]
        if not body.parts:
            return []
        g = k.graph
        frame = k.system.frames[body.parts[0].frame]
        back, at = k.matrix(3, 3, frame.rotation).T, k.vector(frame.position)
        with g.made_by(k.owner(i), "regressor"):
            omega, alpha = back @ k.omega[i], back @ self.acc.alpha[i]
            a = back @ (self.acc.a[i] + self.acc.gradient[i] @ at)
            v = back @ (k.v[i] + k.omega[i].cross(at))
            up = -(back @ (k.ground_rotation[i].T @ self.c.d.gravity))
            place = k.ground_position[i] + k.ground_rotation[i] @ at
            ways = self._ways(i, back, at)
            none, zero = Matrix.zeros(g, 3), Scalar(g, ZERO)
            units = [
                Matrix.vector(g, [ONE if n == j else ZERO for n in range(3)]) for j in range(3)
            ]
            entries = [(none, a, v.dot(v) * 0.5, -self.c.d.gravity.dot(place))]
            for n, e in enumerate(units):
                convective = alpha.cross(e) + omega.cross(omega.cross(e))
                entries.append((e.cross(a), convective, v.dot(omega.cross(e)), up[n]))
            for row, column in CELLS:
                unit = _unit(units, row, column)
                moment = unit @ alpha + omega.cross(unit @ omega)
                entries.append((moment, none, omega.dot(unit @ omega) * 0.5, zero))
            values = self._values(i, back, at)
            return [
                Column(f"{body.name}.{entry}", unit, value, self._projected(ways, n, f), t, w, zero)
                for entry, unit, value, (n, f, t, w) in zip(
                    ENTRIES, UNITS, values, entries, strict=True
                )
            ]

    def _ways(self, i: int, back: Matrix, at: Matrix) -> dict[int, tuple[Matrix, Matrix]]:
        """Partial velocities of the frame of a body in its axes: speed -> (angular, linear)."""
        partials_of_body = self.partials[i]
        return {
            r: (back @ w, back @ (partials_of_body.linear[r] + w.cross(at)))
            for r, w in partials_of_body.angular.items()
        }

    def _projected(
        self, ways: dict[int, tuple[Matrix, Matrix]], moment: Matrix, force: Matrix
    ) -> Matrix:
        nodes = [ZERO] * self.k.system.nu
        for r, (w, v) in ways.items():
            nodes[r] = (w.dot(moment) + v.dot(force)).node
        return Matrix(self.k.graph, len(nodes), 1, nodes)

    def _values(self, i: int, back: Matrix, at: Matrix) -> tuple[int, ...]:
        """The ten numbers of a body about its own frame."""
        inertia = moved(of_body(self.k, i), -at)
        tensor = turn_symmetric(back, inertia.tensor)
        cells = tuple(tensor[cell].node for cell in CELLS)
        return (inertia.mass.node, *(back @ inertia.moment).nodes, *cells)

    # force elements

    def _force(self, n: int) -> list[Column]:
        """Columns of the linear quantities of an element: the action of a unit of each."""
        k, force = self.k, self.k.system.forces[n]
        at = places(k, force)
        quantities = force.element.quantities()
        linear = [name for name in force.element.linear() if name in at.data]
        linear = [name for name in linear if constant(at.data[name])]
        nothing = {name: Matrix.zeros(k.graph, at.data[name].rows) for name in linear}
        bare = summed(k, (force,), nothing)
        columns = []
        entries = [(name, n) for name in linear for n in range(at.data[name].rows)]
        for name, entry in entries:
            data, quantity = at.data[name], quantities[name]
            one = {name: Matrix.identity(k.graph, data.rows).column(entry)}
            loads = summed(k, (force,), {**nothing, **one})
            force_of, power = self._needed(loads) - self._needed(bare), _power(k, loads, bare)
            full, value, written = dotted(force.name, name), data[entry].node, quantity.unit
            if data.rows > 1:
                full, written = dotted(full, quantity.labels[entry]), quantity.units[entry]
            unit = self._unit_of(n, written)
            kinetic, potential = self._rotating(loads), loads.potential - bare.potential
            columns.append(Column(full, unit, value, force_of, kinetic, potential, power))
        return columns

    def _unit_of(self, n: int, written: str) -> str:
        """Unit of a quantity that has one for rotation and another for translation."""
        system = self.k.system
        return written_unit(written, slides(system.joints, system.forces[n].joints.values()))

    def _needed(self, loads: Loads) -> Matrix:
        """Generalized force to be applied against loads, and to accelerate rotors (nu, 1)."""
        k, g = self.k, self.k.graph
        nodes = [ZERO] * k.system.nu
        for i, (moment, force) in loads.wrenches.items():
            partials_of_body = self.partials[i]
            for r, w in partials_of_body.angular.items():
                nodes[r] = g.sub(
                    nodes[r], (w.dot(moment) + partials_of_body.linear[r].dot(force)).node
                )
        for i, force in loads.joints.items():
            for r, way in k.partials_of(k.speeds[i]).items():
                nodes[r] = g.sub(nodes[r], way.dot(force).node)
        for i, rotor in loads.rotors.items():
            ways = k.partials_of(k.speeds[i])
            rate = k.derivative(k.speeds[i])
            for r, way in ways.items():
                rate = rate + way * self.c.udot[r]
            for r, way in ways.items():
                nodes[r] = g.add(nodes[r], way.dot(rotor @ rate).node)
        return Matrix(g, len(nodes), 1, nodes)

    def _rotating(self, loads: Loads) -> Scalar:
        """Kinetic energy of rotors."""
        total = Scalar(self.k.graph, ZERO)
        for i, rotor in loads.rotors.items():
            total = total + self.k.u(i).dot(rotor @ self.k.u(i)) * 0.5
        return total


def _unit(units: Sequence[Matrix], row: int, column: int) -> Matrix:
    """The symmetric matrix with 1 at an entry and its mirror image."""
    outer = units[row].outer(units[column])
    return outer if row == column else outer + outer.T


def _power(k: Kinematics, loads: Loads, bare: Loads) -> Scalar:
    total = Scalar(k.graph, ZERO)
    for sign, some_loads in ((1, loads), (-1, bare)):
        for _, value in some_loads.power:
            total = total + value * sign
    return total


@recipe
def regressor(c: Context) -> tuple[Output, ...]:
    """Y (nu, n) with tau = Y phi + what does not depend on phi."""
    columns = Columns(c).all
    names = tuple(f"{speed},{column.name}" for speed in c.names["u"] for column in columns)
    nodes = tuple(column.force.nodes[r] for r in range(c.k.system.nu) for column in columns)
    return (Output("Y", (c.k.system.nu, len(columns)), nodes, names),)


@recipe
def energy_regressor(c: Context) -> tuple[Output, ...]:
    """Rows (3, n): kinetic energy, potential energy, power without a potential; times phi.

    Raises:
        DerivationError: something moves by itself; what it takes is not among tau. Or the friction
            of a joint follows from its reaction, and so from accelerations.
    """
    friction = friction_forces(c.k.system)
    if friction:
        raise DerivationError(
            f"energy_regressor: the friction of '{friction[0].name}' follows from reactions, whose "
            "power depends on all accelerations; use the regressor of forces"
        )
    moving = [joint.name for joint in c.k.system.joints if joint.motion is not None]
    if moving or (c.k.system.closed and not c.d.constraints.prescribed.is_zero):
        which = f"joint '{moving[0]}' is" if moving else "constraints are"
        raise DerivationError(
            f"energy_regressor: {which} moved by time or inputs, whose power depends on all "
            "accelerations; use the regressor of forces"
        )
    columns = Columns(c).all
    rows = ("kinetic", "potential", "power")
    names = tuple(f"{row},{column.name}" for row in rows for column in columns)
    nodes = tuple(getattr(column, row).node for row in rows for column in columns)
    return (Output("E", (len(rows), len(columns)), nodes, names),)


@recipe
def inertial_parameters(c: Context) -> tuple[Output, ...]:
    """phi (n,): what forces and energies are linear in, as functions of the parameters."""
    columns = Columns(c).all
    names, units = (tuple(getattr(x, word) for x in columns) for word in ("name", "unit"))
    return (Output("phi", (len(columns),), tuple(x.value for x in columns), names, units),)
