"""Runs between the nodes of a fit, and what they miss, with derivatives.

Source: H. G. Bock, Recent advances in parameter identification techniques for ODE, in: Numerical
Treatment of Inverse Problems in Differential and Integral Equations (1983), 95-121.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...arguments import Inputs
from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.loaded_model import LoadedModel
from ..gradients.sensitivities import Sensitivities
from ..simulation.simulate import simulate
from .samples import Channels, Samples


@dataclass(frozen=True)
class Segment:
    """What a run from one node says.

    Attributes:
        residuals: Measured less computed, over the noise (m,), of what is present.
        slopes: Derivatives of the residuals by the node along the speeds and by parameters (m, k).
        end: State at the next node (nx,).
        transition: Derivatives (n, k) of the end along the speeds, n = 2 nu + nz.
    """

    residuals: Array
    slopes: Array
    end: Array
    transition: Array


@dataclass(frozen=True)
class Shooting:
    """Multiple shooting over measured samples.

    Attributes:
        model: The model.
        samples: What was measured.
        nodes: Numbers of the samples at which segments begin; the last one is the end.
        parameters: Names of the unknown ones.
        inputs: Of the runs.
        options: Method and tolerances of the runs.
    """

    model: LoadedModel
    samples: Samples
    nodes: tuple[int, ...]
    parameters: tuple[str, ...]
    inputs: Inputs | None
    options: Mapping[str, object]

    def segment(self, number: int, x: Array, values: Array, wide: bool = True) -> Segment:
        """The run from a node.

        Args:
            number: Of the segment.
            x: State at the node (nx,).
            values: Of the parameters.
            wide: Whether derivatives are wanted.

        Raises:
            SolveError: it breaks down.
        """
        first, last = self.nodes[number], self.nodes[number + 1]
        model = self.model.with_parameters(dict(zip(self.parameters, values, strict=True)))
        t, closed = self.samples.t, number + 2 == len(self.nodes)
        # the sample at the next node belongs to the next segment
        rows = np.arange(first, last + closed)
        motion = simulate(
            model,
            (float(t[first]), float(t[last])),
            x0=x,
            inputs=self.inputs,
            sensitivity=("x0", *self.parameters),
            **self.options,  # type: ignore[arg-type]
        )
        # along the speeds of the node, and by parameters
        changes = motion.sensitivity
        assert isinstance(changes, Sensitivities)
        states, moved = changes.states_at(np.append(t[rows], t[last]))
        count = len(self.parameters)
        by_parameters = np.vstack([np.zeros((moved.shape[1] - count, count)), np.eye(count)])
        r = motion.inputs_at(t[rows]) if motion.inputs_at is not None else motion.r[:1]
        channels = Channels(model, self.samples.formulas, self.parameters)
        computed, slopes = channels(
            t[rows], states[:-1], r, motion.event_log.s[-1], moved[:-1], by_parameters
        )
        present = self.samples.present[rows]
        scale = self.samples.noise
        residuals = ((self.samples.values[rows] - computed) / scale)[present]
        return Segment(
            residuals,
            (-slopes / scale[:, None])[present],
            states[-1],
            self.along_speeds(states[-1], moved[-1]),
        )

    def along_speeds(self, x: Array, changes: Array) -> Array:
        """Changes (k, nx) of a state as increments along the speeds (2 nu + nz, k)."""
        model = self.model
        q, u, _ = model.parts_of(x)
        N = model.derivative("qdot", wrt="u")(q, u)
        along = np.linalg.lstsq(N, changes[:, : model.nq].T, rcond=None)[0]
        return np.vstack([along, changes[:, model.nq :].T])

    def moved(self, x: Array, step: Array) -> Array:
        """The state (nx,) an increment along the speeds away."""
        model, nu = self.model, self.model.nu
        q, u, z = model.parts_of(x)
        return np.concatenate(
            [model.integrate(q, step[:nu]), u + step[nu : 2 * nu], z + step[2 * nu :]]
        )

    def gap(self, x: Array, node: Array) -> Array:
        """The increment along the speeds (2 nu + nz,) from a node to the end before it."""
        model = self.model
        q0, u0, z0 = model.parts_of(node)
        q, u, z = model.parts_of(x)
        return np.concatenate([model.difference(q0, q), u - u0, z - z0])

    def every(self, states: Sequence[Array], values: Array) -> list[Segment]:
        """All segments.

        Raises:
            SolveError: one breaks down.
        """
        if not np.isfinite(values).all():
            raise SolveError("fit: parameters are not finite")
        return [self.segment(k, x, values) for k, x in enumerate(states)]
