"""Analyses that a compiled model offers as methods; each is one function further down."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from numpy.typing import ArrayLike

from ..arguments import checked
from ..arrays import Array
from .evaluation import State
from .identified import Identified

if TYPE_CHECKING:
    from ..analyses.actuation import Actuation
    from ..analyses.assembly import Assembly
    from ..analyses.campbell import Campbell
    from ..analyses.ensembles import Ensemble
    from ..analyses.equilibrium import Equilibrium
    from ..analyses.linear_model import LinearModel
    from ..analyses.locus import Locus
    from ..analyses.mode_shapes import Modes
    from ..analyses.reduced import Partition
    from ..analyses.redundancy import Redundancy
    from ..analyses.sensitivity import Sensitivity
    from ..analyses.singular import Singular
    from ..analyses.static_path import StaticPath
    from ..analyses.steady_motion import SteadyMotion
    from ..analyses.stiffness import Stiffness
    from ..analyses.sweep import Sweep
    from ..analyses.workspace import Workspace
    from .absolute.beams import BeamStress
    from .compiled import CompiledModel


class Analyzed(Identified):
    """A model with analyses of its circuits."""

    _doubted: set[str]

    @property
    def _itself(self) -> CompiledModel:
        return cast("CompiledModel", self)

    def _doubt(self, joint: str, q: State, t: ArrayLike, r: State | None) -> None:
        """Warn once where redundant constraints leave the reaction of a joint undetermined."""
        if joint in self._doubted:
            return
        self._doubted.add(joint)
        if self.manifest.multipliers or self.manifest.cuts:
            from ..analyses.redundancy import doubt

            doubt(self._itself, joint, q, t, r)

    def assemble(self, targets: Mapping[str, Any] | None = None, **options: Any) -> Assembly:
        """A state at which circuits close and targets are met: assembly, inverse kinematics.

        Args:
            targets: ``{"crank": 0.3, "hand": [x, y, z]}``: coordinates, positions (3,) or poses
                (4, 4) of frames.
            options: ``u``, ``udot``, ``weights``, ``hold``, ``branch``, ``start``, ``starts``,
                ``seed``, ``t``, ``r``; see :func:`cardan.analyses.assemble.assemble`.
        """
        from ..analyses.assemble import assemble

        return assemble(self._itself, targets, **options)

    def sweep(
        self,
        driver: str | Mapping[str, ArrayLike],
        values: ArrayLike | None = None,
        **options: Any,
    ) -> Sweep:
        """Positions, speeds and accelerations of a driven mechanism.

        Args:
            driver: Coordinate or prescribed input that is driven through ``values`` (n,); or
                several, ``{"left": values, "right": values}``.
            values: Of the one driver.
            options: ``rate``, ``acceleration``, ``hold``, ``start``, ``branch``, ``t``, ``r``,
                ``check``; see :func:`cardan.analyses.sweep.sweep`.
        """
        from ..analyses.sweep import sweep

        return sweep(self._itself, driver, values, **options)

    def singular_positions(
        self, coordinate: str, over: tuple[float, float], **options: Any
    ) -> Singular:
        """Dead points of a driver, and positions where branches meet, as a coordinate moves.

        Args:
            coordinate: What moves the mechanism.
            over: Its range.
            options: ``driver``, ``hold``, ``start``, ``branch``, ``step``, ``t``, ``r``; see
                :func:`cardan.analyses.singular.singular_positions`.
        """
        from ..analyses.singular import singular_positions

        return singular_positions(self._itself, coordinate, over, **options)

    def workspace(self, frame: str, **options: Any) -> Workspace:
        """Places that a frame reaches.

        Args:
            frame: Its origin is followed.
            options: ``over``, ``samples``, ``start``, ``branch``, ``seed``, ``t``, ``r``; see
                :func:`cardan.analyses.workspace.workspace`.
        """
        from ..analyses.workspace import workspace

        return workspace(self._itself, frame, **options)

    def redundancy(
        self, q: Mapping[str, ArrayLike] | ArrayLike | None = None, **options: Any
    ) -> Redundancy:
        """Which constraints say the same twice at a position, and what that leaves undetermined.

        Args:
            q: An assembled position; where the model starts if left out.
            options: ``t``, ``r``; see :func:`cardan.analyses.redundancy.redundancy`.
        """
        from ..analyses.redundancy import redundancy

        return redundancy(self._itself, q, **options)

    def actuation(
        self, q: Any, u: Any, udot: Any, actuators: Sequence[str] | None = None, **options: Any
    ) -> Actuation:
        """Forces of actuators that make a motion: inverse dynamics of closed systems.

        Args:
            q, u, udot: A motion that the constraints allow (..., nq), (..., nu), (..., nu).
            actuators: Joints or speeds along which they act; by default every speed.
            options: ``norm``, ``t``, ``r``, ``parameters``; see
                :func:`cardan.analyses.actuation.actuation`.
        """
        from ..analyses.actuation import actuation

        return actuation(self._itself, q, u, udot, actuators, **options)

    def hybrid_dynamics(
        self, q: Any, u: Any, udot: Mapping[str, ArrayLike], **options: Any
    ) -> Actuation:
        """Accelerations that follow from given ones, and the forces that these take.

        Args:
            q, u: States on the constraints (..., nq), (..., nu).
            udot: Joint or speed -> its acceleration.
            options: ``tau``, ``t``, ``r``, ``parameters``; see
                :func:`cardan.analyses.actuation.hybrid_dynamics`.
        """
        from ..analyses.actuation import hybrid_dynamics

        return hybrid_dynamics(self._itself, q, u, udot, **options)

    def equilibrium(self, **options: Any) -> Equilibrium:
        """Where the model rests under its forces, next to a start.

        Args:
            options: ``q``, ``u``, ``hold``, ``inputs``, ``parameters``, ``t``, ``stable``,
                ``check``; see :func:`cardan.analyses.equilibrium.equilibrium`.
        """
        from ..analyses.equilibrium import equilibrium

        return equilibrium(self._itself, **options)

    def statics(self, swept: Mapping[str, Any] | None = None, **options: Any) -> StaticPath:
        """Equilibria under loads that change: ``model.statics(P=(0, 10))``.

        Args:
            swept: Parameter or input -> (start, end) or values (n,); also as keywords.
            options: ``steps``, ``q``, ``hold``, ``inputs``, ``parameters``, ``t``, ``check``; see
                :func:`cardan.analyses.statics.statics`.
        """
        from ..analyses.statics import statics

        return statics(self._itself, swept, **options)

    def linearize(self, x: Any = None, **options: Any) -> LinearModel:
        """Linear model about a state or equilibrium: ``.A .B .C .D`` with names, eigenvalues.

        Args:
            x: State (nx,) or an equilibrium; if nothing is given, that next to the start.
            options: ``q``, ``u``, ``z``, ``inputs``, ``outputs``, ``r``, ``t``, ``parameters``;
                see :func:`cardan.analyses.linearize.linearize`.
        """
        from ..analyses.linearize import linearize

        return linearize(self._itself, x, **options)

    def trim(self, wanted: Mapping[str, float] | None = None, **options: Any) -> SteadyMotion:
        """A steady motion with wanted values, and the inputs, parameters and forces it takes.

        Args:
            wanted: Coordinates, speeds and outputs by name -> value.
            options: ``free``, ``q``, ``u``, ``inputs``, ``parameters``, ``t``, ``check``; see
                :func:`cardan.analyses.trim.trim`.
        """
        from ..analyses.trim import trim

        return trim(self._itself, wanted, **options)

    def root_locus(self, swept: Mapping[str, Any] | None = None, **options: Any) -> Locus:
        """Eigenvalues as parameters, inputs or speeds change: ``model.root_locus(P=(0, 10))``.

        Args:
            swept: Parameter, input or joint whose speed it is -> (start, end) or values (n,); also
                as keywords.
            options: ``count``, ``coordinates``, ``q``, ``u``, ``hold``, ``wanted``, ``free``,
                ``inputs``, ``parameters``, ``t``, ``check``; see
                :func:`cardan.analyses.locus.root_locus`.
        """
        from ..analyses.locus import root_locus

        return root_locus(self._itself, swept, **options)

    def campbell(self, swept: Mapping[str, Any] | None = None, **options: Any) -> Campbell:
        """Frequencies of a rotor over its speed: ``model.campbell(spin=(0, 300))``.

        Args:
            swept: Joint, parameter or input that is the speed -> (start, end) or values (n,)
                [rad/s]; also as a keyword.
            options: ``count``, ``turning``, ``q``, ``u``, ``hold``, ``wanted``, ``free``,
                ``inputs``, ``parameters``, ``t``, ``check``; see
                :func:`cardan.analyses.campbell.campbell`.
        """
        from ..analyses.campbell import campbell

        return campbell(self._itself, swept, **options)

    @checked
    def sensitivity(self, parameters: Any, about: Any = None) -> Sensitivity:
        """Derivatives of eigenvalues by parameters, the motion moving along with them.

        Args:
            parameters: Their names.
            about: An equilibrium or a trimmed motion; if left out that next to the start.
        """
        from ..analyses.sensitivity import sensitivity

        return sensitivity(self._itself, parameters, about)

    def modes(self, count: int | None = None, x: Any = None, **options: Any) -> Modes:
        """Frequencies, damping and shapes about an equilibrium or a steady motion.

        Args:
            count: How many, from the lowest frequency; all of a small system if left out.
            x: State (nx,) or an equilibrium; if nothing is given, that next to the start.
            options: ``q``, ``u``, ``r``, ``t``, ``parameters``, ``damped``; see
                :func:`cardan.analyses.modes.modes`.
        """
        from ..analyses.modes import modes

        return modes(self._itself, count, x, **options)

    def stiffness(self, x: ArrayLike, t: float = 0.0, **options: Any) -> Stiffness:
        """The fastest rate at a state against the rate of the motion: whether implicit methods pay.

        Args:
            x: State [q, u, z] (nx,). t: Time [s].
            options: ``r``, ``s``; see :func:`cardan.analyses.stiffness.stiffness`.
        """
        from ..analyses.stiffness import stiffness

        return stiffness(self._itself, x, t, **options)

    @checked
    def beam(self, name: str, q: State) -> BeamStress:
        """Forces, moments and strains along a beam, in axes of the section.

        Args:
            name: Of the beam.
            q: Coordinates (..., nq), such as those of an equilibrium.

        Raises:
            ModelError: there is no such beam. ArgumentError: q has another shape.
        """
        from .absolute.beams import beam_stress

        return beam_stress(self._itself, name, q)

    @checked
    def partition(self, q: ArrayLike, *, t: float = 0.0, r: State | None = None) -> Partition:
        """Independent coordinates and speeds, chosen at a position: the minimal form.

        Args:
            q: Coordinates (nq,) that close all circuits.
            t, r: Time [s] and inputs.

        Returns:
            A :class:`cardan.analyses.reduced.Partition`: ``reduce(x)`` gives y, ``full(t, y)``
            gives x.
        """
        from ..analyses.reduced import Partition

        return Partition(self._itself, q, t, r)

    @checked
    def reduced_rhs(self, t: float, y: ArrayLike, partition: Partition) -> Array:
        """Derivative (n,) of y = [independent coordinates, independent speeds] (n,).

        Args:
            t: Time [s].
            y: Of ``partition.reduce(x)``.
            partition: Of :meth:`partition`; chosen anew between steps where it becomes bad.
        """
        return partition.rhs(t, y)

    def residual(
        self,
        t: ArrayLike,
        q: Any,
        u: Any,
        udot: Any,
        lam: ArrayLike = (),
        *,
        qdot: Any = None,
        index: int = 3,
        **options: Any,
    ) -> Array:
        """[qdot - N u - n, M udot + h - f - tau - Gᵀ lam, constraints] (..., nq + nu + m).

        Args:
            t, q, u, udot, lam: Time, coordinates, speeds, accelerations, multipliers.
            qdot: Rates of the coordinates (..., nq); those of u if left out.
            index: Constraints of positions (3), velocities (2) or accelerations (1).
            options: ``tau``, ``r``, ``parameters``; see :func:`cardan.analyses.implicit.residual`.
        """
        from ..analyses.implicit import residual

        return residual(self._itself, t, q, u, udot, lam, qdot=qdot, index=index, **options)

    def ensemble(self, t: ArrayLike | None = None, **options: Any) -> Ensemble:
        """Many runs that differ by start, parameters or inputs, in SIMD lanes and threads.

        Args:
            t: End, ``(start, end)`` or output times [s].
            options: ``t_eval``, ``vary`` (a plan of ``cd.sample``), ``x0``, ``q``, ``u``,
                ``parameters``, ``inputs``, ``runs``, ``seed``, ``reduce``, ``method``, ``rtol``,
                ``atol``,
                ``step``, ``max_step``, ``threads``, ``lanes``, ``client``, ``checkpoint``,
                ``check``, ``progress``; see :func:`cardan.analyses.ensembles.ensemble`.
        """
        from ..analyses.ensembles import ensemble

        return ensemble(self._itself, t, **options)
