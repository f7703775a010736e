"""What a compiled model offers about measured motions: forces along them, and identification."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from numpy.typing import ArrayLike

from .described import Described

if TYPE_CHECKING:
    from ..analyses.identification.base import Base
    from ..analyses.identification.excitation import Excitation
    from ..analyses.identification.result import Identification
    from ..analyses.torques import Torques
    from .compiled import CompiledModel


class Identified(Described):
    """A model with analyses of given motions."""

    def torques(self, motion: Any, **options: Any) -> Torques:
        """Forces that make a motion, by name: inverse dynamics along it.

        Args:
            motion: A Trajectory, or a mapping with ``t`` and positions: arrays, splines, tables.
            options: ``actuators``, ``norm``, ``inputs``, ``cutoff``, ``period``, ``harmonics``; see
                :func:`cardan.analyses.torques.torques`.
        """
        from ..analyses.torques import torques

        return torques(cast("CompiledModel", self), motion, **options)

    def base_parameters(self, rows: ArrayLike | None = None, **options: Any) -> Base:
        """The combinations of inertial parameters that forces depend on, by their numbers.

        Args:
            rows: Regressors (..., n) to judge by; by default at random states.
            options: ``seed``, ``rank``; see
                :func:`cardan.analyses.identification.base.base_parameters`.
        """
        from ..analyses.identification.base import base_parameters

        return base_parameters(cast("CompiledModel", self), rows, **options)

    def excitation(self, period: float = 10.0, **options: Any) -> Excitation:
        """A periodic motion of the joints from which inertial parameters can be told.

        Args:
            period: Of the motion [s].
            options: ``harmonics``, ``position``, ``speed``, ``acceleration``, ``criterion``,
                ``starts``, ``steps``, ``seed``, ``progress``; see
                :func:`cardan.analyses.identification.excitation.excitation`.
        """
        from ..analyses.identification.excitation import excitation

        return excitation(cast("CompiledModel", self), period, **options)

    def identify(self, data: Any, **options: Any) -> Identification:
        """Base parameters from measured motions and forces, with their covariance.

        Args:
            data: A Trajectory, a file, or a mapping with ``t``, ``q``, ``tau`` and more.
            options: ``form``, ``noise``, ``cutoff``, ``period``, ``harmonics``, ``actuators``,
                ``base``, ``stretch``; see
                :func:`cardan.analyses.identification.identify.identify`.
        """
        from ..analyses.identification.identify import identify

        return identify(cast("CompiledModel", self), data, **options)
