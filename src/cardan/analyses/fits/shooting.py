"""Runs between the nodes of a fit, and what they miss, with derivatives.

Increments of all nodes follow from those of the first one and of the parameters, as nodes meet. So
the run over a segment is differentiated along these alone: along what the unknowns do to its node,
and along what closes the gap before it. Their number does not grow with the model.

Source: H. G. Bock, Recent advances in parameter identification techniques for ODE, in: Numerical
Treatment of Inverse Problems in Differential and Integral Equations (1983), 95-121. Derivatives
along directions: J. P. Schlöder, Numerische Methoden zur Behandlung hochdimensionaler Aufgaben der
Parameteridentifizierung (1988).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...arguments import Inputs
from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ...runtime.models.finite_elements.frames import increments_from
from ...runtime.models.finite_elements.table_loading import tables_of
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import Blocks
from ..gradients.sensitivities import SensitiveRuns, Sensitivities
from ..gradients.tangent import directions_of
from ..simulation.driving import beginning, run_setup
from ..simulation.events import check_start
from ..simulation.settings import Start, start
from ..simulation.starts.finite_element_start import next_start
from ..simulation.times import Span
from .estimate import Condensed
from .joint_start import JointStart
from .samples import Channels, Samples


@dataclass(frozen=True)
class NodeRun:
    """A run from a node: at its samples, and at its end behind them.

    Attributes:
        first: Number of its first sample.
        x, r, s: States (m, nx), inputs (m, nr), modes (m, ns) at samples.
        changes: Of the states along the columns (m, k, nx).
        end, moved: State (nx,) and its changes (k, nx) at the next node.
    """

    first: int
    x: Array
    r: Array
    s: Array
    changes: Array
    end: Array
    moved: Array


@dataclass(frozen=True)
class Shots:
    """Runs over all segments.

    Attributes:
        states: At the nodes (segments, nx), constraints closed.
        gaps: Increments from each node but the first to the end before it (segments - 1, n).
        residuals: Measured less computed, over the noise (m,), of what is present.
        problem: The linear problem of the search.
    """

    states: Array
    gaps: Array
    residuals: Array
    problem: Condensed


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
        free: Places of the unknown entries of the first node along the speeds.
        inputs: Of the runs.
        method, rtol: Of the runs.
        locked: Of a model with loops: names of coordinates and speeds, by ``"q"`` and ``"u"``, that
            the start was given by, whereas loops determine the others; None of a tree.
        joint_start: Of a model in absolute coordinates: the start of its first segment by names;
            None where that is any state next to which constraints are closed, like other starts.
        watch: Is told that a run goes on.
    """

    model: LoadedModel
    samples: Samples
    nodes: tuple[int, ...]
    parameters: tuple[str, ...]
    free: NDArray[np.intp]
    inputs: Inputs | None
    method: str
    rtol: float
    locked: Mapping[str, tuple[str, ...]] | None = None
    joint_start: JointStart | None = None
    watch: Watch = field(default_factory=Watch)

    @property
    def size(self) -> int:
        """Number n of increments of a node along the speeds: 2 nu + nz."""
        return 2 * self.model.nu + self.model.nz

    @property
    def unknowns(self) -> int:
        """Number of unknowns: entries of the first node and parameters."""
        return len(self.free) + len(self.parameters)

    def every(self, states: Array, values: Array) -> Shots:
        """All segments.

        Args:
            states: At the nodes (segments, nx); next to them constraints are closed.
            values: Of the parameters.

        Raises:
            SolveError: one breaks down. ModelError: constraints cannot be closed.
        """
        # the last column is what closes the gaps, of which one segment has none
        count = max(1, self.unknowns + (len(states) > 1))
        first, last = len(self.free), self.unknowns
        by_parameters = np.zeros((count, len(self.parameters)))
        by_parameters[first:last] = np.eye(last - first)
        trial = Trial(self, values, by_parameters)
        begins = [trial.begin(k, x) for k, x in enumerate(states)]
        columns = np.zeros((self.size, count))
        columns[self.free, np.arange(first)] = 1.0
        nodes, runs, gaps = list[Array](), list[NodeRun](), np.zeros((len(states) - 1, self.size))
        for k, begin in enumerate(begins):
            nodes.append(columns)
            runs.append(trial.run(k, begin, columns))
            if k + 1 < len(begins):
                end = runs[-1].end
                columns = trial.increments_of(end, runs[-1].moved)
                gaps[k] = self.increments(begins[k + 1].x[None], end[None])[0]
                columns[:, -1] += gaps[k]
        residuals, slopes = (np.concatenate(one) for one in zip(*trial.misfit(runs), strict=True))
        moves = np.array(nodes)
        problem = Condensed(
            residuals + slopes[:, last:].sum(axis=1), slopes[:, :last],
            float(np.linalg.norm(residuals)),
            moves[:, :, :last], moves[:, :, last:].sum(axis=2),
        )  # fmt: skip
        return Shots(np.array([one.x for one in begins]), gaps, residuals, problem)

    def moved(self, x: Array, step: Array) -> Array:
        """States (m, nx) increments along the speeds (m, n) away."""
        model, nu = self.model, self.model.nu
        q, u, z = model.parts_of(x)
        place = model.integrate(q, step[:, :nu])
        return np.hstack([place, u + step[:, nu : 2 * nu], z + step[:, 2 * nu :]])

    def increments(self, nodes: Array, ends: Array) -> Array:
        """Increments along the speeds (m, n) from states (m, nx) to others."""
        model = self.model
        q0, u0, z0 = model.parts_of(nodes)
        q, u, z = model.parts_of(ends)
        if model.manifest.absolute:
            tables = tables_of(model)
            pairs = zip(q0, q, strict=True)
            places = np.array([increments_from(tables, *pair) for pair in pairs])
        else:
            places = model.difference(q0, q)
        return np.hstack([places.reshape(len(nodes), model.nu), u - u0, z - z0])


