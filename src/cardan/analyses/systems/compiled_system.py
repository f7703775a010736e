"""Names, units and named values shared by the systems of compiled models."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, near
from ...runtime.models.initial import missing, start_of
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.named_rotations import component
from .dynamic_system import Moment, Parameters


class CompiledSystem(ABC):
    """A compiled model with the names that analyses ask for.

    Attributes:
        model: The model.
        strain: True where forces are those of strains and constraints alone: no loads, weights,
            masses, internal states and events.

    The rest is described in :class:`cardan.analyses.systems.dynamic_system.DynamicSystem`.
    """

    def __init__(self, model: LoadedModel, positions: int, size: float, strain: bool) -> None:
        """Args:
        model: Compiled.
        positions: Number of constraints of positions, which come first.
        size: Length against which displacements count [m].
        strain: As the attribute.
        """
        self.strain = strain
        manifest = model.manifest
        self.model, self.name, self.size = model, model.name, size
        self.coordinates, self.speeds = model.coordinates, model.speeds
        self.internals, self.inputs = () if strain else model.internals, model.inputs
        rows = manifest.multipliers
        self.multipliers = tuple(str(row.name) for row in rows)
        self.outputs = tuple(str(row.name) for row in manifest.outputs)
        self.owners = tuple(str(row.of or row.joint or row.name) for row in manifest.speeds)
        self.positions = np.arange(positions)
        units = [row.unit for row in manifest.speeds]
        self.columns = np.array([size if name == "m/s" else 1.0 for name in units])
        self.rows = np.array([size if row.unit == "N" else 1.0 for row in rows])

    @abstractmethod
    def kinematic_matrix(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.kinematic_matrix`."""

    def drift(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.drift`: only speeds that users chose leave any."""
        nothing = np.zeros(len(self.speeds))
        manifest = self.model.manifest
        if manifest.absolute or all(row.joint is not None for row in manifest.speeds):
            return nothing
        rates = self.model.qdot(at.q, nothing, t=at.t, r=at.r, parameters=at.parameters)
        return np.asarray(np.linalg.lstsq(self.kinematic_matrix(at), rates)[0])

    @property
    @abstractmethod
    def increments(self) -> tuple[str, ...]:
        """Same as :meth:`DynamicSystem.increments`."""

    def start_state(
        self, q: Any, locked: Mapping[str, Any], p: Parameters
    ) -> tuple[LoadedModel, Array]:
        """The model with these parameters, and the state x (nx,) at rest that q and hold name."""
        model = self.model.with_parameters(dict(p)) if p else self.model
        named = q if isinstance(q, Mapping) else {}
        if q is not None and not isinstance(q, Mapping):
            array = model._vector("q", q)
            if array.shape != (model.nq,):
                raise ArgumentError(f"q has shape {array.shape}, expected ({model.nq},)")
            named = dict(zip(model.coordinates, array.tolist(), strict=True))
        # a whole joint that is started from gives way to what is held of it
        for joint, place in model.manifest.slots("q").items():
            joint_entries = {
                model.coordinates[k]: k - place.start for k in range(place.start, place.stop)
            }
            if joint in named and joint not in joint_entries and set(joint_entries) & set(locked):
                values = np.ravel(np.asarray(named[joint], dtype=np.float64))
                named = {n: v for n, v in named.items() if n != joint}
                named |= {n: values[k] for n, k in joint_entries.items() if n not in locked}
        return model, start_of(model, {**named, **locked}, {})[0]

    @cached_property
    def modes(self) -> Array:
        """Modes of elements as they start (ns,)."""
        rows = self.model.manifest.s
        return np.array([row.default or 0.0 for row in rows], dtype=np.float64)

    @cached_property
    def events(self) -> tuple[tuple[str, str, str], ...]:
        """Same as :meth:`DynamicSystem.events`."""
        rows = () if self.strain else self.model.manifest.events
        return tuple((row.element, row.kind, row.beyond) for row in rows)

    @cached_property
    def sign_units(self) -> tuple[str, ...]:
        """Same as :meth:`DynamicSystem.sign_units`; models saved earlier do not tell."""
        return tuple(row.unit for row in self.model.manifest.events)

    def labels(self, s: Array) -> dict[str, str]:
        """Same as :meth:`DynamicSystem.labels`."""
        rows = zip(self.model.manifest.s, s, strict=True)
        return {row.name: row.labels.get(str(int(x)), f"{x:g}") for row, x in rows}

    def signs(self, at: Moment) -> Array:
        """Same as :meth:`DynamicSystem.signs`."""
        values: Array = self.model.events(at.q, at.u, **self._arguments(at))
        return values

    def modes_after(self, at: Moment, fired: NDArray[np.bool_]) -> Array:
        """Same as :meth:`DynamicSystem.modes_after`."""
        model = self.model
        values = model.transition(at.q, at.u, fired.astype(float), **self._arguments(at))
        return np.asarray(values[len(values) - model.ns :])

    @staticmethod
    def _arguments(at: Moment) -> dict[str, Any]:
        return {"t": at.t, "r": at.r, "z": at.z, "s": at.s, "parameters": at.parameters}

    def input_vector(self, named: object) -> Array:
        """Same as :meth:`DynamicSystem.input_vector`."""
        vector: Array = self.model._vector("r", {} if named is None else named)
        if vector.shape != (self.model.nr,):
            raise ArgumentError(
                f"inputs have shape {vector.shape}, expected ({self.model.nr},): "
                f"{', '.join(self.inputs)}"
            )
        if not np.isfinite(vector).all():
            raise SolveError(f"inputs {named}: they must be finite")
        return vector

    def changed(self, values: Mapping[str, float]) -> Parameters:
        """Same as :meth:`DynamicSystem.changed`."""
        if values:
            self.model.with_parameters(dict(values))
        return dict(values) or None

    @cached_property
    def places(self) -> dict[str, tuple[int, int]]:
        """Same as :meth:`DynamicSystem.places`."""
        speeds = {name: k for k, name in enumerate(self.speeds)}
        rows = enumerate(self.model.manifest.speeds)
        speeds |= {f"{row.of}.u": k for k, row in rows if row.of}
        coordinates = set(self.coordinates)
        pairs = ((n, k, speeds.get(f"{n}.u")) for k, n in enumerate(self.coordinates))
        places = {name: (k, speed) for name, k, speed in pairs if speed is not None}
        # parts of joints with several speeds, and positions of nodes
        numbered = enumerate(self.increments)
        parts = {
            name: (self.coordinates.index(name), k) for k, name in numbered if name in coordinates
        }
        return {**parts, **places}

    def place(self, name: str) -> tuple[int, int]:
        """Same as :meth:`DynamicSystem.place`."""
        places = self.places
        if name not in places:
            suggestion = f".{near(name, places)}"
            manifest = self.model.manifest
            if component(manifest, name) or name not in manifest.slots("q"):
                suggestion = ": " + missing(manifest, "q", name, places)
            raise ModelError(f"hold: '{name}' is not a coordinate that can be held{suggestion}")
        return places[name]
