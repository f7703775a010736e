"""The contract of a model in absolute coordinates: large, sparse, by the tables of its elements."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from ...arrays import Array
from ...errors import ModelError
from ...runtime.models.finite_elements.elements import Elements, State
from ...runtime.models.finite_elements.frames import increments_from
from ...runtime.models.finite_elements.joint_driven_nodes import leading
from ...runtime.models.finite_elements.tables import Table, Tables
from ...runtime.models.initial import start_of
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.verification.rotations import unit
from ...schema.blocks import of_rate
from ..mechanisms.consistent_rates import read
from ..simulation.settings import blocks, start
from ..simulation.starts.finite_element_start import meshed_start, start_of_search
from .carried_beams import TreeEnds
from .central_differences import by_differences
from .compiled_system import CompiledSystem
from .dynamic_system import Internal, Moment, OutputJacobians, Parameters, Rates, Tangents
from .rotating_frame import CorotatingMotion
from .saddle_point import Dense, Matrix, Saddle, Sparse, split
from .sparse_saddle_point import SparseSaddle
from .strained_elements import load_forces, load_tangent, refuse_mixed_forces, strain_energy

Longs = NDArray[np.intp]
LATEST = 3  # other sets of parameters that a step of a path needs
REACH = 3.0  # radians or sizes: slender structures turn far in one step
OPEN = 1e-9  # of speeds: constraints of speeds that hold


@final
class FiniteElementSystem(CompiledSystem):
    """A model in finite-element coordinates as a :class:`.dynamic_system.DynamicSystem`.

    Attributes:
        model: The model.

    The rest is described in :class:`.dynamic_system.DynamicSystem`.
    """

    def __init__(self, model: LoadedModel, strain: bool = False) -> None:
        """Args:
        model, strain: Compiled in absolute coordinates; for forces of strains alone.
        """
        self._meshes: dict[Any, Elements] = {}
        self.model = model
        self.tables = self._mesh(None).tables
        super().__init__(model, self.tables.mp, _extent(model, self.tables), strain)
        if strain:
            refuse_mixed_forces(self.tables)
        rows = model.manifest.multipliers
        self.rows = np.array([1.0 if row.unit == "rad" else self.size for row in rows])
        self.reach = REACH
        blockwise = SparseSaddle.of(self.tables)
        self.saddle: Saddle = Sparse(blockwise, blockwise.counted)

    def _mesh(self, parameters: Parameters) -> Elements:
        """The elements with values of parameters; those of the model and the last ones stay."""
        key = tuple(sorted((parameters or {}).items()))
        if key not in self._meshes:
            model = self.model.with_parameters(dict(parameters)) if parameters else self.model
            keys = [*self._meshes]
            meshes = {k: self._meshes[k] for k in (*keys[:1], *keys[-LATEST:])}
            mesh: Elements = model._source.results(model).mesh  # type: ignore[attr-defined]
            self._meshes = {**meshes, key: mesh}
        return self._meshes[key]

    def _elements_and_state(self, at: Moment) -> tuple[Elements, State]:
        state = State(at.q, at.u, at.udot, at.lam, at.t, at.r, at.z if len(at.z) else None, at.s)
        if len(at.inner):
            state = replace(state, inner=at.inner, du=np.zeros(len(at.u)))
        return self._mesh(at.parameters), state

    def start(
        self, t: float, q: object, r: Array, locked: Mapping[str, object], p: Parameters
    ) -> Moment:
        """Same as :meth:`DynamicSystem.start`; the search closes what stays open."""
        model, x = self.start_state(q, locked, p)
        # where this way of closing fails Newton's method has forces to find one
        with suppress(ModelError):
            x = start_of_search(model, x, q, locked, t, r)
        place, _, internal = model.parts_of(x)
        internal = internal[: len(self.internals)]
        still, lam = np.zeros(model.nu), np.zeros(len(self.multipliers))
        return Moment(t, place, still, still, lam, r, internal, self.modes, p)

    def state(
        self, x0: object, q: object, u: object, z: object, t: float, r: Array, p: Parameters
    ) -> Moment:
        """Same as :meth:`DynamicSystem.state`."""
        model = self.model.with_parameters(dict(p)) if p else self.model
        begin = start(model, x0, q, u, z)
        x = meshed_start(model, begin.x, *blocks(x0, q, u), t, r)
        place, speed, internal = model.parts_of(x)
        lam = np.zeros(len(self.multipliers))
        return Moment(t, place, speed, 0 * speed, lam, r, internal, self.modes, p)

    @cached_property
    def leading(self) -> NDArray[np.bool_]:
        """See :class:`DynamicSystem`."""
        return leading(self.model)

    @cached_property
    def _corotating_motion(self) -> CorotatingMotion:
        names = [row.name for row in self.model.manifest.beams]
        sizes = self.columns, self.rows, self.size
        ends = TreeEnds.of(self.model, self.tables)
        return CorotatingMotion(self.tables, names, self.leading, *sizes, ends)

    def steady_state(self, at: Moment, named: Mapping[str, object]) -> Moment:
        """Same as :meth:`DynamicSystem.steady_state`:

        beams go along rigidly with what carries them.

        Raises:
            ModelError: as there; beams about different axes.
        """
        moment, open_by = self._moving(at, named)
        largest = float(np.abs(moment.u / self.columns).max(initial=0.0))
        said = ", ".join(f"'{name}'" for name in named) or "prescribed motions"
        if np.abs(open_by).max(initial=0.0) > OPEN * max(1.0, largest):
            rows, where = np.abs(open_by[: len(self.rows)]), "a beam would be strained"
            if rows.max(initial=0.0) > OPEN * max(1.0, largest):
                joint = self.model.manifest.multipliers[int(rows.argmax())].joint
                where = f"joint '{joint}' would come apart"
            gap = np.abs(open_by).max()
            raise ModelError(
                f"speeds of {said} are inconsistent: {where} at {gap:.3g}. Leave one of them out"
            )
        separated = self._corotating_motion.relative_motion(at.q, moment.u)
        if separated:
            raise ModelError(
                f"u= ({said}): beams '{separated[0]}' and '{separated[1]}' do not turn together: "
                "no observer sees both at rest, this is not a steady motion. Simulate it"
            )
        return moment

    def _moving(self, at: Moment, named: Mapping[str, object]) -> tuple[Moment, Array]:
        """The moment with its speeds and their rates, and what stays open."""
        mesh, state = self._elements_and_state(replace(at, u=np.zeros(self.model.nu)))
        drift, G = mesh.balance(state)[2], self.tangents(at).G
        u, open_by = self._corotating_motion.speeds(at.q, G, drift, *read("u", self.model, named))
        moving = replace(at, u=u)
        return replace(moving, udot=self._steady(moving, G)), open_by

    def steady(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.steady`."""
        return self._steady(at, self.tangents(at).G) if np.any(at.u) else np.zeros(self.model.nu)

    def _steady(self, at: Moment, G: object) -> Array:
        mesh, state = self._elements_and_state(at)
        return self._corotating_motion.rates(at.q, at.u, G, mesh.gamma(state))

    def steady_state_tangent(self, at: Moment, named: Mapping[str, object]) -> tuple[Any, Any]:
        """Same as :meth:`DynamicSystem.steady_state_tangent`."""
        if self._corotating_motion.shares_one_twist(at.q, at.u):
            return self._corotating_motion.tangents(at.q, at.u, at.udot)

        def moving(there: Moment) -> Array:
            moment = self._moving(there, named)[0]
            return np.concatenate([moment.u, moment.udot])

        both = self._differences(at, "q", moving)
        return csr_array(both[: self.model.nu]), csr_array(both[self.model.nu :])

    def advance_steady(self, at: Moment) -> Moment | None:
        """Same as :meth:`DynamicSystem.advance_steady`."""
        further = self._corotating_motion.steady_step(at.q, at.u, at.udot)
        if further is None:
            return None
        steps, u, udot, after = further
        return replace(at, t=at.t + after, q=self.integrate(at.q, steps), u=u, udot=udot)

    def uniform(self, at: Moment) -> bool:
        """Same as :meth:`DynamicSystem.uniform`: all turn together, and an observer with them."""
        return bool(self.tables.beams) and self._corotating_motion.shares_one_twist(at.q, at.u)

    def observer(self, at: Moment) -> tuple[Any, Any]:
        """Same as :meth:`DynamicSystem.observer`: he turns along with the beams."""
        return self._corotating_motion.observer(at.q, at.u)

    def balance(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.balance`."""
        mesh, state = self._elements_and_state(at)
        force, *gaps = mesh.mixed_balance(state) if len(at.inner) else mesh.balance(state)
        if self.strain:
            force = force - load_forces(mesh, state)
        return np.concatenate([force, *gaps])

    def tangents(self, at: Moment) -> Tangents:
        """Same as :meth:`DynamicSystem.tangents`."""
        return Tangents(*self._matrices(at, "KCMRG"))

    def stiffness(self, at: Moment) -> tuple[Matrix, Matrix]:
        """Same as :meth:`DynamicSystem.stiffness`."""
        K, G = self._matrices(at, "KG")
        return K, G

    def _matrices(self, at: Moment, names: str) -> list[csr_array]:
        """Some of the tangents by name."""
        mesh, state = self._elements_and_state(at)
        blocks = (mesh.mixed_tangent if len(at.inner) else mesh.tangent)(state, tuple(names))
        if self.strain:
            blocks = {**blocks, "K": blocks["K"] - load_tangent(mesh, state)}
        return [csr_array(blocks[name]) for name in names]

    def loads(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.loads`: not of joints, beams and springs."""
        loads: Array = Elements.loads(*self._elements_and_state(at)) * self.columns
        return 0 * loads if self.strain else loads

    def strain_energy(self, at: Moment) -> float:
        """Same as :meth:`DynamicSystem.strain_energy`."""
        return strain_energy(*self._elements_and_state(at))

    def sizes(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.sizes`: of nodes the distance from the origin."""
        return self.tables.distances(at.q, self.columns)

    def internal_rates(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.internal_rates`: element by element."""
        rates = np.zeros(self.model.nz)
        if len(rates):
            mesh, state = self._elements_and_state(at)
            for group, values in zip(self._with_states, mesh.results("zdot", state), strict=True):
                rates[group.z] = values
        return rates

    @cached_property
    def _with_states(self) -> list[Table]:
        """Elements with internal states."""
        return [g for g in self.tables.groups if "zdot" in g.kind.functions]

    def internal(self, at: Moment) -> Internal:
        """Same as :meth:`DynamicSystem.internal`, by central differences."""
        nu = self.model.nu

        def forces(x: Moment) -> Array:
            return self.balance(x)[:nu]

        along, by_u = np.zeros((2, self.model.nz, nu))
        columns = np.unique(
            np.concatenate([self.tables.columns(g).ravel() for g in self._with_states])
        )
        along[:, columns] = self._differences(at, "q", self.internal_rates, columns)
        by_u[:, columns] = self._differences(at, "u", self.internal_rates, columns)
        by_z = self._differences(at, "z", self.internal_rates)
        return Internal(self._differences(at, "z", forces), along, by_u, by_z)

    def accelerations(self, at: Moment, tau: Array | None = None) -> Moment:
        """Same as :meth:`DynamicSystem.accelerations`."""
        mesh, state = self._elements_and_state(at)
        udot, lam = mesh.accelerations(state, tau)
        return replace(at, udot=udot, lam=lam)

    def rates(self, at: Moment, tau: Array | None = None) -> Rates:
        """Same as :meth:`DynamicSystem.rates`: by tangents, exact at rest.

        In motion what constraints say of accelerations is differentiated by central differences,
        along what they hold.
        """
        there = self.accelerations(at, tau)
        tangents, nu = self.tangents(there), self.model.nu
        M = tangents.M.toarray() * self.columns * self.columns[:, None]
        G = tangents.G.toarray() * self.columns / self.rows[:, None]
        parts = []
        for block, matrix in (("q", tangents.K), ("u", tangents.C)):
            bent = np.zeros((len(self.rows), nu))
            if np.any(at.u) or np.any(there.udot):
                bent[:, self._beam_speeds] = self._differences(
                    there, block, self._bent, self._beam_speeds
                )
            # Dense.solve judges the rank of G by b, the gap of constraints. Here b is a derivative
            # and not a gap: its particular solution goes to the right side, and b is 0
            U, s, _, V = split(G)
            particular = -V @ (U.T @ (bent / self.rows[:, None]) / s[:, None])
            right = -matrix.toarray() * self.columns[:, None] - M @ particular
            parts.append(particular + Dense().solve(M, G, right, 0 * bent)[0])
        along, by_u = (part * self.columns[:, None] for part in parts)
        by_r, by_z = (
            self._differences(at, block, lambda x: self.accelerations(x, tau).udot)
            for block in "rz"
        )
        if not self.model.nz:
            return Rates(along, by_u, by_z, by_r)
        inner = self.internal(at)
        inner_by_r = self._differences(at, "r", self.internal_rates)
        return Rates(
            np.concatenate([along, inner.along]),
            np.concatenate([by_u, inner.by_u]),
            np.concatenate([by_z, inner.by_z]),
            np.concatenate([by_r, inner_by_r]),
        )

    @cached_property
    def _beam_speeds(self) -> Longs:
        """Speeds of what constraints hold."""
        columns = [self.tables.columns(g).ravel() for g in self.tables.groups if g.kind.m]
        return np.unique(np.concatenate(columns)) if columns else np.zeros(0, dtype=np.intp)

    def _bent(self, at: Moment) -> Array:
        """G udot - gamma (m,)."""
        mesh, state = self._elements_and_state(at)
        # G udot by the rates that constraints have with these speeds: nothing is assembled
        moved, still = (replace(state, u=u) for u in (at.udot, 0 * at.udot))
        rates = mesh.balance(moved)[2] - mesh.balance(still)[2]
        return np.asarray(rates - mesh.gamma(state))

    def output_jacobians(self, at: Moment) -> OutputJacobians:
        """Same as :meth:`DynamicSystem.output_jacobians`, by central differences."""

        def outputs(x: Moment) -> Array:
            values: Array = self.model.outputs(
                x.q, x.u, r=x.r, z=x.z, s=x.s, t=x.t, parameters=x.parameters
            )
            return values

        return OutputJacobians(*(self._differences(at, block, outputs) for block in "quzr"))

    def _differences(
        self,
        at: Moment,
        block: str,
        function: Callable[[Moment], Array],
        along: Longs | None = None,
    ) -> Array:
        """Derivative (k, n) of a function by a block, along increments for q; along some of it."""
        moved: dict[str, Callable[[Array], Moment]] = {
            "q": lambda step: replace(at, q=self.integrate(at.q, step)),
            "u": lambda step: replace(at, u=at.u + step),
            "z": lambda step: replace(at, z=at.z + step),
            "r": lambda step: replace(at, r=at.r + step),
        }
        # inputs and internal states in parts of their own size, motions in those of the system
        sizes = {"z": at.z, "r": at.r}
        units = np.maximum(1.0, np.abs(sizes[block])) if block in sizes else self.columns
        return by_differences(lambda step: function(moved[block](step)), units, along)

    # coordinates

    @cached_property
    def increments(self) -> tuple[str, ...]:
        """See :class:`DynamicSystem`."""
        rotational = set(self.tables.rotational_speeds.ravel().tolist())
        names = []
        for k, name in enumerate(self.speeds):
            coordinate = of_rate(name)
            same = coordinate in self.coordinates and k not in rotational
            names.append(coordinate if same else f"along {name}")
        return tuple(names)

    def kinematic_matrix(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.kinematic_matrix`."""
        mesh = self._mesh(at.parameters)
        basis = np.eye(self.model.nu)
        return np.stack([mesh.rates(at.q, row) for row in basis], axis=1)

    def with_internal_unknowns(self, at: Moment) -> Moment:
        """Same as :meth:`DynamicSystem.with_internal_unknowns`: the stress of beams."""
        mesh, state = self._elements_and_state(at)
        return replace(at, inner=mesh.settled(state))

    def retract(self, at: Moment, du: Array) -> Moment:
        """Same as :meth:`DynamicSystem.retract`."""
        inner = at.inner
        if len(inner):
            mesh, state = self._elements_and_state(at)
            inner = mesh.stepped(replace(state, du=du))
        return replace(at, q=self.integrate(at.q, du) if np.any(du) else at.q, inner=inner)

    def integrate(self, q: Array, du: Array) -> Array:
        """Same as :meth:`DynamicSystem.integrate`."""
        moved: Array = unit(self._mesh(None).move(q, du), self.model.manifest.quaternions)
        return moved

    def difference(self, q0: Array, q: Array) -> Array:
        """Same as :meth:`DynamicSystem.difference`, by Newton's method without quaternions."""
        return increments_from(self.tables, q0, q)


def _extent(model: LoadedModel, tables: Tables) -> float:
    """The largest distance of a node from their middle, at first [m]; 1 without any."""
    q = model.split(start_of(model, {}, {})[0])[0]
    nodes = [k for k, kind in enumerate(tables.kind) if tables.kinds[kind].node]
    positions = np.array([tables.pose(q, k)[4:] for k in nodes] or np.zeros((1, 3)))
    size = float(np.linalg.norm(positions - positions.mean(axis=0), axis=1).max())
    return 2 * size or 1.0
