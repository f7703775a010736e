"""What every function of a model in absolute coordinates gives at one state."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from ....arrays import Array
from ....errors import ModelError
from ....schema.functions import FUNCTIONS
from .elements import State
from .frames import Frames
from .mesh import Mesh

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel

# matrices that are written out are for looking at
WHOLE = 600
Given = dict[str, Array]


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
        self.frames = Frames.of(model)
        outputs = [row.name for row in self.manifest.outputs]
        lam = model.multipliers_of
        self._names: dict[str, Sequence[str]] = {
            **{"q": model.coordinates, "u": model.speeds, "z": model.internals, "lam": lam},
            **{"positions": lam[: mesh.tables.mp], "y": outputs, "sources": mesh.tables.powers},
        }
        # q as it is moved comes without its tangent
        self._counts = {f"n{name}": len(entries) for name, entries in self._names.items()}
        self._counts |= {"nx": model.nx, "ntangent": 0}

    def of(self, name: str, of: str | None) -> Callable[[Given], Array]:
        """A function of given blocks."""
        function: Callable[..., Array] = getattr(self, name)
        return function if of is None else partial(function, of)

    def shape(self, name: str) -> tuple[tuple[int, ...], list[str]]:
        """Shape of a result, and names of its numbers."""
        row, names = FUNCTIONS[name], self._names
        shape = row.sizes(self._counts)
        entries = [entry for block in row.like.split() for entry in names[block]]
        if len(entries) != prod(shape):
            entries = [f"{name}[{k}]" for k in range(prod(shape))]
        return shape, entries

    # what elements are asked at

    def _at(self, given: Given, **more: Array) -> State:
        """A state of given blocks; arrays may be longer than what belongs to it."""
        tables = self.tables
        sizes = {"q": tables.nq, "u": tables.nu, "udot": tables.nu, "lam": tables.m}
        sizes |= {"z": tables.nz, "s": tables.ns, "r": tables.nr}
        blocks: dict[str, Any] = {n: given[n][:k] for n, k in sizes.items() if n in given and k}
        return State(t=float(given["t"][0]) if "t" in given else 0.0, **(blocks | more))

    def _small(self, name: str) -> None:
        if self.tables.nu > WHOLE:
            raise ModelError(
                f"{name}: model '{self.name}' has {self.tables.nu} speeds, too many for a full "
                "matrix. model.equilibrium() and model.modes() take sparse ones"
            )

    # dynamics

    def _solved(self, given: Given) -> tuple[Array, Array]:
        """udot and multipliers under the forces of the scene and tau."""
        tau = given["tau"][: self.tables.nu] if "tau" in given else None
        return self.mesh.accelerations(self._at(given), tau)

    def forward_dynamics(self, given: Given) -> Array:
        """udot (nu,) [rad/s^2 or m/s^2] with M udot + h = f + tau + Gᵀ lam."""
        return self._solved(given)[0]

    def multipliers(self, given: Given) -> Array:
        """lam (m,) [N or N m] of the same."""
        return self._solved(given)[1]

    def rhs(self, given: Given) -> Array:
        """Time derivative (nx,) of the state [q, u], per s."""
        return np.concatenate([self.qdot(given), self.forward_dynamics(given)])

    def inverse_dynamics(self, given: Given) -> Array:
        """tau (nu,) [N m or N] with M udot + h = f + tau."""
        return self.mesh.balance(self._at(given))[0]

    def mass_matrix(self, given: Given) -> Array:
        """M (nu, nu) [kg m^2, kg m or kg]."""
        self._small("mass_matrix")
        full: Array = self.mesh.tangent(self._at(given))["M"].toarray()
        return full

    def balance(self, given: Given) -> Array:
        """M udot + h - f - Gᵀ lam (nu,), g (mp,), G u + g_t (m,)."""
        return np.concatenate(self.mesh.balance(self._at(given)))

    # constraints

    def constraints(self, given: Given) -> Array:
        """g (mp,) [m or rad]: what vanishes at position level."""
        return self.mesh.balance(self._at(given))[1]

    def constraint_rates(self, given: Given) -> Array:
        """G u + g_t (m,) [m/s or rad/s]: what vanishes at velocity level."""
        return self.mesh.balance(self._at(given))[2]

    def constraint_jacobian(self, given: Given) -> Array:
        """G (m, nu) [1, m or 1/m]."""
        self._small("constraint_jacobian")
        full: Array = self.mesh.tangent(self._at(given))["G"].toarray()
        return full

    def close_position(self, given: Given) -> Array:
        """q (nq,) a step nearer to the constraints, then g (mp,) before it."""
        return self.mesh.call("close_position", self._at(given), self.tables.nq + self.tables.mp)

    def close_velocity(self, given: Given) -> Array:
        """u (nu,) that the constraints allow, then the rates (m,) before."""
        return self.mesh.call("close_velocity", self._at(given), self.tables.nu + self.tables.m)

    def closed(self, name: str, q: Array, u: Array, held: Array, given: dict[str, Any]) -> Array:
        """As :meth:`close_position` and :meth:`close_velocity`, where ``held`` (nu) is not 0
        nothing changes."""
        tables, more = self.tables, {n: np.asarray(given[n], float) for n in ("r", "z")}
        at = State(q=q, u=u, t=float(given["t"]), **more)
        size = tables.nq + tables.mp if name == "close_position" else tables.nu + tables.m
        return self.mesh.call(name, at, size, tau=held)

    # motion

    def qdot(self, given: Given) -> Array:
        """As :meth:`Mesh.rates`."""
        at = self._at(given)
        assert at.u is not None
        return self.mesh.rates(at.q, at.u)

    def integrate(self, given: Given) -> Array:
        """As :meth:`Mesh.move`."""
        return self.mesh.move(given["q"][: self.tables.nq], given["du"][: self.tables.nu])

    move = integrate  # its tangent is left out

    def energy(self, given: Given) -> Array:
        """Kinetic, potential and total energy (3,) [J]."""
        return self.mesh.call("energy", self._at(given), 3)

    def power(self, given: Given) -> Array:
        """Of every source (nsources,) [W]; the multipliers of driven joints are solved for."""
        return self.mesh.call("power", self._at(given), len(self.tables.powers))

    def momentum(self, given: Given) -> Array:
        """Angular (about the ground origin) and linear momentum (6,) [kg m^2/s and kg m/s]."""
        return self.mesh.call("momentum", self._at(given), 6)

    # frames and elements

    def pose(self, frame: str, given: Given) -> Array:
        """As :meth:`Frames.pose`."""
        return self.frames.pose(frame, given["q"])

    def velocity(self, frame: str, given: Given) -> Array:
        """As :meth:`Frames.velocity`."""
        return self.frames.velocity(frame, given["q"], given["u"])

    def acceleration(self, frame: str, given: Given) -> Array:
        """As :meth:`Frames.acceleration`."""
        return self.frames.acceleration(frame, given["q"], given["u"], given["udot"])

    def frame_jacobian(self, frame: str, given: Given) -> Array:
        """As :meth:`Frames.jacobian`."""
        return self.frames.jacobian(frame, given["q"], self.tables.nu)

    def reaction(self, joint: str, given: Given) -> Array:
        """The wrench (6,) [N m and N] of a joint of the scene; its multipliers are solved for."""
        at = self._at(given, lam=self.multipliers(given))
        return self._of_member("reaction", joint, at)

    def outputs(self, given: Given) -> Array:
        """The declared outputs (ny,), in their units."""
        return self.mesh.call("outputs", self._at(given), self.tables.outputs)

    def _of_member(self, form: str, name: str, at: State) -> Array:
        """The result of one element of the scene."""
        told = self.manifest.elements.reactions.get(name)
        if told is None:
            raise ModelError(
                f"{form}: '{name}' transmits none in model '{self.name}' in absolute coordinates"
            )
        having = [g for g in self.tables.groups if form in g.kind.functions]
        results = self.mesh.results(form, at)
        row: Array = results[having.index(self.tables.groups[told[0]])][told[1]]
        return row
