"""Runs between the nodes of a fit, and what they miss, with derivatives.

Source: H. G. Bock, Recent advances in parameter identification techniques for ODE, in: Numerical
Treatment of Inverse Problems in Differential and Integral Equations (1983), 95-121.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ...arguments import Inputs
from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import Blocks
from ..gradients.sensitivities import SensitiveRuns, Sensitivities
from ..gradients.unknowns import start_places
from ..simulation.driving import beginning, run_setup
from ..simulation.settings import Start, start
from ..simulation.times import Span
from .joint_start import JointStart
from .samples import Channels, Samples


@dataclass(frozen=True)
class Segment:
    """What a run from one node says.

    Attributes:
        residuals: Measured less computed, over the noise (m,), of what is present.
        slopes: Derivatives of the residuals by the node along the speeds and by parameters (m, k).
        begin, end: States (nx,) at the node, loops closed, and at the next one.
        transition: Derivatives (n, k) of the end along the speeds, n = 2 nu + nz.
    """

    residuals: Array
    slopes: Array
    begin: Array
    end: Array
    transition: Array


@dataclass(frozen=True)
class NodeRun:
    """A run from a node: at its samples, and at its end behind them.

    Attributes:
        first: Number of its first sample.
        begin: State at the node (nx,), loops closed.
        x, r, s: States (m, nx), inputs (m, nr), modes (m, ns) at samples.
        changes: Of the states, along the speeds of the node and by parameters (m, k, nx).
        end, moved: State (nx,) and its changes (k, nx) at the next node.
    """

    first: int
    begin: Array
    x: Array
    r: Array
    s: Array
    changes: Array
    end: Array
    moved: Array


class Watch:
    """Shows that runs go on."""

    def __init__(self) -> None:
        self.show: Callable[[], None] = lambda: None


MOST_STEPS = 100_000  # of the run over a segment


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
        locked: Of a model with loops: names of coordinates and speeds, by ``"q"`` and ``"u"``, that
            the start was given by, whereas loops determine the others; None of a tree.
        joint_start: Of a model in absolute coordinates: its start, which is that of its only
            segment.
        watch: Is told that a run goes on.
    """

    model: LoadedModel
    samples: Samples
    nodes: tuple[int, ...]
    parameters: tuple[str, ...]
    inputs: Inputs | None
    method: str
    rtol: float
    locked: Mapping[str, tuple[str, ...]] | None = None
    joint_start: JointStart | None = None
    watch: Watch = field(default_factory=Watch)

    def every(self, states: Array, values: Array) -> list[Segment]:
        """All segments.

        Args:
            states: At the nodes (segments, nx).
            values: Of the parameters.

        Raises:
            SolveError: one breaks down.
        """
        trial = Trial(self, values)
        return trial.segments([trial.run(k, x) for k, x in enumerate(states)])

    def moved(self, x: Array, step: Array) -> Array:
        """States (m, nx) increments along the speeds (m, 2 nu + nz) away."""
        model, nu = self.model, self.model.nu
        q, u, z = model.parts_of(x)
        place = model.integrate(q, step[:, :nu])
        return np.hstack([place, u + step[:, nu : 2 * nu], z + step[:, 2 * nu :]])

    def increments(self, nodes: Array, ends: Array) -> Array:
        """Increments along the speeds (m, 2 nu + nz) from states (m, nx) to others."""
        model = self.model
        if not len(nodes):
            # of one segment, as in absolute coordinates, where no function says what they are
            return np.zeros((0, 2 * model.nu + model.nz))
        q0, u0, z0 = model.parts_of(nodes)
        q, u, z = model.parts_of(ends)
        return np.hstack([model.difference(q0, q), u - u0, z - z0])


