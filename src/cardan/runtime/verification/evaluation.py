"""One question to a model: its functions at the states at which it is judged."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import SolveWarning
from ...records import dataclass
from ...schema.request import reads
from ..calls.objects import Key
from .closed_states import RANK
from .differences import slope
from .joint_motion import Array, times
from .newton_euler import Moving, Scene, moving
from .reference_values import ReferenceValues

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel


ELSEWHERE = "what it is compared with is not compiled"


@dataclass(frozen=True)
class Trial:
    """A model, and what is known of it at some states.

    Attributes:
        model: What is judged.
        scene: Its flat scene.
        reference: Independent numbers at the states.
        callable_keys: Functions that may be called: those that are judged, or were.
        adrift: Why its own motion is not known, "" where it is.
    """

    model: LoadedModel
    scene: Scene
    reference: ReferenceValues
    callable_keys: frozenset[Key] = frozenset()
    adrift: str = ""
    cache: dict[Any, Any] = field(default_factory=dict, repr=False, compare=False)

    @cached_property
    def blocks(self) -> dict[str, Array]:
        """All that functions may read, by letter."""
        reference, layout = self.reference, self.model._layout
        n = len(reference.q)
        defaults = {
            name: np.broadcast_to(layout.start(name), (n, len(layout.names(name)))) for name in "zs"
        }
        t = np.full((n, 1), reference.t)
        state_blocks = {
            "t": t,
            "q": reference.q,
            "u": reference.u,
            "udot": reference.udot,
            "tau": reference.tau,
            "lam": np.random.default_rng(2).uniform(
                -1, 1, (n, len(self.model.manifest.multipliers))
            ),
        }
        # one event after the other, state by state
        events = np.arange(len(layout.events)) == np.arange(n)[:, None] % max(1, len(layout.events))
        return {
            **state_blocks,
            "e": events.astype(float),
            "r": np.broadcast_to(reference.r, (n, reference.r.shape[-1])),
            **defaults,
        }

    def call(
        self, name: str, of: str | None = None, overrides: Mapping[str, Array] | None = None
    ) -> Array:
        """A function at the states, or at other blocks; (n, ...)."""
        values: list[Any] = []
        inputs = self.blocks if overrides is None else {**self.blocks, **overrides}
        for letter in reads(name, of):
            if letter == "x":
                values.append(np.concatenate([inputs[k] for k in "quz"], axis=-1))
            elif letter == "t":
                values.append(inputs["t"][..., 0])
            else:
                values.append(inputs.get(letter))
        with np.errstate(all="ignore"), warnings.catch_warnings():
            # states at which a function has no value say nothing
            warnings.simplefilter("ignore", SolveWarning)
            result: Array = self.model._function(name, of).caller(None, *values)
        # parameters alone have no states
        return result if values else np.broadcast_to(result, (len(self.reference.q), *result.shape))

    def along_speeds(self, du: Array, q: Array | None = None) -> Array:
        """Rates of coordinates (n, nq) per unit of an increment (n, nu) along the speeds."""
        at = {"q": self.reference.q if q is None else q}
        still = self.call("qdot", None, {**at, "u": np.zeros_like(du)})
        return self.call("qdot", None, {**at, "u": du}) - still

    def knows(self, *names: str) -> bool:
        """True when functions may be called."""
        return all((name, None) in self.callable_keys for name in names)

    @cached_property
    def tree(self) -> tuple[Array, Array, Array, Array | None]:
        """Coordinates, speeds and accelerations of the whole tree, and its prescribed motion."""
        reference, scene = self.reference, self.scene
        if reference.bound is None:
            return reference.q, reference.u, reference.udot, reference.motion
        bound = reference.bound
        udot = times(bound.carries, reference.udot) + bound.rests
        return bound.q, bound.u[:, : scene.nu], udot, reference.motion

    @cached_property
    def redundant(self) -> bool:
        """True when constraints depend on others:

        reactions are not unique, nor is what is nearby.
        """
        if self.reference.bound is None or not self.knows("constraint_jacobian"):
            return False
        G = self.call("constraint_jacobian")
        most = float(np.abs(G).max(initial=0.0)) or 1.0
        ranks = np.linalg.matrix_rank(G, tol=RANK * most)
        return bool((np.asarray(ranks) < G.shape[-2]).any())

    @cached_property
    def moving(self) -> Moving:
        """The motion of all bodies, without gravity."""
        q, u, udot, motion = self.tree
        return moving(self.scene, q, u, udot, motion, pull=0.0)

    def along(self, x: Array) -> Array:
        """Numbers along the speeds of the tree as numbers along those of the model (n, nu)."""
        bound = self.reference.bound
        if bound is None:
            return x
        return times(np.swapaxes(bound.carries, -1, -2), x)

    @cached_property
    def length(self) -> float:
        """Size of the mechanism, against which lengths count."""
        places = [self.scene.numbers.get(k, np.zeros(0)) for k in ("position", "frame_position")]
        extent = max((float(np.abs(x).max(initial=0.0)) for x in places), default=0.0)
        return extent if extent > 0 else 1.0

    def size(self, rates: Mapping[str, Array]) -> Array:
        """Distance that rates lead in terms of sizes, (n,): angles are of size 1."""
        n, scale = len(self.reference.q), self.length
        row_sizes = np.zeros(n)
        for name, rate in rates.items():
            rows = self.model.manifest.coordinates if name == "q" else ()
            sizes = np.array([scale if row.unit == "m" else 1.0 for row in rows])
            parts = np.abs(rate / sizes if len(sizes) else rate)
            row_sizes = np.maximum(row_sizes, parts.max(axis=-1, initial=0.0))
        return row_sizes

    def slope(
        self,
        name: str,
        of: str | None,
        rates: Mapping[str, Array],
        overrides: Mapping[str, Array] | None = None,
    ) -> tuple[Array, Array]:
        """Derivative (n, k) of a function along rates of blocks, and how far it may be off."""
        at = {**self.blocks, **(overrides or {})}
        letters = {letter for x in reads(name, of) for letter in ("quz" if x == "x" else (x,))}
        here = {k: v for k, v in at.items() if k in letters}
        moved = {k: v for k, v in rates.items() if k in here}
        return slope(lambda blocks: self.call(name, of, blocks), here, moved, self.size(moved))
