"""The result of a simulation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from ...arguments import Times, checked
from ...arrays import Array
from ...errors import ModelError
from ...notebooks import html
from ...records import dataclass
from ...schema.manifest import Manifest
from ..calls.methods import Energy
from ..models.finite_elements.beam_sections import sections
from .closure_errors import Ledger, multipliers_of, residuals_of
from .dense_output import Dense
from .energy_balance import Balance, balance, impacts
from .event_log import Event, EventLog
from .frame_history import frame_on_body, numbers, pose
from .histories import history, state_places
from .input_history import Recorded
from .interpolation import inputs_at, states_at
from .solver_info import EVENT, FINISHED, SolverInfo

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel


@dataclass(frozen=True, repr=False, eq=False)
class TrajectoryRecord:
    """Motion of a model over time, with histories by name.

    Attributes:
        t: Times (nt,) [s].
        x: States [q, u, z] (nt, nx).
        r: Inputs (nt, nr).
        work_done: Energy that every source has given since the start (nt, sources) [J].
        sources: Names of the sources; None where the model has no function ``power``.
        manifest: Names and units, as the compiler states them.
        solver_info: How the run went.
        model: The model, None for a run read from a file.
        dense: Polynomials between the times, None where only output times were asked for.
        inputs_at: Inputs (m, nr) at times (m,), None where only those at ``t`` are known.
        stored: Histories read from a file or computed before, by name.
        numbers: The flat scene of a run read from a file, see :attr:`scene`, and the surfaces of
            its superelements.
        ledger: Residuals of the constraints over the run, None without loops.
        event_log: The discrete states along the run, and its events; see :attr:`events`.
        sensitivity: What the motion changes by, by name, as ``simulate(sensitivity=...)`` was
            asked; empty without.
    """

    t: Array
    x: Array
    r: Array
    work_done: Array
    sources: tuple[str, ...] | None
    manifest: Manifest
    solver_info: SolverInfo
    model: LoadedModel | None = None
    dense: Dense | None = None
    inputs_at: Recorded | None = None
    stored: dict[str, Array] = field(default_factory=dict)
    numbers: Mapping[str, Array] = field(default_factory=dict)
    ledger: Ledger | None = None
    event_log: EventLog = field(default_factory=EventLog)
    sensitivity: Any = field(default_factory=dict)

    @classmethod
    def of_states(
        cls,
        model: LoadedModel,
        t: Array,
        x: Array,
        r: Array,
        description: str,
        s: Array | None = None,
    ) -> Self:
        """States that no integration gave, such as those of a mode or a load path.

        Args:
            model: Their model.
            t, x, r, s: Times (nt,), states (nt, nx), inputs (nt, nr), discrete states (nt, ns).
                Internal states and discrete ones that are left out are those of a start.
            description: What they are, in words.
        """
        internal, modes = (np.tile(model._layout.start(name), (len(t), 1)) for name in "zs")
        if x.shape[1] < model.nx:
            x = np.hstack([x, internal])
        counts = dict.fromkeys(("steps", "rejections", "evaluations", "milliseconds"), 0.0)
        info = SolverInfo(description, "not integrated", {}, (), FINISHED, description, counts)
        log = EventLog(modes if s is None else s)
        none = np.zeros((len(t), 0))
        return cls(t, x, r, none, None, model.manifest, info, model, event_log=log)

    # what happened

    @property
    def success(self) -> bool:
        """True when the run reached its end, or an event that ends it."""
        return self.solver_info.status in (FINISHED, EVENT)

    @property
    def status(self) -> str:
        """``finished``, ``event`` (one ended the run), or why it ended early."""
        return self.solver_info.status

    @property
    def message(self) -> str:
        """The status as a sentence."""
        return self.solver_info.message

    @property
    def statistics(self) -> dict[str, float]:
        """steps, rejections, evaluations, events, milliseconds and more."""
        return dict(self.solver_info.statistics)

    def __repr__(self) -> str:
        from .summary import summary

        return summary(self)

    _repr_html_ = html

    def __len__(self) -> int:
        return len(self.t)

    def __reduce__(self) -> tuple[object, ...]:
        # the arrays, the names and the model's source; what can be computed again stays behind
        from .pickled import reduced

        return reduced(self)

    # states

    @property
    def nq(self) -> int:
        """Number of coordinates."""
        return len(self.manifest.coordinates)

    @property
    def q(self) -> Array:
        """Coordinates (nt, nq)."""
        return self.x[:, : self.nq]

    @property
    def u(self) -> Array:
        """Speeds (nt, nu)."""
        return self.x[:, self.nq : self.nq + len(self.manifest.speeds)]

    @property
    def z(self) -> Array:
        """Internal states of elements (nt, nz)."""
        return self.x[:, self.nq + len(self.manifest.speeds) :]

    @property
    def s(self) -> Array:
        """Discrete states of elements (nt, ns)."""
        return self.event_log.s if self.event_log.s.size else np.zeros((len(self), 0))

    @property
    def parameters(self) -> Array | None:
        """Values of the parameters (np,) in the order of the manifest; None in old files."""
        return self.stored.get("parameters") if self.model is None else self.model.parameters.vector

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """Events in the order of time, without samples: those are :attr:`ticks`.

        Rows at ``t`` stand before and behind a change.
        """
        return self.event_log.events(self.x.shape[1])

    @cached_property
    def ticks(self) -> tuple[Event, ...]:
        """Samples of controllers, in the order of time; in ``s``, ``s_after`` what they hold."""
        return self.event_log.events(self.x.shape[1], ticks=True)

    def __getitem__(self, name: str) -> Array:
        """History of a coordinate, speed, state of an element, input, output or multiplier.

        ``<joint>.force`` [N] and ``<joint>.moment`` [N m] (nt, 3) are the reaction of a joint, see
        :meth:`reaction`; ``.force.x`` is one of its parts. ``energy``, ``kinetic energy`` and
        ``potential energy`` [J] are those of :attr:`energy`. ``<element>.force`` is what a force
        element exerts: along its line (positive: it pulls the ends together) or its joint (nt,),
        else the force on its first frame (nt, 3) in ground axes, with ``<element>.moment`` about
        the origin of that frame. Shape (nt,), (nt, n) for several.

        Raises:
            ModelError: no such name.
        """
        return history(self, name)

    @cached_property
    def _places(self) -> dict[str, tuple[Array, int | slice]]:
        """Name -> the array it lies in, and its column or columns there."""
        blocks = {"q": self.q, "u": self.u, "r": self.r, "z": self.z, "s": self.s}
        places = state_places(self.manifest)
        return {name: (blocks[letter], columns) for name, (letter, columns) in places.items()}

    @property
    def _r(self) -> Array | None:
        """Inputs for functions of the model."""
        return self.r if self.r.shape[1] else None

    @property
    def _arguments(self) -> dict[str, Any]:
        """States of elements for functions of the model that read them."""
        return {"z": self.z, "s": self.s}

    def _model(self, what: str) -> LoadedModel:
        if self.model is None:
            raise ModelError(
                f"{what} needs the model, which a file does not hold. Compile it and give it: "
                "cd.load_motion(path, model)"
            )
        return self.model

    @checked
    def at(self, t: Times) -> Array:
        """State between the steps, (nx,) for one time, (m, nx) for m times.

        Raises:
            ModelError: a time outside the run, or none of those that are all a run kept.
        """
        times = np.asarray(t, dtype=np.float64)
        values = states_at(self, np.atleast_1d(times))[:, : self.x.shape[1]]
        return values[0] if times.ndim == 0 else values

    @checked
    def resample(self, times: Times) -> Self:
        """The same motion at other times, from the dense output.

        Raises:
            ModelError: as :meth:`at`.
        """
        at = np.atleast_1d(np.asarray(times, dtype=np.float64))
        y, nx, r = states_at(self, at), self.x.shape[1], inputs_at(self, at)
        event_log = self.event_log
        constant = {k: v for k, v in self.stored.items() if k == "parameters"}
        changes: dict[str, Any] = {"dense": None, "stored": constant, "work_done": y[:, nx:]}
        return replace(
            self,
            t=at,
            x=y[:, :nx],
            r=r,
            event_log=replace(event_log, s=event_log.modes(self.t, at)),
            **changes,
        )

    # energy

    @cached_property
    def energy(self) -> Energy:
        """Kinetic, potential and total energy (nt,) each [J]."""
        if "kinetic" in self.stored:
            kinetic, potential = self.stored["kinetic"], self.stored["potential"]
            return Energy(kinetic, potential, kinetic + potential)
        return self._model("energy").energy(self.q, self.u, t=self.t, r=self._r)

    @property
    def work(self) -> dict[str, Array]:
        """Energy that every force without a potential has given since the start (nt,) [J].

        With what impacts have taken, as ``<element>.impact``.
        """
        if self.sources is None:
            raise ModelError(
                "work needs the function 'power': compile(..., functions=[..., 'power'])"
            )
        work = {name: self.work_done[:, k] for k, name in enumerate(self.sources)}
        return work | impacts(self)

    @cached_property
    def balance(self) -> Balance:
        """Energy balance of the run [J]."""
        return balance(self)

    @cached_property
    def energy_residual(self) -> Array:
        """Energy that the ledger cannot account for (nt,) [J]: the error of the integration.

        The total energy less that at the start less the work of all sources.
        """
        total = self.energy.total
        residual: Array = total - total[0] - sum(self.work.values(), np.zeros(len(total)))
        return residual

    @property
    def drift(self) -> Ledger:
        """Largest residual of every constraint, before and after projection.

        ``drift.position`` and ``drift.velocity`` are by multiplier; empty without loops.
        """
        return Ledger({}, {}) if self.ledger is None else self.ledger

    @property
    def constraints(self) -> dict[str, Array]:
        """Residual (nt,) of every constraint of positions by multiplier; a tree has none."""
        return residuals_of(self)

    @property
    def multipliers(self) -> dict[str, Array]:
        """History (nt,) of every Lagrange multiplier [N, N m]; a tree has none."""
        return multipliers_of(self)

    # what a model shows along the motion

    @checked
    def pose(self, frame: str) -> Array:
        """Transforms (nt, 4, 4) from frame axes to ground axes."""
        key = f"pose {frame}"
        if key not in self.stored and self.model is not None:
            self.stored[key] = self.model.pose(frame, self.q, t=self.t, r=self._r)
        return self.stored[key] if key in self.stored else pose(self, frame)

    @checked
    def line(self, beam: str) -> Array:
        """Positions (nt, nodes, 3) [m] of the nodes of a beam, from its start to its end."""
        return self.sections(beam)[..., :3, 3].copy()

    @checked
    def sections(self, beam: str) -> Array:
        """Poses of the cross sections at the nodes of a beam, from its start to its end.

        Args:
            beam: Name of the beam.

        Returns:
            Transforms (nt, nodes, 4, 4) from axes of the section to ground axes: x across the
            section, which is along the line in the reference configuration; y and z are e2 and e3
            as ``up=`` of the beam directs them. The origins are ``line(beam)``.

        Raises:
            ModelError: there is no such beam.

        Source: M. Geradin and A. Cardona, Flexible Multibody Dynamics, 2001, chapter 6.
        """
        return sections(self.manifest.beams, beam, self.q, self.pose)

    @cached_property
    def scene(self) -> Mapping[str, Array]:
        """Numbers of the scene at the parameters of the run, constant in body axes.

        mass, first_moment (by body), position, rotation (of the inboard joint frame in the parent
        body), frame_rotation, frame_position (by frame) and more. In absolute coordinates
        frame_rotation and frame_position alone, on the node that carries a frame.
        """
        return self.numbers if self.model is None else numbers(self.model)

    @checked
    def frame_on_body(self, frame: str) -> Array:
        """Transform (4, 4) from the axes of a frame to those of the rigid body that carries it."""
        return frame_on_body(self, frame)

    @checked
    def reaction(self, joint: str) -> Array:
        """Wrench (nt, 6) of parent on child at the child joint frame, in its axes; moment first.

        Along the freedoms of the joint it holds what a JointSpring, JointDamper or JointForce
        exerts on it: Mz of a hinge about z holds the torque of its spring.
        """
        if f"reaction {joint}" in self.stored:
            return self.stored[f"reaction {joint}"]
        model = self._model(f"the reaction of '{joint}'")
        reaction: Array = model.reaction(
            joint, self.q, self.u, t=self.t, r=self._r, **self._arguments
        )
        return reaction