class Trial:
    """Runs with one set of parameters: one model and one runner serve all segments.

    Attributes:
        shooting: What is measured where.
        by_parameters: Of the parameters along the columns of all runs (k, parameters).
    """

    def __init__(self, shooting: Shooting, values: Array, by_parameters: Array) -> None:
        """Args:
        shooting, by_parameters: See the attributes.
        values: Of the parameters.

        Raises:
            SolveError: values are not finite.
        """
        if not np.isfinite(values).all():
            raise SolveError("fit: parameters are not finite")
        self.shooting, names = shooting, shooting.parameters
        self.by_parameters = by_parameters
        model = shooting.model.with_parameters(dict(zip(names, values, strict=True)))
        t, inputs = shooting.samples.t, shooting.inputs
        span = (float(t[0]), float(t[-1])), None
        options = shooting.method, shooting.rtol, None, None, None
        setup = run_setup(model, span, None, None, options, inputs, None)
        self._setup = setup
        self._channels = Channels(model, shooting.samples.formulas, names)

    @cached_property
    def _runs(self) -> SensitiveRuns:
        shooting, setup, by_parameters = self.shooting, self._setup, self.by_parameters
        joints, listed = shooting.joint_start, list(setup.model.parameters)
        starts = ["x0"] if joints is None else [*joints.unknown]
        breaks = sum(len(one.coefficients) for one in setup.input_signals.tabulated)
        directions = directions_of(setup.model, breaks, len(by_parameters))
        for name, column in zip(shooting.parameters, by_parameters.T, strict=True):
            directions.p[:, listed.index(name)] = column
            starts += [name] if column.any() else []
        # where nothing is unknown, runs are looked at all the same
        return SensitiveRuns(setup, starts or ["x0"], shooting.inputs, directions)

    def time_and_inputs(self, number: int) -> tuple[float, Array]:
        """Time and inputs (nr,) at a node."""
        t = float(self.shooting.samples.t[self.shooting.nodes[number]])
        return t, self._setup.input_signals.first(t)

    def begin(self, number: int, x: Array) -> Start:
        """The start at a node next to a state (nx,): constraints are closed, what is locked stays.

        Raises:
            ModelError: they cannot be closed.
        """
        model, joints = self._setup.model, self.shooting.joint_start
        t, r = self.time_and_inputs(number)
        if model.manifest.absolute and (joints is None or number):
            # a state of the search, whatever it strains
            x = next_start(model, x, t, r)
            check_start(model, x, t, r)
            return Start(x, ())
        state, begin = self._named(number, x), Start(x, ())
        if joints is not None:
            # nodes are where joints carry them, as in a run by itself
            begin = start(model, None, state["q"], state["u"], state["z"])
        return beginning(model, begin, state, t, self._setup.input_signals)

    def _named(self, number: int, x: Array) -> dict[str, object]:
        """A start as ``simulate`` takes it: whole, or by what is locked at the first node."""
        locked, model = self.shooting.locked, self._setup.model
        if self.shooting.joint_start is not None and not number:
            return self.shooting.joint_start.state(model, x)
        if locked is None:
            return {"x0": x, "q": None, "u": None, "z": None}
        entries = dict(zip((*model.coordinates, *model.speeds), x.tolist(), strict=False))
        blocks = {b: {n: entries[n] for n in locked[b] if number == 0} for b in "qu"}
        return {"x0": None, **blocks, "z": None, "next_to": x}

    def run(self, number: int, begin: Start, columns: Array) -> NodeRun:
        """The run over a segment; its steps end at the samples.

        Args:
            number: Of the segment.
            begin: Its start.
            columns: Increments of the start (n, k); what constraints do not allow is projected out.

        Raises:
            SolveError: it breaks down.
        """
        nodes = self.shooting.nodes
        first, last = nodes[number], nodes[number + 1]
        times = self.shooting.samples.t[first : last + 1]
        over = Span(float(times[0]), float(times[-1]), stops=tuple(times[1:-1].tolist()))
        motion = self._runs.run(
            over, begin, self._named(number, begin.x), progress=self._watch, dense=False,
            columns=columns.T,
        )  # fmt: skip
        # the sample at the next node belongs to the next segment
        rows = slice(None, None if number + 2 == len(nodes) else -1)
        assert isinstance(motion.sensitivity, Sensitivities)
        states, changes = motion.sensitivity.states_at(times)
        places = np.searchsorted(motion.t, times, side="right") - 1
        r = motion.r[places] if motion.inputs_at is None else motion.inputs_at(times)
        s = motion.event_log.s.reshape(len(motion.t), -1)[places]
        return NodeRun(
            first, states[rows], r[rows], s[rows], changes[rows], states[-1], changes[-1]
        )

    def _watch(self, done: float) -> None:
        """End a run that parameters without sense, such as a negative mass, let go astray."""
        self.shooting.watch.show()
        if self._runs.steps > MOST_STEPS:
            raise SolveError(
                f"fit: a run takes more than {MOST_STEPS:,} steps for {100 * done:.0f} % of a "
                "segment. Give bounds= to the parameters, or more segments"
            )

    def misfit(self, runs: Sequence[NodeRun]) -> list[tuple[Array, Array]]:
        """Residuals (m,) and their slopes (m, k) of each of runs that follow each other.

        Raises:
            SolveError: a measured quantity has no finite value.
        """
        samples = self.shooting.samples
        # channels of all runs at once
        x, r, s, changes = (
            np.concatenate([getattr(one, name) for one in runs])
            for name in ("x", "r", "s", "changes")
        )
        first = runs[0].first
        rows = slice(first, first + len(x))
        computed, slopes = self._channels(samples.t[rows], x, r, s, changes, self.by_parameters)
        residuals = (samples.values[rows] - computed) / samples.noise
        slopes = -slopes / samples.noise[:, None]
        parts = [slice(one.first - first, one.first - first + len(one.x)) for one in runs]
        masks = [samples.present[rows][part] for part in parts]
        pairs = zip(parts, masks, strict=True)
        return [(residuals[part][mask], slopes[part][mask]) for part, mask in pairs]

    def increments_of(self, x: Array, changes: Array) -> Array:
        """Changes (k, nx) of a state (nx,) as increments along the speeds (n, k)."""
        model = self._setup.model
        q, u, _ = model.parts_of(x)
        (N,) = model.derivative("qdot", wrt=Blocks("u"))(q, u)
        return np.vstack([np.linalg.pinv(N) @ changes[:, : model.nq].T, changes[:, model.nq :].T])
