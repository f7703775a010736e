"""The joints of a model in absolute coordinates at one instant: nodes and beams go with them.

What searches for a start change are the coordinates of the joints of the tree, as in joint
coordinates: nodes stand where these carry them, and beams follow as if they were rigid. So the same
search finds the same position in every kind of coordinates.
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...runtime.models.constraint_projection import Closing
from ...runtime.models.finite_elements.assembled import Assembled
from ...runtime.models.finite_elements.elements import State
from ...runtime.models.finite_elements.frames import rotation_vectors
from ...runtime.models.finite_elements.joint_driven_nodes import Carrier, leading
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.random_states import random_state
from ...runtime.verification.rotations import unit
from ...schema.entries import MultiplierRow
from ...schema.manifest import Manifest
from ...schema.mechanism import JointRow
from ...schema.records import PositionRecord
from .loop_jacobian import Structure, along_joints, probe, start_key, structure, tree_rows
from .mechanism import Mechanism
from .mechanism_record import Connection, called, searching

# units of rows in the manifest, and those of multipliers as joint coordinates have them
FORCES = {"m": "N", "m/s": "N", "rad": "N*m", "rad/s": "N*m"}
NEARBY = 1e-6  # of a central difference of what beams miss


class NodalMechanism(Mechanism):
    """A model in absolute coordinates whose joints alone are moved.

    Args:
        model, t, r: As :class:`.mechanism.Mechanism` takes them.
        kept: Names of coordinates and speeds of nodes that stay what they are.
        q: Coordinates (nq,) at which these are; the default ones if None.

    Attributes:
        lead: Entries of u that are speeds of joints of the tree (n,): steps are along these.
        linked: Whether beams between two bodies that joints carry have to fit without strain.
        nodes_named: Whether coordinates of nodes that joints carry are asked for.
    """

    linked = True
    nodes_named = False

    def __init__(
        self,
        model: LoadedModel,
        t: float = 0.0,
        r: object = None,
        fixed: Collection[str] = (),
        q: Array | None = None,
    ) -> None:
        super().__init__(model, t, r)
        # where searches begin that are drawn: what is kept stays in these too
        self._start = model._layout.start("q").copy()
        if q is not None and fixed:
            stays = [k for k, name in enumerate(model.coordinates) if name in set(fixed)]
            self._start[stays] = q[stays]
        self._every: tuple[MultiplierRow, ...] = tuple(model.manifest.multipliers)
        self.lead = np.flatnonzero(leading(model))
        self.columns = self.columns[self.lead]
        self.carrier = Carrier(model, self._stays(set(fixed)), self.t, self.r)
        if self.carrier.tables.beams:
            # every search carries all beams along
            self.searches = 2
        self._z = model._layout.start("z")
        self._last: tuple[tuple[bytes, bytes], Array] | None = None

    def _stays(self, fixed: set[str]) -> NDArray[np.bool_]:
        """Mask of the coordinates and speeds (nq + nu,) of joints, and of those named."""
        layout, nq = self.model._layout, self.model.nq
        stays = np.zeros(nq + self.model.nu, dtype=bool)
        stays[nq + self.lead] = True
        slots, first = layout.joint_slots["q"], layout.joint_slots["u"][:, 0]
        for start, count in slots[np.isin(first, self.lead)].tolist():
            stays[start : start + count] = True
        if fixed:
            names = (*self.model.coordinates, *self.model.speeds)
            stays |= np.array([name in fixed for name in names], dtype=bool)
        return stays

    # what closes

    @cached_property
    def _closes(self) -> Structure:
        """What closes loops: the same at almost all positions, and in all starts alike."""

        def make() -> Structure:
            return structure(self, self.advance(self.carry(self._start), probe(self.nu)))

        closes: Structure = self._results.once(start_key(self), make)
        return closes

    @property
    def _rows(self) -> NDArray[np.intp]:
        """Rows of the model that joints alone do not fulfill: those of what closes loops."""
        return self._closes.rows

    @property
    def _steps(self) -> NDArray[np.intp]:
        """Steps that what closes loops depends on: those of the joints of loops."""
        return self._closes.steps

    def _gradient(self, q: Array) -> Any:
        """G of all rows of the model (m, nu), sparse."""
        return self._results.mesh.tangent(self._at(q), ("G",))["G"]

    @cached_property
    def _results(self) -> Any:
        source = self.model._source
        assert isinstance(source, Assembled)
        return source.results(self.model)

    def _at(self, q: Array) -> State:
        layout, still = self.model._layout, np.zeros(self.model.nu)
        r = layout.start("r") if self.r is None else self.r
        lam = np.zeros(len(self._every))
        return State(q, still, still, lam, self.t, r, self._z, layout.start("s"))

    @cached_property
    def closing(self) -> Closing:
        """Same as :attr:`Mechanism.closing`, less what holds wherever joints stand."""
        rows = (self._every[k] for k in self._rows)
        with_units = (row.replaced(unit=FORCES.get(row.unit, row.unit)) for row in rows)
        return Closing(tuple(with_units), self.size)

    def _evaluated(self, name: str, *values: Array) -> Array:
        return super().evaluate(name, *values)

    def evaluate(self, name: str, *values: Any, more: tuple[object, ...] = ()) -> Array:
        """Same as :meth:`Mechanism.evaluate`; of constraints those that joints do not fulfill."""
        result = super().evaluate(name, *values, more=more)
        if name in ("constraints", "constraint_rates"):
            result = result[self._rows[self._rows < len(result)]]
        return result

    def residuals(self, q: Array) -> Array:
        """Same as :meth:`Mechanism.residuals`, and what beams between two carried bodies miss."""
        return np.concatenate([super().residuals(q), self._missed(q)])

    def _jacobian(self, q: Array) -> Array:
        """Same as :meth:`Mechanism.jacobian`, along speeds of joints."""
        G = self._loop_jacobian(q) / self.rows[:, None]
        count = self.closing.positions
        G = np.concatenate([G[:count], self._missed_jacobian(q), G[count:]])
        return G[self._required]

    def _loop_jacobian(self, q: Array) -> Array:
        """What closes loops along speeds of joints (m, n), in units of lengths and angles."""
        rows, steps = self._rows, self._steps
        result = np.zeros((len(rows), self.nu))
        if not len(rows):
            return result
        G = self._gradient(q)
        along = along_joints(self, G, rows, self._tree_rows)
        if along is not None:
            return along * self.columns
        T = self._moving(q, steps)
        result[:, steps] = G[rows] @ (T[1:] - T[0]).T
        return result

    _tree_rows = cached_property(lambda self: tree_rows(self, self._rows))

    @property
    def _required(self) -> NDArray[np.bool_]:
        rows, count = self._unreleased, self.closing.positions
        links = np.ones(6 * len(self.links), dtype=bool)
        return np.concatenate([rows[:count], links, rows[count:]])

    @property
    def positions(self) -> int:
        """Same as :attr:`Mechanism.positions`."""
        count = self.closing.positions
        return int(self._unreleased[:count].sum()) + 6 * len(self.links)

    def reversed_axis(self, q: Array) -> str:
        """Same as :meth:`Mechanism.reversed_axis`."""
        return self.carrier.reversed_axis(q)

    @cached_property
    def connection(self) -> Connection:
        """Same as :attr:`Mechanism.connection`: everything goes with the joints."""
        nq, nu, rows = self.model.nq, self.nu, self.positions
        record = PositionRecord(nq=nq, nu=nu, positions=rows, hard_count=rows)
        functions = {
            "constraints": called(self.residuals, rows, q=nq),
            "constraint_jacobian": called(lambda q: self.jacobian(q)[:rows], rows * nu, q=nq),
            "integrate": called(self.advance, nq, q=nq, du=nu),
            "kinematics": called(self.kinematics, nq * nu, q=nq),
        }
        for name, function in functions.items():
            setattr(record, name, function.address)
        library = searching(self.model._kernels())
        return Connection(library, record, [functions], rows, called_back=True)

    # motion

    @property
    def nu(self) -> int:
        """Number of steps."""
        return len(self.lead)

    def carry(self, q: Array) -> Array:
        """Coordinates (nq,) with nodes where the joints among them carry these."""
        return self.carrier.node_positions(q)

    def state(self, q: Array, u: Array) -> tuple[Array, Array]:
        """Coordinates and speeds of everything, by those of joints among q (nq,) and u (nu,)."""
        return self.model.split(self.carrier.at(np.concatenate([q, u, self._z])))

    def along(self, q: Array) -> Array:
        """Speeds (n + 1, nu) of everything: with joints at rest, then by each step."""
        return self._moving(q, np.arange(self.nu))

    def _moving(self, q: Array, steps: NDArray[np.intp]) -> Array:
        """Speeds of everything: with joints at rest, then by some of the steps."""
        key = q.tobytes(), steps.tobytes()
        if self._last is None or self._last[0] != key:
            self._last = key, self.carrier.moving(q, self._unit_steps(steps))
        return self._last[1]

    def _unit_steps(self, steps: NDArray[np.intp]) -> Array:
        """Speeds (k + 1, nu) of joints: none, then those of each step."""
        speeds = np.zeros((len(steps) + 1, self.model.nu))
        speeds[np.arange(1, len(steps) + 1), self.lead[steps]] = self.columns[steps]
        return speeds

    def _along(self, step: Array) -> Array:
        u = np.zeros(self.model.nu)
        u[self.lead] = step * self.columns
        return u

    def advance(self, q: Array, step: Array) -> Array:
        """Same as :meth:`Mechanism.advance`; nodes go along."""
        moved = np.asarray(self.model.integrate(q, self._along(step)), dtype=np.float64)
        return self.carry(unit(moved, self.model.manifest.quaternions))

    def drawn(self, rng: np.random.Generator) -> Array:
        """Same as :meth:`Mechanism.drawn`: the same joints are drawn in any kind of coordinates."""
        q = self._start.copy()
        q[self.led] = random_state(self._tree, rng)[: len(self.led)]
        return q

    @cached_property
    def led(self) -> NDArray[np.intp]:
        """Same as :attr:`Mechanism.led`: joints of the tree."""
        places = [np.arange(row.slot("q")[0], sum(row.slot("q"))) for row in self._joints]
        return np.concatenate([np.zeros(0, dtype=np.intp), *places])

    @cached_property
    def _tree(self) -> Manifest:
        """Manifest of the tree of the joints that are moved."""
        manifest = self.model.manifest
        at = {int(k): n for n, k in enumerate(self.led)}
        slots = [row.slot("q") for row in self._joints]
        return manifest.replaced(
            coordinates=[manifest.coordinates[int(k)] for k in self.led],
            speeds=[manifest.speeds[int(k)] for k in self.lead],
            joints=[
                row.replaced(q=(at[start], size))
                for row, (start, size) in zip(self._joints, slots, strict=True)
            ],
            z=[],
            quaternions=[],
            scene=manifest.scene.replaced(rotations=[row.rotation for row in self._joints]),
        )

    def difference(self, q0: Array, q1: Array) -> Array:
        """Same as :meth:`Mechanism.difference`:

        the shortest step along which joints change so, to first order.
        """
        shortest, *_ = np.linalg.lstsq(
            self.kinematics(q0)[self.led], (q1 - q0)[self.led], rcond=None
        )
        return np.asarray(shortest)

    @property
    def chosen(self) -> bool:
        """Speeds are those of joints."""
        return False

    def _kinematics(self, q: Array) -> Array:
        """Same as :meth:`Mechanism._kinematics`."""
        rates = self._results.mesh.rates
        if self.nodes_named:
            T = self.along(q)
            return np.stack([rates(q, row) - rates(q, T[0]) for row in T[1:]], axis=-1)
        # coordinates of a joint change by its own speeds alone: all joints at once
        N = np.zeros((len(q), self.nu))
        slots = [(row.slot("q"), row.slot("u")) for row in self._joints]
        steps = np.cumsum([0, *(count for _, (_, count) in slots)])
        for k in range(max((count for _, (_, count) in slots), default=0)):
            u = np.zeros(self.model.nu)
            chosen = [n for n, (_, (_, count)) in enumerate(slots) if k < count]
            for n in chosen:
                u[slots[n][1][0] + k] = self.columns[steps[n] + k]
            qdot = rates(q, u)
            for n in chosen:
                start, size = slots[n][0]
                N[start : start + size, steps[n] + k] = qdot[start : start + size]
        return N

    @cached_property
    def _joints(self) -> list[JointRow]:
        """Rows of the manifest of the joints that are moved."""
        moved = frozenset(self.lead.tolist())
        rows = self.model.manifest.joints
        return [row for row in rows if row.u and row.u[1] and row.u[0] in moved]

    def frame_jacobian(self, frame: str, q: Array) -> Array:
        """Same as :meth:`Mechanism.frame_jacobian`."""
        J = self.model.frame_jacobian(frame, q, t=self.t, r=self.r)
        T = self.along(q)
        return np.asarray(J @ (T[1:] - T[0]).T)

    def steps_of(self, u: Array) -> Array:
        """Same as :meth:`Mechanism.steps_of`."""
        return np.asarray(u[self.lead] / self.columns)

    def speeds_at(self, q: Array, steps: Array) -> Array:
        """Same as :meth:`Mechanism.speeds_at`: nodes move with the joints."""
        return self.state(q, self._along(steps))[1]

    def locked_speeds(
        self, q: Array, chosen: NDArray[np.intp], values: Array
    ) -> tuple[NDArray[np.intp], Array, Array]:
        """Same as :meth:`Mechanism.locked_speeds`: speeds of nodes follow from those of joints."""
        at = {int(k): n for n, k in enumerate(self.lead)}
        of_joints = np.array([int(k) in at for k in chosen], dtype=bool)
        locked = np.array([at[int(k)] for k in chosen[of_joints]], dtype=np.intp)
        if of_joints.all():
            return locked, np.zeros((0, self.nu)), np.zeros(0)
        T, of_nodes = self.along(q), chosen[~of_joints]
        return locked, (T[1:] - T[0]).T[of_nodes], values[~of_joints] - T[0][of_nodes]

    def mass(self, q: Array) -> Array | None:
        """Same as :meth:`Mechanism.mass`."""
        T = self.along(q)
        moves = T[1:] - T[0]
        return np.asarray(moves @ (self._results.mesh.tangent(self._at(q), ("M",))["M"] @ moves.T))

    # beams between two bodies that joints carry

    @cached_property
    def links(self) -> list[tuple[int, int]]:
        """Ends of lines of beams both of which joints carry; GROUND for the ground."""
        return self.carrier.links if self.linked else []

    def _missed(self, q: Array) -> Array:
        """By which rotation and way, without units, beams that are rigid would miss (6 k,)."""
        parts, still = [], np.zeros(self.model.nu)
        for one, other in self.links:
            a, b, home = self.carrier.displaced(q, still, one, other)
            turn = rotation_vectors((b.turn * a.turn.inv()).as_matrix())
            parts += [turn, (b.at(home) - a.at(home)) / self.size]
        return np.concatenate([np.zeros(0), *parts])

    def rates(self, q: Array, u: Array) -> Array:
        """Same as :meth:`Mechanism.rates`, and those of what rigid beams would miss."""
        parts, rates, count = [], super().rates(q, u), self.closing.positions
        for one, other in self.links:
            a, b, home = self.carrier.displaced(q, u, one, other)
            parts += [b.omega - a.omega, (b.velocity_at(home) - a.velocity_at(home)) / self.size]
        return np.concatenate([rates[:count], *parts, rates[count:]])

    def _missed_jacobian(self, q: Array) -> Array:
        if not self.links or not self.nu:
            return np.zeros((6 * len(self.links), self.nu))
        steps = NEARBY * np.eye(self.nu)
        sides = [[self._missed(self.advance(q, sign * step)) for step in steps] for sign in (1, -1)]
        change = np.array(sides[0]) - np.array(sides[1])
        # where joints have no freedom, there is a row for every miss all the same
        return change.reshape(self.nu, 6 * len(self.links)).T / (2 * NEARBY)

    def unlinked(self) -> NodalMechanism:
        """The same mechanism where beams between two carried bodies may be strained."""
        other = self.without(self.released)
        assert isinstance(other, NodalMechanism)
        other.linked = False
        other.__dict__.pop("links", None)
        return other
