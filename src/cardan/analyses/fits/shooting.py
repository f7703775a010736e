"""Runs between the nodes of a fit, and what they miss, with derivatives.

Source: H. G. Bock, Recent advances in parameter identification techniques for ODE, in: Numerical
Treatment of Inverse Problems in Differential and Integral Equations (1983), 95-121.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arguments import Inputs
from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.loaded_model import LoadedModel
from ..gradients.sensitivities import SensitiveRuns, Sensitivities
from ..simulation.driving import beginning, run_setup
from ..simulation.settings import Start
from ..simulation.times import Span
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
class _Run:
    """A run from one node: at its samples, and at its end behind them.

    Attributes:
        x, r, s: States (m, nx), inputs (m, nr), modes (m, ns) at samples.
        changes: Of the states, along the speeds of the node and by parameters (m, k, nx).
        end, moved: State (nx,) and its changes (k, nx) at the next node.
    """

    x: Array
    r: Array
    s: Array
    changes: Array
    end: Array
    moved: Array


@dataclass(frozen=True)
class Shooting:
    """Multiple shooting over measured samples.

    Attributes:
        model: The model.
        samples: What was measured.
        nodes: Numbers of the samples at which segments begin; the last one is the end.
        parameters: Names of the unknown ones.
        inputs: Of the runs.
        method, rtol: Of the runs.
    """

    model: LoadedModel
    samples: Samples
    nodes: tuple[int, ...]
    parameters: tuple[str, ...]
    inputs: Inputs | None
    method: str
    rtol: float

    def every(self, states: Array, values: Array) -> list[Segment]:
        """All segments.

        Args:
            states: At the nodes (segments, nx).
            values: Of the parameters.

        Raises:
            SolveError: one breaks down.
        """
        if not np.isfinite(values).all():
            raise SolveError("fit: parameters are not finite")
        model = self.model.with_parameters(dict(zip(self.parameters, values, strict=True)))
        t, nodes = self.samples.t, self.nodes
        # one runner serves all segments
        state, options = _whole(states[0]), (self.method, self.rtol, None, None, None)
        span = (float(t[0]), float(t[-1])), None
        setup = run_setup(model, span, state, None, options, self.inputs, None)
        runs = SensitiveRuns(setup, ("x0", *self.parameters), self.inputs)
        parts = [self._run(runs, k, x) for k, x in enumerate(states)]
        # channels of all samples at once
        count = len(self.parameters)
        channels = Channels(model, self.samples.formulas, self.parameters)
        x, r, s, changes = (
            np.concatenate([getattr(one, name) for one in parts])
            for name in ("x", "r", "s", "changes")
        )
        by_parameters = np.vstack([np.zeros((changes.shape[1] - count, count)), np.eye(count)])
        computed, slopes = channels(t, x, r, s, changes, by_parameters)
        residuals = (self.samples.values - computed) / self.samples.noise
        slopes = -slopes / self.samples.noise[:, None]
        ends, moved = (np.array([getattr(one, name) for one in parts]) for name in ("end", "moved"))
        segments = list[Segment]()
        for k, transition in enumerate(self.along_speeds(ends, moved)):
            rows = slice(nodes[k], nodes[k + 1] + (k + 2 == len(nodes)))
            present = self.samples.present[rows]
            segments.append(
                Segment(residuals[rows][present], slopes[rows][present], ends[k], transition)
            )
        return segments

    def _run(self, runs: SensitiveRuns, number: int, x: Array) -> _Run:
        """The run from a node, whose steps end at the samples."""
        first, last = self.nodes[number], self.nodes[number + 1]
        t, closed = self.samples.t, number + 2 == len(self.nodes)
        over = Span(float(t[first]), float(t[last]), stops=tuple(t[first + 1 : last].tolist()))
        state = _whole(x)
        setup = runs.setup
        begin = beginning(setup.model, Start(x, ()), state, over.start, setup.input_signals)
        motion = runs.run(over, begin, state, dense=False)
        # the sample at the next node belongs to the next segment
        times = t[first : last + 1]
        rows = slice(None, None if closed else -1)
        assert isinstance(motion.sensitivity, Sensitivities)
        states, changes = motion.sensitivity.states_at(times)
        places = np.searchsorted(motion.t, times, side="right") - 1
        r = motion.r[places] if motion.inputs_at is None else motion.inputs_at(times)
        s = motion.event_log.s.reshape(len(motion.t), -1)[places]
        return _Run(states[rows], r[rows], s[rows], changes[rows], states[-1], changes[-1])

    def along_speeds(self, x: Array, changes: Array) -> Array:
        """Changes (m, k, nx) of states (m, nx) as increments along the speeds (m, n, k).

        n is 2 nu + nz.
        """
        model = self.model
        q, u, _ = model.parts_of(x)
        N = model.derivative("qdot", wrt="u")(q, u)
        along = np.linalg.pinv(N) @ np.swapaxes(changes[:, :, : model.nq], 1, 2)
        return np.concatenate([along, np.swapaxes(changes[:, :, model.nq :], 1, 2)], axis=1)

    def moved(self, x: Array, step: Array) -> Array:
        """States (m, nx) increments along the speeds (m, 2 nu + nz) away."""
        model, nu = self.model, self.model.nu
        q, u, z = model.parts_of(x)
        place = model.integrate(q, step[:, :nu])
        return np.hstack([place, u + step[:, nu : 2 * nu], z + step[:, 2 * nu :]])

    def gaps(self, ends: Array, nodes: Array) -> Array:
        """Increments along the speeds (m, 2 nu + nz) from nodes to the ends before them."""
        model = self.model
        q0, u0, z0 = model.parts_of(nodes)
        q, u, z = model.parts_of(ends)
        return np.hstack([model.difference(q0, q), u - u0, z - z0])


def _whole(x: Array) -> dict[str, object]:
    """A start by the whole state."""
    return {"x0": x, "q": None, "u": None, "z": None}
