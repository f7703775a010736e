"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, final

from numpy.typing import ArrayLike

from ..analyses.continuation.stability_chart import StabilityChartRecord
from ..analyses.ensembles.sampling import Plan
from ..analyses.gradients.gradient import Gradient
from ..analyses.identification.base_parameters import Base
from ..analyses.linear.first_order import Choice
from ..analyses.linear.sensitivity import Sensitivity
from ..analyses.mechanisms.actuation import Actuation
from ..analyses.mechanisms.minimal_coordinates import Partition
from ..analyses.mechanisms.redundancy import Redundancy
from ..analyses.mechanisms.screw_axis import ScrewAxis
from ..analyses.mechanisms.singular_positions import Singular
from ..analyses.mechanisms.undetermined_reactions import Undetermined
from ..analyses.simulation.alpha_methods import Alpha, GeneralizedAlpha
from ..analyses.simulation.precision.report import Report
from ..analyses.simulation.precision.runs import Show
from ..analyses.simulation.precision.stiffness import Stiffness
from ..analyses.simulation.settings import Values
from ..analyses.simulation.stepper import Stepper
from ..arguments import Count, Inputs, LockedValues, Seed, Times
from ..arrays import Array
from ..runtime.calls.evaluation import State
from ..runtime.calls.objects import Key
from ..runtime.models.finite_elements.beams import BeamStress
from ..runtime.models.finite_elements.elements import Elements
from ..runtime.models.finite_elements.superelement_parts import SuperelementParts
from ..runtime.models.loaded_model import LoadedModel
from ..runtime.trajectory.cables import CableTension
from ..runtime.verification.verify import Verification
from ..schema.cost import Cost
from .components import DeformedSuperelement
from .results import (
    Assembly,
    Campbell,
    Continuation,
    Cycle,
    Ensemble,
    Equilibrium,
    Excitation,
    Fit,
    Identification,
    LinearModel,
    Locus,
    Modes,
    StaticPath,
    SteadyMotion,
    Sweep,
    Torques,
    Workspace,
)
from .trajectory import Trajectory

