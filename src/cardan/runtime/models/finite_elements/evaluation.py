"""Functions of a model in finite-element coordinates, evaluated at one state."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from functools import partial
from math import prod
from typing import TYPE_CHECKING, Any, TypeVar, cast, overload

import numpy as np

from ....arrays import Array
from ....errors import ModelError
from ....schema.functions import FUNCTIONS
from . import summands
from .elements import State
from .frames import Frames, node_frames
from .mesh import Mesh
from .tree_frames import TreeFrames

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel

# matrices that are written out are for looking at
LARGEST = 600
# how many values by keys stay with a model
LATEST = 8
T = TypeVar("T")
Inputs = dict[str, Array]


class NumberedNames(Sequence[str]):
    """Names ``name[0]``, ``name[1]``, ... of the numbers of a result, made when they are asked for:
    those of balances of many elements take as much memory as the elements."""

    def __init__(self, name: str, count: int) -> None:
        """Names of so many numbers."""
        self._name = name
        self._places = range(count)

    @overload
    def __getitem__(self, place: int) -> str: ...

    @overload
    def __getitem__(self, place: slice) -> list[str]: ...

    def __getitem__(self, place: int | slice) -> str | list[str]:
        if isinstance(place, slice):
            return [f"{self._name}[{k}]" for k in self._places[place]]
        return f"{self._name}[{self._places[place]}]"

    def __len__(self) -> int:
        return len(self._places)


class Results:
    """The functions of a model, one state at a time.

    Args:
        mesh: Its elements.
        model: For names and frames.
    """

    def __init__(self, mesh: Mesh, model: LoadedModel) -> None:
        self.mesh = mesh
        self.tables = mesh.tables
        self.manifest = model.manifest
        self.name = model.name
        places = node_frames(model)
        self.frames = Frames(self.manifest.frames, *places)
        self.in_trees = TreeFrames(mesh, self.manifest.frames, *places)
        outputs = [row.name for row in self.manifest.outputs]
        lam = model.multipliers_of
        forces = [row.name for row in self.manifest.element_forces]
        self._names: dict[str, Sequence[str]] = {
            **{"q": model.coordinates, "u": model.speeds, "z": model.internals, "lam": lam},
            **{"positions": lam[: mesh.tables.mp], "y": outputs, "sources": mesh.tables.powers},
            "forces": forces,
        }
        self._cache: dict[Hashable, object] = {}
        # q as it is moved comes without its tangent
        self._counts = {f"n{name}": len(entries) for name, entries in self._names.items()}
        self._counts |= {"nx": model.nx, "ntangent": 0, "ns": mesh.tables.ns, "ne": mesh.tables.ne}

    def once(self, key: Hashable, make: Callable[[], T]) -> T:
        """A value that follows from the model and a key, computed at the first request.

        Those of the last few keys stay.
        """
        if key not in self._cache:
            if len(self._cache) >= LATEST:
                self._cache.pop(next(iter(self._cache)))
            self._cache[key] = make()
        return cast("T", self._cache[key])

    def of(self, name: str, of: str | None) -> Callable[[Inputs], Array]:
        """A function of given blocks."""
        function: Callable[..., Array] = getattr(self, name)
        return function if of is None else partial(function, of)

    def at_once(self, name: str, of: str | None) -> bool:
        """True if a function takes blocks of many states (n, ...)."""
        on_node = of is not None and of not in self.in_trees
        return on_node and name in {"pose", "velocity", "acceleration"}

    def shape(self, name: str) -> tuple[tuple[int, ...], Sequence[str]]:
        """Shape of a result, and names of its numbers."""
        row, names = FUNCTIONS[name], self._names
        shape, blocks = row.sizes(self._counts), row.like.split()
        if sum(len(names[block]) for block in blocks) != prod(shape):
            return shape, NumberedNames(name, prod(shape))
        return shape, tuple(entry for block in blocks for entry in names[block])

    # what elements are asked at

    def state(self, inputs: Inputs, **more: Array) -> State:
        """A state of given blocks; arrays may be longer than what belongs to it."""
        sizes = self.tables.sizes.items()
        blocks: dict[str, Any] = {n: inputs[n][:k] for n, k in sizes if n in inputs and k}
        return State(t=float(inputs["t"][0]) if "t" in inputs else 0.0, **(blocks | more))

    def check_small(self, name: str, rows: int) -> None:
        """Refuse a full matrix (rows, nu) with more entries than one has of LARGEST speeds."""
        if rows * self.tables.nu > LARGEST**2:
            raise ModelError(
                f"{name}: model '{self.name}' has {self.tables.nu} speeds, too many for a full "
                "matrix. model.equilibrium() and model.modes() take sparse ones"
            )

    # dynamics

    def _solved(self, inputs: Inputs) -> tuple[Array, Array]:
        """udot and multipliers under the forces of the scene and tau."""
        tau = inputs["tau"][: self.tables.nu] if "tau" in inputs else None
        return self.mesh.accelerations(self.state(inputs), tau)

    def forward_dynamics(self, inputs: Inputs) -> Array:
        """udot (nu,) [rad/s^2 or m/s^2] with M udot + h = f + tau + Gᵀ lam."""
        return self._solved(inputs)[0]

    def multipliers(self, inputs: Inputs) -> Array:
        """lam (m,) [N or N m] of the same."""
        return self._solved(inputs)[1]

    def rhs(self, inputs: Inputs) -> Array:
        """Time derivative (nx,) of the state [q, u, z], per s."""
        return self.mesh.call("rhs", self.state(inputs), self._counts["nx"], inputs.get("tau"))

    def inverse_dynamics(self, inputs: Inputs) -> Array:
        """tau (nu,) [N m or N] with M udot + h = f + tau."""
        return self.mesh.balance(self.state(inputs))[0]

    def mass_matrix(self, inputs: Inputs) -> Array:
        """M (nu, nu) [kg m^2, kg m or kg]."""
        self.check_small("mass_matrix", self.tables.nu)
        full: Array = self.mesh.tangent(self.state(inputs), ("M",))["M"].toarray()
        return full

    def balance(self, inputs: Inputs) -> Array:
        """M udot + h - f - Gᵀ lam (nu,), g (mp,), G u + g_t (m,)."""
        return np.concatenate(self.mesh.balance(self.state(inputs)))

    # constraints

    def constraints(self, inputs: Inputs) -> Array:
        """g (mp,) [m or rad]: what vanishes at position level."""
        return self.mesh.balance(self.state(inputs))[1]

    def constraint_rates(self, inputs: Inputs) -> Array:
        """G u + g_t (m,) [m/s or rad/s]: what vanishes at velocity level."""
        return self.mesh.balance(self.state(inputs))[2]

    def constraint_jacobian(self, inputs: Inputs) -> Array:
        """G (m, nu) [1, m or 1/m]."""
        self.check_small("constraint_jacobian", self.tables.m)
        full: Array = self.mesh.tangent(self.state(inputs), ("G",))["G"].toarray()
        return full

    def close_position(self, inputs: Inputs) -> Array:
        """q (nq,) a step nearer to the constraints, then g (mp,) before it."""
        return self.mesh.call("close_position", self.state(inputs), self.tables.nq + self.tables.mp)

    def close_velocity(self, inputs: Inputs) -> Array:
        """u (nu,) that the constraints allow, then the rates (m,) before."""
        return self.mesh.call("close_velocity", self.state(inputs), self.tables.nu + self.tables.m)

    def closed(self, name: str, q: Array, u: Array, locked: Array, inputs: dict[str, Any]) -> Array:
        """Same as :meth:`close_position` and :meth:`close_velocity`, where ``locked`` (nu) is not 0
        nothing changes.
        """
        tables, more = self.tables, {n: np.asarray(inputs[n], float) for n in ("r", "z")}
        at = State(q=q, u=u, t=float(inputs["t"]), **more)
        size = tables.nq + tables.mp if name == "close_position" else tables.nu + tables.m
        return self.mesh.call(name, at, size, tau=locked)

    # events

    def events(self, inputs: Inputs) -> Array:
        """Values (ne,) of events, which happen where they fall through zero."""
        return self.mesh.call("events", self.state(inputs), self.tables.ne)

    def transition(self, inputs: Inputs) -> Array:
        """u (nu,), z (nz,) and s (ns,) behind the events ``e``."""
        tables, e = self.tables, inputs["e"][: self.tables.ne]
        return self.mesh.call(
            "transition", self.state(inputs), tables.nu + tables.nz + tables.ns, e=e
        )

    # motion

    def qdot(self, inputs: Inputs) -> Array:
        """Same as :meth:`Mesh.rates`."""
        at = self.state(inputs)
        assert at.u is not None
        return self.mesh.rates(at.q, at.u)

    def integrate(self, inputs: Inputs) -> Array:
        """Same as :meth:`Mesh.move`."""
        return self.mesh.move(inputs["q"][: self.tables.nq], inputs["du"][: self.tables.nu])

    move = integrate  # its tangent is left out

    def energy(self, inputs: Inputs) -> Array:
        """Kinetic, potential and total energy (3,) [J]."""
        return self.mesh.call("energy", self.state(inputs), 3)

    def power(self, inputs: Inputs) -> Array:
        """Power of every source (nsources,) [W];

        the multipliers of driven joints are solved for.
        """
        return self.mesh.call("power", self.state(inputs), len(self.tables.powers))

    def momentum(self, inputs: Inputs) -> Array:
        """Angular (about the ground origin) and linear momentum (6,) [kg m^2/s and kg m/s]."""
        return self.mesh.call("momentum", self.state(inputs), 6)

    # frames and elements

    def pose(self, frame: str, inputs: Inputs) -> Array:
        """Same as :meth:`Frames.pose`."""
        if frame in self.in_trees:
            return self.in_trees.pose(frame, self.state(inputs))
        return self.frames.pose(frame, inputs["q"])

    def velocity(self, frame: str, inputs: Inputs) -> Array:
        """Same as :meth:`Frames.velocity`."""
        if frame in self.in_trees:
            return self.in_trees.velocity(frame, self.state(inputs))
        return self.frames.velocity(frame, inputs["q"], inputs["u"])

    def acceleration(self, frame: str, inputs: Inputs) -> Array:
        """Same as :meth:`Frames.acceleration`."""
        if frame in self.in_trees:
            return self.in_trees.acceleration(frame, self.state(inputs))
        return self.frames.acceleration(frame, inputs["q"], inputs["u"], inputs["udot"])

    def frame_jacobian(self, frame: str, inputs: Inputs) -> Array:
        """Same as :meth:`Frames.jacobian`."""
        if frame in self.in_trees:
            return self.in_trees.jacobian(frame, self.state(inputs))
        return self.frames.jacobian(frame, inputs["q"], self.tables.nu)

    def reaction(self, joint: str, inputs: Inputs) -> Array:
        """The wrench (6,) [N m and N] of a joint of the scene; its multipliers are solved for."""
        udot, lam = self._solved(inputs)
        at = self.state(inputs, udot=udot, lam=lam)
        return summands.of_reaction(self.tables, self.manifest, joint).total(self.mesh, at)

    def outputs(self, inputs: Inputs) -> Array:
        """The declared outputs (ny,), in their units."""
        return self.mesh.call("outputs", self.state(inputs), self.tables.outputs)

    def element_forces(self, inputs: Inputs) -> Array:
        """Forces of elements by name (nforces,) [N or N m]."""
        more: dict[str, Array] = {}
        if self.forces_solved:
            more["lam"] = self._solved(inputs)[1]
        at = self.state(inputs, **more)
        return summands.of_forces(self.tables, self.manifest).total(self.mesh, at)

    @property
    def forces_solved(self) -> bool:
        """True where forces of elements follow from multipliers: what modes hold, and friction."""
        having = summands.having_form(self.tables, "element_forces")
        return any(self.tables.groups[k].kind.m for k in having)