class Trial:
    """Runs with one set of parameters: one model and one runner serve all segments."""

    def __init__(self, shooting: Shooting, values: Array) -> None:
        """Args:
        shooting: What is measured where.
        values: Of the parameters.

        Raises:
            SolveError: they are not finite.
        """
        if not np.isfinite(values).all():
            raise SolveError("fit: parameters are not finite")
        self.shooting, names = shooting, shooting.parameters
        model = shooting.model.with_parameters(dict(zip(names, values, strict=True)))
        t, inputs = shooting.samples.t, shooting.inputs
        span = (float(t[0]), float(t[-1])), None
        options = shooting.method, shooting.rtol, None, None, None
        setup = run_setup(model, span, None, None, options, inputs, None)
        self._setup = setup
        self._channels = Channels(model, shooting.samples.formulas, names)

    @cached_property
    def _runs(self) -> SensitiveRuns:
        shooting = self.shooting
        joints = shooting.joint_start
        starts = ("x0",) if joints is None else joints.unknown
        return SensitiveRuns(self._setup, (*starts, *shooting.parameters), shooting.inputs)

    def begin(self, number: int, x: Array) -> Start:
        """The start at a node next to a state (nx,): loops are closed, what is locked there stays.

        Raises:
            ModelError: loops cannot be closed.
        """
        setup, t = self._setup, float(self.shooting.samples.t[self.shooting.nodes[number]])
        state, begin = self._named(number, x), Start(x, ())
        if self.shooting.joint_start is not None:
            # nodes are where joints carry them, as in a run by itself
            begin = start(setup.model, None, state["q"], state["u"], state["z"])
        return beginning(setup.model, begin, state, t, setup.input_signals)

    def _named(self, number: int, x: Array) -> dict[str, object]:
        """A start as ``simulate`` takes it: whole, or by what is locked at the first node."""
        locked, model = self.shooting.locked, self._setup.model
        if self.shooting.joint_start is not None:
            return self.shooting.joint_start.state(model, x)
        if locked is None:
            return {"x0": x, "q": None, "u": None, "z": None}
        entries = dict(zip((*model.coordinates, *model.speeds), x.tolist(), strict=False))
        blocks = {b: {n: entries[n] for n in locked[b] if number == 0} for b in "qu"}
        return {"x0": None, **blocks, "z": None, "next_to": x}

    def run(self, number: int, x: Array) -> NodeRun:
        """The run over a segment from a state (nx,); its steps end at the samples.

        Raises:
            SolveError: it breaks down.
        """
        nodes = self.shooting.nodes
        first, last = nodes[number], nodes[number + 1]
        times = self.shooting.samples.t[first : last + 1]
        over = Span(float(times[0]), float(times[-1]), stops=tuple(times[1:-1].tolist()))
        begin = self.begin(number, x)
        motion = self._runs.run(
            over, begin, self._named(number, x), progress=self._watch, dense=False
        )
        # the sample at the next node belongs to the next segment
        rows = slice(None, None if number + 2 == len(nodes) else -1)
        assert isinstance(motion.sensitivity, Sensitivities)
        states, changes = motion.sensitivity.states_at(times)
        if self.shooting.joint_start is not None:
            changes = self._in_places(changes, self.shooting.joint_start)
        places = np.searchsorted(motion.t, times, side="right") - 1
        r = motion.r[places] if motion.inputs_at is None else motion.inputs_at(times)
        s = motion.event_log.s.reshape(len(motion.t), -1)[places]
        end, moved = states[-1], changes[-1]
        return NodeRun(first, begin.x, states[rows], r[rows], s[rows], changes[rows], end, moved)

    def _in_places(self, changes: Array, joints: JointStart) -> Array:
        """Changes (m, k, nx) with a row for every entry of the start along the speeds.

        Those that nobody asked for stay 0: the search does not move them.
        """
        model, count = self._setup.model, len(self.shooting.parameters)
        n, places = 2 * model.nu + model.nz, start_places(model)
        rows = [k for name in joints.unknown for k in range(places[name].start, places[name].stop)]
        result = np.zeros((len(changes), n + count, model.nx))
        result[:, rows] = changes[:, : len(rows)]
        result[:, n:] = changes[:, len(rows) :]
        return result

    def _watch(self, done: float) -> None:
        """End a run that parameters without sense, such as a negative mass, let go astray."""
        self.shooting.watch.show()
        if self._runs.steps > MOST_STEPS:
            raise SolveError(
                f"fit: a run takes more than {MOST_STEPS:,} steps for {100 * done:.0f} % of a "
                "segment. Give bounds= to the parameters, or more segments"
            )

    def segments(self, runs: Sequence[NodeRun]) -> list[Segment]:
        """What runs over segments that follow each other say; channels of all at once.

        Raises:
            SolveError: a measured quantity has no finite value.
        """
        samples, count = self.shooting.samples, len(self.shooting.parameters)
        x, r, s, changes = (
            np.concatenate([getattr(one, name) for one in runs])
            for name in ("x", "r", "s", "changes")
        )
        first = runs[0].first
        rows = slice(first, first + len(x))
        by_parameters = np.vstack([np.zeros((changes.shape[1] - count, count)), np.eye(count)])
        computed, slopes = self._channels(samples.t[rows], x, r, s, changes, by_parameters)
        residuals = (samples.values[rows] - computed) / samples.noise
        slopes = -slopes / samples.noise[:, None]
        present = samples.present[rows]
        ends, moved = (np.array([getattr(one, name) for one in runs]) for name in ("end", "moved"))
        segments = list[Segment]()
        for one, transition in zip(runs, self._along_speeds(ends, moved), strict=True):
            part = slice(one.first - first, one.first - first + len(one.x))
            mask = present[part]
            segments.append(
                Segment(residuals[part][mask], slopes[part][mask], one.begin, one.end, transition)
            )
        return segments

    def _along_speeds(self, x: Array, changes: Array) -> Array:
        """Changes (m, k, nx) of states (m, nx) as increments along the speeds (m, n, k).

        n is 2 nu + nz.
        """
        model = self._setup.model
        q, u, _ = model.parts_of(x)
        (N,) = model.derivative("qdot", wrt=Blocks("u"))(q, u)
        along = np.linalg.pinv(N) @ np.swapaxes(changes[:, :, : model.nq], 1, 2)
        return np.concatenate([along, np.swapaxes(changes[:, :, model.nq :], 1, 2)], axis=1)