@final
class CompiledModel(LoadedModel):
    """Functions of a system as compiled C.

    All functions broadcast over leading axes like NumPy gufuncs, return fresh arrays (or fill
    ``out=``), may be called from several threads at once, and release the GIL where they work
    long. A vector may be given by names, ``{"elbow": 0.3}``; the rest then takes its default.

    Conventions: the speeds u are what robotics calls v, tau is a generalized applied force; the
    equations are M udot + h = f + tau with gravity inside h; quaternions are (w, x, y, z) and must
    have length 1; 6-vectors have the angular part first. SI units, radians.

    Raises:
        ArgumentError: wrong shape.
        ModelError: unknown name, or a function that was not compiled.
        SolveError: a number given is not finite; or, for one state, the result is not. In a batch
            the states that fail hold NaN or infinity and a SolveWarning names the first.
    """
    def simulate(
        self,
        t: float | ArrayLike | None = None,
        *,
        t_eval: ArrayLike | None = None,
        x0: ArrayLike | None = None,
        q: Values | ArrayLike | None = None,
        u: Values | ArrayLike | None = None,
        z: Values | ArrayLike | None = None,
        events: Mapping[str, object] | None = None,
        method: str | GeneralizedAlpha | Alpha = "auto",
        rtol: float | None = None,
        atol: float | None = None,
        step: float | None = None,
        max_step: float | None = None,
        inputs: Inputs | None = None,
        parameters: Values | None = None,
        sample: float | None = None,
        checkpoint: str | Path | None = None,
        every: float = 10.0,
        check: bool = False,
        sensitivity: str | Sequence[str] = (),
        progress: bool | Callable[[float], None] | None = None,
    ) -> Trajectory:
        """Integrate the equations of motion.

        Args:
            t: End time (from 0), ``(start, end)`` (backward too), or an array of output times [s].
                With an end or a pair the result is dense; ``t_eval`` takes an array of two times.
            x0: Initial state (nx,); else
            q, u: initial coordinates and speeds, ``{"elbow": 0.3, "base": [1, 0, 0, 0, 0, 0, 1]}``
                or arrays (nq,), (nu,). What is not named comes from q0 and u0 of its joint, else 0;
                of a system with loops it is assembled next to that, see ``model.assemble``.
            z: Initial internal states of elements, ``{"motor.current": 0.1}`` or an array (nz,).
            events: Name -> what to watch, besides the events of the model: ``f(t, x)`` or
                ``("elbow", 0.5)``. The run ends where that passes zero, or the coordinate, speed or
                internal state the value; ``(what, "mark")`` notes it; ``"down"``, ``"up"`` is the way.
            method: Name of an integrator, such as ``"DOP853"``, ``"RK45"``, ``"RKMK853"``,
                ``"Radau"``, ``"Rosenbrock"`` (adaptive), ``"RK4"``, ``"EnergyMidpoint"``,
                ``"EnergyMomentum"`` (fixed step), or a :class:`cardan.GeneralizedAlpha`; ``"auto"``
                takes what the scene and the first steps ask for, and says why.
            rtol, atol: Tolerances of a step: ``rtol |x| + atol``, root mean square over the state; of
                generalized-alpha and Radau on nodes (rtol + atol) times the extent, of angles 1, and of
                speeds in Radau that over the step. Unless given rtol is 1e-6, with sensitivity= 1e-9 as
                for gradients and fits, and atol is 1e-3 rtol, at most 1e-9.
            step: Step of fixed methods and of generalized-alpha, first one of others [s].
            max_step: Largest step of an adaptive method [s]; with input functions 1/1000 of the span.
            inputs: Name -> constant, ``(times, values)`` (straight lines between, a time twice is a
                jump; of a prescribed motion a cubic spline, through three a parabola), ``f(t, x)`` or
                ``f(t)``; names of several -> a :class:`cardan.CFunction`.
            parameters: Values of parameters by name, as ``model.with_parameters`` takes them.
            sample: Time between calls of ``f(t, x)`` [s], held in between; else called at every stage.
            checkpoint: A file that keeps what is computed, ``every`` so many seconds; the same call
                goes on from there, to the bit.
            check: Raise instead of warn, see below and ``docs/integrators.md``.
            sensitivity: Starts, parameters and inputs by name, as :meth:`gradient` takes them: the
                motion has ``motion.sensitivity["m"]``, what it changes by them.
            progress: True, False or a function of the fraction done; None: a bar in long runs.

        Returns:
            The motion and its ``events``. After a breakdown or Ctrl-C: what was computed, with
            ``status``, ``message`` and a :class:`~cardan.errors.SolveWarning`. Energy, momentum or
            closure off by more than a hundred times what the tolerance is worth give one too.

        Raises:
            ModelError: an unknown name, an empty span, options that do not fit. ArgumentError: wrong
                shapes. FunctionError: yours failed; ``motion`` is what was computed. SolveError: a
                number that is not finite; with ``check``, an early end.
        """
    def stepper(
        self,
        *,
        t: float = 0.0,
        x0: ArrayLike | None = None,
        q: Values | ArrayLike | None = None,
        u: Values | ArrayLike | None = None,
        z: Values | ArrayLike | None = None,
        events: Mapping[str, object] | None = None,
        method: str | GeneralizedAlpha | Alpha = "auto",
        rtol: float = 1e-06,
        atol: float | None = None,
        step: float | None = None,
        max_step: float | None = None,
        inputs: Mapping[str, object] | None = None,
    ) -> Stepper:
        """A stepper at a start.

        Args:
            t: Time at the start [s].
            x0, q, u, z, events, method, rtol, atol, max_step: As for ``simulate``.
            step: Step of RK4; first step of DOP853 [s].
            inputs: Constants by name; later values go to :meth:`Stepper.step`.

        Raises:
            ModelError, ArgumentError, SolveError: as for ``simulate``.
        """
    def resume(
        self,
        path: str | Path,
        *,
        events: Mapping[str, object] | None = None,
    ) -> Stepper:
        """The stepper of a checkpoint that :meth:`Stepper.save` wrote; it goes on bit for bit.

        Args:
            path: The file.
            events: As the stepper was made with: functions are not in the file.

        Raises:
            ModelError: no checkpoint of this model, or of other events.
        """
    def step(
        self,
        x: ArrayLike,
        dt: float,
        *,
        t: float = 0.0,
        events: Mapping[str, object] | None = None,
        method: str | GeneralizedAlpha | Alpha = "auto",
        rtol: float = 1e-06,
        atol: float | None = None,
        step: float | None = None,
        max_step: float | None = None,
        inputs: Mapping[str, object] | None = None,
    ) -> Array:
        """The states that a time dt leads to.

        Args:
            x: States [q, u, z] (..., nx).
            dt: Time to pass [s], negative to go back; one compiled run per state, all of them in one
                call of the kernels where the model has no events.
            t: Time at the start [s].
            events, method, rtol, atol, step, max_step, inputs: As ``stepper`` takes them.

        Returns:
            (..., nx).

        Raises:
            ModelError, ArgumentError, SolveError: as :func:`stepper` and :meth:`Stepper.step`.
        """
    def ensemble(
        self,
        t: float | ArrayLike | None = None,
        *,
        t_eval: ArrayLike | None = None,
        vary: Plan | Mapping[str, object] | None = None,
        x0: Any = None,
        q: Any = None,
        u: Any = None,
        z: Any = None,
        parameters: Mapping[str, object] | None = None,
        inputs: Inputs | None = None,
        sample: float | None = None,
        events: Mapping[str, object] | None = None,
        runs: Count | None = None,
        seed: Seed = 0,
        reduce: str | Sequence[str] | Mapping[str, object] | None = None,
        sensitivity: str | Sequence[str] = (),
        method: str = "auto",
        rtol: float | None = None,
        atol: float | None = None,
        step: float | None = None,
        max_step: float | None = None,
        threads: int | None = None,
        lanes: int | None = None,
        client: Any = None,
        part: Sequence[int] | None = None,
        checkpoint: str | Path | None = None,
        check: bool = False,
        progress: bool | Callable[[float], None] | None = None,
    ) -> Ensemble:
        """Many runs that differ by their start, parameters or inputs.

        Args:
            t: End, ``(start, end)`` or output times [s], which ``t_eval`` takes too.
            vary: A plan of :mod:`cardan.analyses.ensembles.sampling`, or name -> values, distributions.
            x0: States (runs, nx); or q, u, z: arrays (runs, nq), (runs, nu) or by names,
                ``{"elbow": values}``. One is that of all runs; ``cd.sample.normal(0, 0.1)`` is drawn.
            parameters, inputs: Name -> number, values (runs,) or a distribution; inputs of all runs
                alike also ``(times, values)`` or ``f(t, x)``, which ``sample`` [s] holds.
            events: As of ``simulate``; runs with them, loops or Python on the way take no lanes.
            runs, seed: How many, where nothing else says so; of the distributions.
            reduce: What to keep beside the last states: ``"max of elbow"``, several, or name -> words
                or a function of t (nt,) and states (runs, nt, nx) of some runs. By default the states
                at output times; reductions take 201 where there are none.
            sensitivity: Starts, parameters and inputs, as :meth:`gradient` takes them, by which
                ``runs.sensitivity["m"]``, (runs, nt, nx), are derivatives; done one after the other.
            method, rtol, atol, step, max_step: As of ``simulate``; ``"auto"`` looks at the first run.
            threads: By default ``$CARDAN_THREADS``, else the cores of this process.
            lanes: 1: no lanes. By default as many as vectors have, once they pay.
            client: Computes instead of threads: of ``dask.distributed``, or an executor.
            part: ``(k, n)``: only part k of n, from 1 on: ``part=(3, 8)`` in job 3 of 8 that share a
                disk. ``cd.Ensemble.join`` makes the whole of them, to the bit.
            checkpoint: A file of finished blocks; the same call goes on from there. One per part.
            check, progress: As of ``simulate``.

        Returns:
            Last states, status and reductions; after Ctrl-C of what was computed.

        Raises:
            ModelError: unknown names, nothing that differs, a checkpoint of other runs. ArgumentError:
                shapes that do not fit. FunctionError: a function of yours raised. SolveError: a number
                that is not finite; no room for the checkpoint; a run that failed, with ``check``.
                BuildError: a client whose machine builds other bits.
        """
    def initial(
        self,
        q: Values | None = None,
        u: Values | None = None,
        z: Values | None = None,
    ) -> Array:
        """The state x (nx,) in which a run with these named values starts.

        Loops are closed at t = 0 with the defaults of the inputs, as ``simulate`` closes them: what
        is named is held, the rest is next to q0 and u0 of the joints, then 0.

        Args:
            q, u, z: Coordinates, speeds and internal states by name.

        Raises:
            ModelError: an unknown name, or loops that cannot be closed with what is named.
            ArgumentError: the wrong number of values.
            SolveError: a value that is not finite, or a quaternion whose length is not 1.
        """
    def report(
        self,
        t: float | ArrayLike | None = None,
        *,
        methods: Sequence[str] | None = None,
        patience: float = 5.0,
        show: Show | None = None,
        x0: ArrayLike | None = None,
        q: Any = None,
        u: Any = None,
        z: Any = None,
        inputs: Inputs | None = None,
        events: Mapping[str, object] | None = None,
    ) -> Report:
        """Measure every function: operations, time, error against 40 digits; prints a table.

        Args:
            t: With an end, or ``(start, end)`` [s], speed against error of every integrator too:
                ``report(10, q={"elbow": 1.0}).methods``.
            methods: Names of integrators; all by default.
            patience: Longest time for one run [s]; a method stops where it would take more.
            show: Called with what is being run and the fraction done.
            x0, q, u, z, inputs, events: Of the motion, as ``simulate`` takes them.

        Raises:
            ModelError: an unknown method or name. SolveError: no reference can be computed.
        """
    def assemble(
        self,
        targets: Mapping[str, object] | None = None,
        *,
        u: Mapping[str, object] | None = None,
        udot: Mapping[str, object] | None = None,
        weights: Mapping[str, float] | None = None,
        locked: Iterable[str] | None = None,
        branch: Mapping[str, object] | None = None,
        start: Mapping[str, ArrayLike] | ArrayLike | None = None,
        starts: Count = 16,
        seed: Seed = 0,
        t: float = 0.0,
        r: State | None = None,
        by: str = "constraints",
    ) -> Assembly:
        """A position at which all loops close, next to a start, with some of it given.

        Args:
            targets: Coordinate or joint -> value, frame -> its position (3,) or pose (4, 4) in the
                ground. All are held exactly but for those in ``weights``.
            u, udot: Given speeds and accelerations by name; the other speeds are those of least kinetic
                energy, the other accelerations those under the forces of the scene.
            weights: Target -> weight; such targets are met as well as the rest allows: the weighted sum
                of squares is least, lengths in sizes of the mechanism, angles in radians.
            locked: Names of the targets that are held, instead of all without a weight.
            branch: Coordinate -> ``"+"``, ``"-"`` or ``(low, high)``: which of several positions.
            start: Coordinates to start from, by name or (nq,); the position next to them is chosen.
            starts: Searches: the first from ``start``, the others from random coordinates.
            seed: Of the random ones.
            t, r: Time [s] and inputs, where something is prescribed.
            by: ``"constraints"``; or ``"strain_energy"``: targets are coordinates, and all else has
                the position next to the start at which the energy of springs, bushings, cables and
                beams is least, without loads and weights. It takes ``targets``, ``start``, t and r.

        Raises:
            ModelError: the loops cannot be assembled, inconsistent targets, no position
                on the branch, unknown names; by strain energy, nothing that is strained.
            ArgumentError, SolveError: values of a wrong shape, or not finite; by strain energy, no
                position that has the values.

        Warns:
            SolveWarning: two positions are equally near to the start; or Ctrl-C ended the searches
                once one had met the targets; by strain energy, nothing strained resists some motion.
        """
    def sweep(
        self,
        driver: str | Mapping[str, ArrayLike],
        values: ArrayLike | None = None,
        *,
        rate: float = 1.0,
        acceleration: float = 0.0,
        locked: LockedValues | None = None,
        start: Mapping[str, ArrayLike] | ArrayLike | None = None,
        branch: Mapping[str, object] | None = None,
        t: float = 0.0,
        r: State | None = None,
        by: str = "constraints",
        snap: bool = False,
        check: bool = False,
        progress: bool | Callable[[float], None] | None = None,
    ) -> Sweep:
        """Drive a mechanism through given values and keep its branch.

        Args:
            driver: Coordinate that is driven, or several with their values: they go together. By
                strain energy also parameters, such as the length of a spring, inputs and ``"t"``.
            values: Of the one driver (n,).
            rate, acceleration: Derivatives of the driver over time, for speeds and accelerations; of
                several drivers those of the first, the others follow in proportion.
            locked: Further coordinates or frames that keep a value, as ``assemble`` takes them.
            start: Coordinates near those of the first position; branch: as ``assemble`` takes it.
            t, r: Time [s] and inputs, where something is prescribed.
            by: ``"constraints"``; or ``"strain_energy"``: what is not driven has the position at which
                the energy of springs, bushings, cables and beams is least, without loads and weights.
            snap: By strain energy: where minima end, or become saddles, go downhill to another one and
                on from there, instead of stopping, or keeping the saddles.
            check: Raise where the mechanism cannot follow, instead of warning.
            progress: True, False or a function of the fraction done; None: a bar in long sweeps.

        Returns:
            The positions reached, each next to the one before; as far as they were before Ctrl-C.

        Raises:
            ModelError: unknown names, a first position that cannot be assembled, freedoms left.
            ArgumentError: values of a wrong shape. SolveError: values that are not finite; with
                ``check``, a mechanism that cannot follow.

        Warns:
            SolveWarning: the mechanism cannot follow; by strain energy, its energy is no longer least,
                or nothing strained resists some motion.
        """
    def singular_positions(
        self,
        coordinate: str,
        over: tuple[float, float],
        *,
        driver: str | None = None,
        locked: LockedValues | None = None,
        start: Mapping[str, ArrayLike] | ArrayLike | None = None,
        branch: Mapping[str, object] | None = None,
        step: float = 0.05,
        t: float = 0.0,
        r: State | None = None,
    ) -> Singular:
        """Find positions at which a driver is dead or branches meet, over a range of a coordinate.

        Args:
            coordinate: Followed from the first to the second end of the range, or until it returns.
            over: Its range.
            driver: Coordinate that drives; the same if left out.
            locked: Coordinates and frames that keep their values.
            start, branch: As ``assemble`` takes them.
            step: Along the path, in radians and sizes of the mechanism, up to pi.
            t, r: Time [s] and inputs, where something is prescribed.

        Raises:
            ModelError: unknown names, more than one freedom, no position at the start of the range.
            ArgumentError: no range, a step that no path can have.
        """
    def workspace(
        self,
        frame: str,
        *,
        over: Mapping[str, tuple[float, float]] | None = None,
        samples: Count = 1000,
        start: Mapping[str, ArrayLike] | ArrayLike | None = None,
        branch: Mapping[str, object] | None = None,
        seed: Seed = 0,
        t: float = 0.0,
        r: State | None = None,
    ) -> Workspace:
        """Places that the origin of a frame reaches: samples of coordinates, each assembled.

        Args:
            frame: Whose origin.
            over: Coordinate -> range that is sampled; the others follow from the loops, next to
                those of the nearest sample before. By default everything is drawn inside its limits.
            samples: How many.
            start: Coordinates of the first one.
            branch: Coordinate -> ``"+"``, ``"-"`` or ``(low, high)``, as ``assemble`` takes it.
            seed: Of the samples.
            t, r: Time [s] and inputs, where something is prescribed.

        Raises:
            ModelError: unknown names, or a mechanism that cannot be assembled.
            ArgumentError: no range, no samples.
        """
    def redundancy(
        self,
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        *,
        t: float = 0.0,
        r: State | None = None,
        s: State | None = None,
    ) -> Redundancy:
        """Find the redundant constraints of a closed system at a position.

        Args:
            q: An assembled position: coordinates (nq,) or by name; where the model starts if left out.
            t, r: Time [s] and inputs, where something is prescribed.
            s: Modes of elements (ns,) or by name, ``{"brake": 2}``; where a run begins if left out.
                What an element holds in other modes only does not count.

        Raises:
            ModelError: an unknown name.
        """
    def actuation(
        self,
        q: State,
        u: State,
        udot: State,
        actuators: Sequence[str] | None = None,
        *,
        norm: str | ArrayLike = "minimum",
        t: ArrayLike = 0.0,
        r: State | None = None,
        s: State | None = None,
        parameters: Values | None = None,
    ) -> Actuation:
        """Forces of actuators that make a motion: inverse dynamics of closed systems.

        Args:
            q, u, udot: A motion that the constraints allow (..., nq), (..., nu), (..., nu), as
                ``assemble`` and ``sweep`` give it.
            actuators: Joints or speeds along which they act; by default every speed.
            norm: Where more actuators than freedoms leave a choice: ``"minimum"``, the least sum of
                squares, or weights (na,) or a positive definite matrix W (na, na) for least cᵀ W c.
            t, r, parameters: Time, inputs and parameter values.
            s: Modes of elements (..., ns) or by name; those of a start if left out.

        Raises:
            ArgumentError: an unknown actuator; weights that are not positive.
            SolveError: the constraints do not allow the motion, or the actuators cannot make it.

        Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 8.
        """
    def hybrid_dynamics(
        self,
        q: State,
        u: State,
        udot: Mapping[str, ArrayLike],
        *,
        tau: State | None = None,
        t: ArrayLike = 0.0,
        r: State | None = None,
        s: State | None = None,
        parameters: Values | None = None,
    ) -> Actuation:
        """Some accelerations are given, the others follow, and so do the forces that it takes.

        Args:
            q, u: States on the constraints (..., nq), (..., nu).
            udot: Joint or speed -> its acceleration; actuators there provide what it takes.
            tau: Other generalized applied forces (..., nu).
            t, r, parameters: Time, inputs and parameter values.
            s: Modes of elements (..., ns) or by name; those of a start if left out.

        Raises:
            ArgumentError: an unknown joint or speed.
            SolveError: the constraints do not allow these accelerations together.

        Source: R. Featherstone, Rigid Body Dynamics Algorithms, section 9.1.
        """
    def partition(
        self,
        q: ArrayLike,
        *,
        t: float = 0.0,
        r: State | None = None,
    ) -> Partition:
        """Independent coordinates and speeds, chosen at a position: the minimal form.

        Args:
            q: Coordinates (nq,) that close all loops.
            t, r: Time [s] and inputs.

        Returns:
            A :class:`Partition`: ``reduce(x)`` gives y, ``full(t, y)`` gives x.

        Raises:
            ArgumentError: a wrong shape. SolveError: loops are open at this position.
        """
    def screw_axis(
        self,
        frame: str,
        q: State,
        u: State,
        *,
        t: Times = 0.0,
        r: State | None = None,
    ) -> ScrewAxis:
        """Instantaneous screw axis of a body or frame against the ground.

        Args:
            frame: Name of the frame or body.
            q, u: Coordinates (..., nq) and speeds (..., nu).
            t, r: Time [s] and inputs (..., nr), where something is prescribed.

        Returns:
            The axis at every state.

        Raises:
            ModelError: there is no such frame. ArgumentError: q or u has another shape.

        Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, chapter 4.
        """
    def reduced_rhs(
        self,
        t: float,
        y: ArrayLike,
        partition: Partition,
    ) -> Array:
        """Derivative (n,) of y = [independent coordinates, independent speeds] (n,).

        Args:
            t: Time [s].
            y: Of ``partition.reduce(x)``.
            partition: Chosen anew between steps where it becomes bad.
        """
    def residual(
        self,
        t: ArrayLike,
        q: State,
        u: State,
        udot: State,
        lam: ArrayLike = (),
        *,
        qdot: State | None = None,
        index: int = 3,
        tau: State | None = None,
        r: State | None = None,
        parameters: Values | None = None,
    ) -> Array:
        """[qdot - N u - n, M udot + h - f - tau - Gᵀ lam, constraints] (..., nq + nu + m).

        Args:
            t, q, u, udot: Time [s], coordinates (..., nq), speeds and their derivatives (..., nu).
            lam: Multipliers (..., m), in the order of ``model.multipliers_of``.
            qdot: Rates of the coordinates (..., nq); those of u if left out.
            index: Level of the constraints: 3, positions g (and velocities for those that have no
                positions, such as rolling); 2, velocities G u + g_t; 1, accelerations G udot - gamma.
            tau, r, parameters: As :meth:`CompiledModel.forward_dynamics` takes them.

        Raises:
            ArgumentError: another index.
        """
    def equilibrium(
        self,
        *,
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        u: Mapping[str, ArrayLike] | None = None,
        locked: LockedValues | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        stable: bool = False,
        check: bool = False,
    ) -> Equilibrium:
        """Equilibrium of a model under its forces, next to a start.

        Args:
            q: Coordinates to start from, by name or (nq,); the initial position if left out.
            u: Speeds by name of a steady motion: a rotor that spins, a regulator that turns. Those of
                other joints are 0, or follow from the constraints, and stay as they are; beams go
                along with what carries them. An empty one where prescribed motions turn all of it.
            locked: Coordinate -> value it keeps; the result tells the forces that takes.
            inputs, parameters: Values by name, else those of the model.
            t: Time [s], where something is prescribed.
            stable: Look for a stable one: downhill from the start.
            check: Raise where none is found, instead of warning.

        Returns:
            The equilibrium; where none was found the position that the search reached, ``converged``
            False.

        Raises:
            ModelError: unknown names, loops that cannot be assembled.
            SolveError: with ``check``, no equilibrium was found.
        """
    def statics(
        self,
        swept: Mapping[str, object] | None = None,
        *,
        steps: Count = 10,
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        locked: LockedValues | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        arc: bool = False,
        check: bool = False,
        **named: object,
    ) -> StaticPath:
        """Equilibria under loads that change: ``model.statics(P=(0, 10))``.

        Args:
            swept, named: Parameter or input (or ``t``) -> (start, end), in steps of the program's
                choice, or values (n,), each of which becomes a row. Several go together.
            steps: Rows of a range, more where the way is hard.
            q: Coordinates to start from, by name or (nq,).
            locked: Coordinate -> value that it keeps, or what is swept: displacements are prescribed.
            inputs, parameters: Values by name that stay, else those of the model.
            t: Time [s], where something is prescribed.
            arc: Follow the path by its length, through limit loads, where the load turns back;
                :func:`cardan.analyses.continuation.continuation.continuation` also tells branches.
            check: Raise where the end is not reached, instead of warning.

        Returns:
            The path as far as it goes, or came before Ctrl-C. Where it became unstable a warning says
            so, between which loads; ``crossings`` and ``critical()`` tell the places.

        Raises:
            ModelError: unknown names, nothing swept. ArgumentError: values of a wrong shape.
            SolveError: no equilibrium at the start; with ``check``, none further on.
        """
    def continuation(
        self,
        swept: Mapping[str, object] | None = None,
        *,
        of: str = "equilibria",
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        locked: LockedValues | None = None,
        u: Mapping[str, object] | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        until: Mapping[str, float] | None = None,
        bounds: Mapping[str, tuple[float, float]] | None = None,
        events: Mapping[str, float] | None = None,
        branches: int | bool = 0,
        search: int = 0,
        points: Count = 300,
        step: float | None = None,
        check: bool = False,
        progress: bool | Callable[[float], None] | None = None,
        start: object = None,
        **named: object,
    ) -> Continuation:
        """All equilibria that a load leads to, through limit loads: ``model.continuation(P=(0, 10))``.

        Or all cycles: ``model.continuation(slope=(0.01, 0.02), of="cycles", start=gait)``.

        Args:
            swept, named: Parameter, input or ``t`` -> (start, end). The path ends at the end, and may
                turn back and leave the range before. Several go together.
            of: What the path consists of: ``"equilibria"``; ``"cycles"``, motions that repeat; or
                ``"positions"`` of a mechanism without forces, of which coordinates are swept too:
                ``crank=(0, 6.28)``. Then folds are dead points, branches meet where loops lose rank,
                and full turns are the same position.
            q: Coordinates to start from, by name or (nq,).
            locked: Coordinate -> value it keeps, or (start, end): displacements are prescribed.
            u: Speed of a steady motion -> value it keeps, or (start, end): equilibria relative to what
                turns, as ``model.equilibrium(u=)`` finds them.
            inputs, parameters: Values by name that stay, else those of the model.
            t: Time [s], where something is prescribed.
            until: Name -> value at which the path ends as well: of a coordinate, an output, what is
                swept, or ``<coordinate>.holding_force``.
            bounds: Name -> (low, high): the path ends where it leaves that range.
            events: Name -> value: where it is passed is noted.
            branches: How many generations of branches to follow from branch points, and of cycles from
                period doublings; True for all.
            search: At how many loads, evenly up to the end, to look for solutions that no branch
                leads to, as an imperfection makes them; their branches are called ``"other ..."``.
            points: Points of a branch at most.
            step: Longest step, as a part of the size of the system, of a radian and of the range.
            check: Raise where the path ends in between, instead of warning.
            progress: Show a bar, by default on terminals; or a function of the part that is done.
            start: Of cycles: the cycle to start from, see ``model.cycle``, whose parameters and inputs
                stay; or a Hopf point of equilibria or a period doubling of cycles, at which others
                begin.

        Returns:
            The path and its branches, with folds, branch points, Hopf points and events in ``points``;
            what was found before Ctrl-C too.

        Raises:
            ModelError: unknown names, nothing swept. ArgumentError: values of a wrong shape.
            SolveError: no equilibrium at the start; with ``check``, a path that ends in between.

        Source: H. B. Keller, Applications of Bifurcation Theory (1977), 359-384; M. Géradin, A.
        Cardona, Flexible Multibody Dynamics (2001), chapter 9.
        """
    def stability_chart(
        self,
        along: Mapping[str, object],
        across: Mapping[str, object],
        *,
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        locked: LockedValues | None = None,
        u: Mapping[str, object] | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        points: Count = 300,
        progress: bool | Callable[[float], None] | None = None,
    ) -> StabilityChartRecord:
        """Boundaries at which equilibria lose their stability, over two parameters.

        ``model.stability_chart({"P": (0, 10)}, {"damping": np.linspace(0, 1, 20)})`` follows the
        equilibria over P at every value of the damping.

        Args:
            along: Parameter, input or speed -> (start, end), as ``model.continuation`` takes it; a
                speed is one of those in ``u``.
            across: Parameter -> values (n,).
            q, locked, u, inputs, parameters, t, points: As ``model.continuation`` takes them.
            progress: Show a bar; by default where standard error is a terminal.

        Returns:
            The chart; after Ctrl-C with the paths that were found.

        Raises:
            ModelError: unknown names, or none. SolveError: no equilibrium at any start.
        """
    def fit(
        self,
        data: object,
        *,
        unknown: str | Sequence[str],
        measured: Mapping[str, object] | None = None,
        noise: float | Mapping[str, float] | None = None,
        bounds: Mapping[str, Sequence[float]] | None = None,
        loss: str = "linear",
        segments: str | int = "auto",
        seeds: str | Identification | None = None,
        q: Values | ArrayLike | None = None,
        u: Values | ArrayLike | None = None,
        z: Values | ArrayLike | None = None,
        inputs: Inputs | None = None,
        parameters: Values | None = None,
        method: str = "auto",
        rtol: float = 1e-09,
        most: int = 60,
        progress: bool | Callable[[float], None] | None = None,
    ) -> Fit:
        """Parameters and the start of a motion from measurements, by multiple shooting.

        ``fit = model.fit("run.csv", unknown=("m2", "damping", "q0"), measured={"hand.z": "z"})``

        Args:
            data: A mapping with the times ``t`` (nt,) and columns (nt,), or a file .csv; NaN where
                nothing was measured.
            unknown: Names of parameters, and of starts as :meth:`gradient` takes them: ``"q0"``,
                ``"u0"``, ``"x0"``, ``"q0.elbow"``.
            measured: Formula in names of the model -> column, or its values (nt,); by default the
                columns that are coordinates, speeds and outputs.
            noise: Standard deviation of measurements, one number or by formula; its ratios weigh them.
            bounds: Parameter -> (least, most).
            loss: ``"linear"`` for least squares, ``"huber"`` where some samples are wrong.
            segments: Number of runs that the motion is divided into; ``"auto"``: as many as errors
                grow by e^2, and as leave what was measured, at most one for every eight samples and 60.
            seeds: ``"identify"``: unknown masses, inertias and coefficients of forces begin with what
                :meth:`identify` says of the measured coordinates and the inputs, however far off their
                values are; or an identification, such as ``model.identify(data, cutoff=10)``.
            q, u, z: Start at the first sample, where the search begins; what is not unknown stays. In
                absolute coordinates by names of joints, which nodes follow.
            inputs: As :meth:`simulate` takes them; else columns of data with their names.
            parameters, rtol, progress: As :meth:`simulate` takes them.
            method: As of :meth:`gradient`: ``"auto"`` takes DOP853, of elements Radau.
            most: Iterations.

        Returns:
            A fit: ``parameters``, ``standard_errors``, ``interval(name)``, ``residuals``, ``motion``.

        Raises:
            ArgumentError, ModelError: data or names that do not fit, and what has no gradient.
                SolveError: no run from where the search begins.

        Source: Bock (1983).
        """
    def gradient(
        self,
        t: float | Sequence[float],
        cost: Cost,
        *,
        wrt: str | Sequence[str] = ('x0', 'p'),
        x0: ArrayLike | None = None,
        q: Values | ArrayLike | None = None,
        u: Values | ArrayLike | None = None,
        z: Values | ArrayLike | None = None,
        events: Mapping[str, object] | None = None,
        method: str | GeneralizedAlpha | Alpha = "auto",
        rtol: float = 1e-09,
        atol: float | None = None,
        step: float | None = None,
        max_step: float | None = None,
        inputs: Inputs | None = None,
        parameters: Values | None = None,
        vary: Plan | Mapping[str, object] | None = None,
        runs: Count | None = None,
        seed: Seed = 0,
        memory: float = 1000000000.0,
        progress: bool | Callable[[float], None] | None = None,
    ) -> Gradient:
        """The gradient of a cost of a motion, through its events, by any number of unknowns.

        ``value, slope = model.gradient(2.0, cd.cost(final="(hand.x - 0.4)^2"), wrt=("q0", "m"))``

        Args:
            t: End time (from 0), or ``(start, end)`` [s].
            cost: The cost, see :func:`cardan.cost`.
            wrt: ``"x0"``, ``"q0"``, ``"u0"``, ``"z0"``: the start; ``"q0.elbow"``, ``"u0.elbow"``: of a
                joint, along its speeds; ``"p"``: all parameters; names of parameters and inputs. Of an
                input ``(times, values)`` the gradient is by the values.
            x0, q, u, z, events, rtol, atol, step, max_step, inputs, parameters, progress: As
                :meth:`simulate` takes them.
            vary, runs, seed: What differs between several runs, as :meth:`ensemble` takes it; then x0,
                q, u, z, parameters and inputs may have values per run too.
            memory: Bytes for the rows of the steps. Where they do not fit, checkpoints are made and
                steps are repeated, to the same bits; ``note`` of the result says how often.
            method: As :meth:`simulate` takes it, but Rosenbrock; ``"auto"`` takes DOP853, of
                elements Radau.

        Returns:
            A :class:`cardan.Gradient`: ``value``, ``slope`` by name, ``motion``. Of Runge-Kutta methods
            it is exact for the steps that were taken; of others it is that of the exact motion beside
            the computed one. Either way its error is that of the motion. After Ctrl-C several runs have
            NaN where they were not done, and warn.

        Raises:
            ModelError, ArgumentError: as :meth:`simulate`, and a method or an input whose derivative is
                not known; memory= that holds nothing. SolveError: the run ends early, or has no
                derivative: two events at one time, an event that happens by a touch.
        """
    def cycle(
        self,
        start: Mapping[str, ArrayLike] | ArrayLike,
        *,
        period: object = None,
        section: object = None,
        where: object = None,
        crossing: Count = 1,
        symmetry: object = None,
        laps: Count = 1,
        settle: int = 0,
        guess: float | None = None,
        inputs: Mapping[str, object] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        longest: float = 100.0,
        method: str = "DOP853",
        rtol: float = 1e-13,
        atol: float = 1e-15,
        check: bool = False,
    ) -> Cycle:
        """A motion that repeats, next to a start: ``model.cycle({"x": 1.0}, period=2 * np.pi / 1.4)``.

        A lap ends after ``period``, where something forces the motion at known times; at the event
        ``section``; or where it comes back, with an unknown period. Laps run through events and
        impacts.

        Args:
            start: State to begin the search with, by name (others as in ``simulate``), or (nx,).
            period: Of a lap [s]; a function of the parameters and inputs by name, or a SymPy expression
                in parameters. None: unknown, or that of the section.
            section: The event that ends a lap: its name, or what ``events=`` of ``simulate`` takes such
                as ``("elbow", 0.5)``, with a direction ``(("elbow", 0.5), "up")``.
            where: What must hold before that event: name -> (low, high), or a function of the named
                state that returns True.
            crossing: Which of the events that fulfill it ends a lap, counted from 1.
            symmetry: What the state behind a lap becomes: name -> the name whose value it takes,
                ``(name, factor)`` or ``(name, factor, shift)``, speeds along with coordinates,
                exchanged where named once; or a function of the named state that returns what changes.
            laps: After how many laps the motion repeats.
            settle: Laps to run before the search, by which a stable cycle is approached.
            guess: Of an unknown period [s]; by default that of the first return.
            inputs: Constants, or functions f(t, x) with the period, by name.
            parameters: Values by name, else those of the model.
            t: Time at which laps begin [s]; of laps that time ends not that of an impact.
            longest: Time within which a lap must end [s].
            method, rtol, atol: Of the runs; ``cycle.derivatives`` says whether those are exact.
            check: Raise where no cycle is reached, instead of warning.

        Returns:
            The cycle, with its multipliers and its motion.

        Raises:
            ModelError: unknown names, a period besides a section, laps of a model that time drives
                without a period. ArgumentError: wrong shapes.
            SolveError: the first lap breaks down or does not end; with ``check``, no cycle.

        Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), chapter 7; P. Holmes,
        R. J. Full, D. Koditschek, J. Guckenheimer, SIAM Review 48 (2006), 207-304 (return maps).
        """
    def trim(
        self,
        targets: Mapping[str, float] | None = None,
        *,
        free: Iterable[str] = (),
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        u: Mapping[str, ArrayLike] | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        check: bool = False,
    ) -> SteadyMotion:
        """A steady motion, or a rest, with target values, and what it takes.

        Args:
            targets: Coordinates, speeds and outputs by name -> the value they are to have.
            free: What may change for that: inputs, parameters, speeds (``"spin.u"``), and forces along
                speeds (``"elbow.driving_force"``). Coordinates are free anyway.
            q: Coordinates to start from, by name or (nq,).
            u: Speeds by name, as they stay, or start where they are free; others are 0 or follow.
            inputs, parameters: Values by name, as they stay, or start where they are free.
            t: Time [s], where something is prescribed.
            check: Raise where there is none, instead of warning.

        Returns:
            The motion; where none was found what the search reached, ``converged`` False.

        Raises:
            ModelError: unknown names, loops that cannot be assembled, beams.
            SolveError: with ``check``, there is none, or free values are left over.
        """
    def linearize(
        self,
        x: ArrayLike | Equilibrium | None = None,
        *,
        q: State | None = None,
        u: State | None = None,
        z: State | None = None,
        inputs: Iterable[str] | None = None,
        outputs: Iterable[str] | None = None,
        r: State | None = None,
        t: float = 0.0,
        parameters: Mapping[str, float] | None = None,
        choice: Choice | None = None,
    ) -> LinearModel:
        """x' = A x + B r, y = C x + D r about a state, constraints eliminated.

        About a state that is neither an equilibrium nor in steady motion the matrices are those of the
        motion that starts there by itself, as of ``equations.linearize(..., udot="free")``.

        Args:
            x: State (nx,), an equilibrium or a trimmed motion; or q, u, z: by name or as arrays,
                assembled as runs assemble them. If all are left out the equilibrium next to the initial
                position.
            inputs: Inputs, or speeds and joints along which a force acts; all inputs if left out.
            outputs: Outputs, coordinates and speeds; if left out the declared outputs, or all
                coordinates if there are none.
            r: Inputs by name or (nr,) [of the state]. t: Time [s].
            parameters: Values by name, else those of the model.
            choice: Independent increments and speeds, as ``choice`` of another linear model has them.

        Returns:
            Independent increments, speeds, then internal states; with names.

        Raises:
            ModelError: unknown names, loops that cannot be assembled.
            SolveError: accelerations are not determined there.
        """
    def modes(
        self,
        count: Count | None = None,
        x: ArrayLike | Equilibrium | None = None,
        *,
        q: State | None = None,
        u: State | None = None,
        r: State | None = None,
        t: float = 0.0,
        parameters: Mapping[str, float] | None = None,
        damped: bool = True,
    ) -> Modes:
        """Modes about an equilibrium or a steady motion, from the lowest frequency.

        Args:
            count: How many; all of a small system if left out.
            x: State (nx,), or an equilibrium, whose loads then prestress; or q, u by name or as
                arrays. If all are left out the equilibrium next to the initial position.
            r: Inputs by name or (nr,). t: Time [s]. parameters: Values by name.
            damped: Whether dampers act. False holds at rest only, where modes are then real.

        Raises:
            ModelError: unknown names, a count that is none, ``damped=False`` in motion.
            SolveError: the mass matrix is singular on what constraints allow.
        """
    def root_locus(
        self,
        swept: Mapping[str, object] | None = None,
        *,
        count: Count | None = None,
        coordinates: Iterable[str] | None = None,
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        u: Mapping[str, object] | None = None,
        locked: LockedValues | None = None,
        targets: Mapping[str, object] | None = None,
        free: Iterable[str] | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        check: bool = False,
        **named: Any,
    ) -> Locus:
        """Eigenvalues as something changes: ``model.root_locus(P=(0, 10))``.

        Args:
            swept, named: Parameter, input, ``t``, or joint whose speed it is -> (start, end), or values
                (n,). Several go together.
            count: Members of a range; 31 if left out.
            coordinates: Those whose motions count, if their equations are closed: lean and steer of a
                bicycle. All if left out.
            q, u, locked, inputs, parameters, t: As ``equilibrium`` takes them; arrays in ``u`` and
                ``locked`` are swept too.
            targets, free: As ``trim`` takes them, which finds the members then (no ``locked``);
                arrays in ``targets`` are swept too.
            check: Raise where the end is not reached, instead of warning.

        Returns:
            Eigenvalues followed from member to member, and where stability changes.

        Raises:
            ModelError: unknown names, nothing that changes. ArgumentError: values of a wrong shape.
            SolveError: no equilibrium or steady motion at the start; with ``check``, further on.
        """
    def campbell(
        self,
        swept: Mapping[str, object] | None = None,
        *,
        count: Count | None = None,
        corotating: bool | None = None,
        q: Mapping[str, ArrayLike] | ArrayLike | None = None,
        u: Mapping[str, object] | None = None,
        locked: LockedValues | None = None,
        targets: Mapping[str, object] | None = None,
        free: Iterable[str] | None = None,
        inputs: Mapping[str, float] | None = None,
        parameters: Mapping[str, float] | None = None,
        t: float = 0.0,
        check: bool = False,
        **named: Any,
    ) -> Campbell:
        """Frequencies of a rotor over its speed: ``model.campbell(spin=(0, 300))``.

        Args:
            swept, named: Joint, parameter or input that is the speed -> (start, end) or values (n,)
                [rad/s]. The first is the speed, others go together with it.
            count: Members of a range; 31 if left out.
            corotating: Whether coordinates turn along with the rotor; by default those of scenes with
                beams do, others do not.
            q, u, locked, targets, free, inputs, parameters, t: As ``root_locus`` takes them.
            check: Raise where the end is not reached, instead of warning.

        Raises:
            As ``root_locus``.
        """
    def sensitivity(
        self,
        parameters: Iterable[str] | str,
        about: Equilibrium | SteadyMotion | None = None,
    ) -> Sensitivity:
        """Derivatives of eigenvalues by parameters, the motion moving along with them.

        Args:
            parameters: Their names.
            about: An equilibrium, a steady motion or a trim, found anew for every value; that next to
                the initial position if left out.

        Raises:
            ModelError: unknown names, or something that is no such motion.
            SolveError: there is no such motion beside it.
        """
    def stiffness(
        self,
        x: ArrayLike,
        t: float = 0.0,
        r: State | None = None,
        s: State | None = None,
    ) -> Stiffness:
        """Rates of a model at a state, from about twenty evaluations of ``rhs``.

        Args:
            x: State [q, u, z] (nx,).
            t: Time [s].
            r: Inputs (nr,), taken as constant. s: Modes (ns,).

        Raises:
            SolveError: there, or close to it, the model has no accelerations.
        """
    def beam(
        self,
        name: str,
        q: State,
    ) -> BeamStress:
        """Forces, moments and strains along a beam, in axes of the section.

        Args:
            name: Of the beam.
            q: Coordinates (..., nq), such as those of an equilibrium.

        Raises:
            ModelError: there is no such beam. ArgumentError: q has another shape.
        """
    def superelement(
        self,
        name: str,
        q: State,
        *,
        t: float = 0.0,
        r: State | None = None,
    ) -> DeformedSuperelement:
        """A superelement with its deformation: positions and stress at points of its surface.

        Args:
            name: Of the superelement.
            q: Coordinates (..., nq), such as those of an equilibrium.
            t, r: Time [s] and inputs (nr,), on which loads may depend; those of the model by default.

        Raises:
            ModelError: there is no such superelement. ArgumentError: q has another shape.
        """
    def superelement_parts(
        self,
        name: str,
        q: State,
        u: State | None = None,
        udot: State | None = None,
    ) -> SuperelementParts:
        """Forces of a superelement and their derivatives by name: gyroscopic ones, and so on.

        Args:
            name: Of the superelement.
            q: Coordinates (nq,).
            u, udot: Speeds and accelerations (nu,), 0 by default.

        Returns:
            Parts of forces, M, C and K.

        Raises:
            ModelError: there is no such superelement. ArgumentError: a block has another shape.

        Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 8.7.2.
        """
    def cable(
        self,
        name: str,
        q: State,
        u: State | None = None,
        *,
        t: Times = 0.0,
        r: State | None = None,
    ) -> CableTension:
        """Tension along a cable.

        Args:
            name: Of the cable.
            q, u: Coordinates (..., nq) and speeds (..., nu); u is 0 unless given.
            t, r: Time [s] and inputs (..., nr), where something is prescribed.

        Returns:
            Its tension in every element (..., n) [N].

        Raises:
            ArgumentError: there is no such cable.
        """
    def torques(
        self,
        motion: Any,
        *,
        actuators: Sequence[str] | None = None,
        norm: Any = "minimum",
        inputs: Mapping[str, float] | None = None,
        cutoff: float | None = None,
        period: float | None = None,
        harmonics: Count = 5,
    ) -> Torques:
        """Forces that make a motion, beside those that the model's own elements supply.

        Args:
            motion: A Trajectory; or a mapping with ``t`` (nt,) and ``q`` (nt, nq), or a coordinate by
                name, ``{"t": t, "elbow": values}``: an array (nt,), or a spline or table, which is
                called with the times. ``u`` and ``udot`` are found by differentiation where they are
                missing, and from the equations of motion where a run knows them. Of a mechanism with
                loops the motion must keep them closed, as runs and :meth:`sweep` do.
            actuators: Joints or speeds along which they act; by default every speed.
            norm: Where loops leave a choice: ``"minimum"`` or weights, as for ``actuation``.
            inputs: Values of inputs in place of those of the motion: ``{"motor": 0}`` asks what it
                takes without the motor.
            cutoff, period, harmonics: How positions are smoothed; see
                :func:`.identification.data.measured`. A filter leaves out samples at either end; all
                others keep the times given.

        Raises:
            ArgumentError: names or shapes that do not fit.
            SolveError: the constraints do not allow the motion, or the actuators cannot make it.
        """
    def base_parameters(
        self,
        rows: ArrayLike | None = None,
        *,
        seed: Seed = 0,
        rank: float = 1e-09,
    ) -> Base:
        """Base parameters of a model.

        Args:
            rows: Regressors (..., n) to judge by, such as those of a motion; by default at random
                states.
            seed: Of the states.
            rank: What must be left of a column, relative to it, to be independent.

        Raises:
            SolveError: a system with loops and no rows; a rank that is not certain.
        """
    def excitation(
        self,
        period: float = 10.0,
        *,
        harmonics: Count = 5,
        position: Mapping[str, tuple[float, float]] | None = None,
        speed: Mapping[str, float] | float | None = None,
        acceleration: Mapping[str, float] | float | None = None,
        criterion: str = "condition",
        starts: Count = 20,
        steps: int = 30,
        seed: Seed = 0,
        progress: bool | Callable[[float], None] | None = None,
    ) -> Excitation:
        """A periodic motion within limits at which the base regressor is well conditioned.

        Args:
            period: Of the motion [s].
            harmonics: Of its Fourier series.
            position: Coordinate -> (lower, upper), in place of the limits of the joint; by default a
                turn where a joint has none.
            speed, acceleration: Most of every joint, or by name; by default the limits of the joint,
                2 rad/s or m/s where it has none, and any acceleration.
            criterion: ``"condition"`` of the regressor with columns scaled to length 1, or
                ``"determinant"``: -log det of the information per parameter.
            starts: Motions by chance, of which the best is improved.
            steps: Of the search.
            seed: Of the motions by chance: the same seed finds the same motion.
            progress: As for ``simulate``.

        Raises:
            ArgumentError: limits or words that do not exist.
            SolveError: joints that are not moved one by one: loops, a free base, ball joints.
        """
    def identify(
        self,
        data: Any,
        *,
        form: str = "torque",
        noise: float | Mapping[str, float] | ArrayLike | None = None,
        cutoff: float | None = None,
        period: float | None = None,
        harmonics: Count = 5,
        actuators: Sequence[str] | None = None,
        base: Base | None = None,
        stretch: Count = 10,
    ) -> Identification:
        """Base parameters of a model from data, by weighted least squares.

        Args:
            data: A Trajectory, a file (of a saved run, or .csv), or a mapping with ``t`` and ``q``,
                ``u``, ``udot``, ``tau``, ``r`` or their columns; speeds and accelerations that are
                missing are found by differentiation. See :func:`.data.measured`.
            form: ``"torque"``: forces at every sample; ``"energy"``: what stretches of the motion have
                gained, which needs no accelerations but keeps less of the information.
            noise: Standard deviation of measured forces, one number or by speed or joint; None: from
                the residuals, for every joint its own.
            cutoff: [Hz] of a low-pass filter without delay on positions, forces and regressor.
            period, harmonics: Of a periodic motion [s]: positions become a Fourier series.
            actuators: Speeds or joints whose forces were measured; all by default. Those of others are
                0 and tell nothing here. With loops as many as freedoms.
            base: Of an earlier call, for the same combinations.
            stretch: Steps of a row of energy, an even number.

        Raises:
            ArgumentError: data that do not fit the model; unknown words.
            SolveError: the data do not tell all base parameters.
        """
    def to_jax(
        self,
        function: str | tuple[str, str],
    ) -> Callable[..., Any]:
        """A function of the model for JAX, with exact first derivatives in both modes.

        ``jax.grad(lambda m: model.to_jax("rhs")(0.0, x, parameters={"m": m})[3])(2.0)``

        It goes with ``jax.jit``, ``jax.vmap`` (one call for all states), ``jax.grad``, ``jax.jacfwd``
        and ``jax.jacrev``, on CPUs and in float64. Every call goes through Python, 0.3 ms: exports are
        quicker, ``equations.export(language="jax")``. A unit quaternion counts by its direction.

        Args:
            function: Such as ``"forward_dynamics"``, or ``("pose", "hand")``: one that has derivatives.

        Returns:
            A function of the same arguments, arrays whose leading axes broadcast. ``r`` and
            ``parameters`` may be mappings of names to numbers, the rest then those of the model. What
            has no solution is not a number.

        Raises:
            ModuleNotFoundError: JAX is not installed.
            ModelError: no such function, or it has no derivatives.
        """
    def to_torch(
        self,
        function: str | tuple[str, str],
    ) -> Callable[..., Any]:
        """A function of the model for PyTorch, with exact first derivatives.

        ``model.to_torch("forward_dynamics")(q, u, tau=tau).sum().backward()``

        It is a ``torch.autograd.Function`` and goes with ``backward``, forward mode, ``torch.func`` and
        its ``vmap`` (one call for all states), on the CPU. A unit quaternion counts by its direction.

        Args:
            function: Such as ``"forward_dynamics"``, or ``("pose", "hand")``: one that has derivatives.

        Returns:
            A function of the same arguments, tensors or numbers whose leading axes broadcast. ``r`` and
            ``parameters`` may be mappings of names to numbers, the rest then those of the model.
            Results are float64. What has no solution is not a number.

        Raises:
            ModuleNotFoundError: PyTorch is not installed.
            ModelError: no such function, or it has no derivatives.
        """
    def verify(
        self,
        states: Count = 3,
        seed: Seed = 1,
    ) -> Verification:
        """Compare the C with an independent NumPy Newton-Euler; see :mod:`.verify`.

        Raises:
            BuildError: they differ.
        """
    def _verify_built(
        self,
        fresh: Iterable[Key],
    ) -> bool:
        """Check functions that were compiled just now, or of which nobody knows what a check said.

        Returns:
            Whether accelerations have digits: False with a warning where the mass matrix is singular.

        Raises:
            BuildError: a function is wrong.
        """
    def _verify_elements(
        self,
        elements: Elements,
        fresh: Iterable[str],
    ) -> None:
        """Check functions of elements that were compiled just now.

        Args:
            model, elements: Whose.
            fresh: Names of the functions.

        Raises:
            BuildError: one is wrong.
        """
    def _undetermined(
        self,
        joint: str,
        lead: tuple[int, ...],
        q: State,
        t: ArrayLike,
        r: State | None,
        parameters: Values | None,
    ) -> Undetermined | None:
        """The states at which the reaction of a joint is not determined; None where all determine it.

        The first, the middle and the last state at which constraints have their largest rank tell it
        for all of these; where they have less each tells it for itself. In absolute coordinates, whose
        Jacobians are large, only the first, the middle and the last state of a call are looked at. A
        warning names the joints, each once.

        Args:
            joint: Whose reaction was asked for.
            lead, q, t, r, parameters: As of :class:`States`.
        """
