"""Kinematics of a compiled model: rates, poses, velocities, energy and momentum."""

from __future__ import annotations

from abc import ABC
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ArgumentError, shown
from .calling import Array
from .evaluation import Evaluation, State, Values, into
from .objects import Key

Axes = Literal["ground", "frame"]


class Energy(NamedTuple):
    """Kinetic, potential and total energy [J]; gravity's potential is 0 at the ground origin."""

    kinetic: Array
    potential: Array
    total: Array


class Kinematics(Evaluation, ABC):
    """Functions of motion alone; ``...`` are leading axes that broadcast."""

    def qdot(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Rates of the coordinates (..., nq): qdot = N(q) u + n(t, q)."""
        return self._evaluate(("qdot", None), (t, q, u, r), parameters, out)

    def integrate(self, q: State, du: State, *, out: Array | None = None) -> Array:
        """q moved by a finite increment du (..., nu) along the speeds, (..., nq)."""
        return self._evaluate(("integrate", None), (q, du), None, out)

    def difference(self, q0: State, q1: State, *, out: Array | None = None) -> Array:
        """The increment du (..., nu) with integrate(q0, du) = q1."""
        return self._evaluate(("difference", None), (q0, q1), None, out)

    def pose(
        self,
        frame: str,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Homogeneous transform (..., 4, 4) from frame axes to ground axes."""
        return self._evaluate(("pose", frame), (t, q, r), parameters, out)

    def velocity(
        self,
        frame: str,
        q: State,
        u: State,
        *,
        in_: Axes = "ground",
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Angular velocity and velocity of the origin of a frame (..., 6).

        Args:
            in_: Axes of the result, ``"ground"`` or ``"frame"``.
        """
        key, values = ("velocity", frame), (t, q, u, r)
        if isinstance(in_, str) and in_ == "ground":
            return self._evaluate(key, values, parameters, out)
        return into(self._turned(key, values, in_, parameters), out)

    def acceleration(
        self,
        frame: str,
        q: State,
        u: State,
        udot: State,
        *,
        in_: Axes = "ground",
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Angular acceleration and acceleration of the origin of a frame (..., 6).

        Gravity is not in it: a body at rest has 0. Axes as for :meth:`velocity`.
        """
        key, values = ("acceleration", frame), (t, q, u, udot, r)
        if isinstance(in_, str) and in_ == "ground":
            return self._evaluate(key, values, parameters, out)
        return into(self._turned(key, values, in_, parameters), out)

    def _turned(
        self, key: Key, values: tuple[Any, ...], in_: str, parameters: Values | None
    ) -> Array:
        """A 6-vector of a frame, or columns of them, in its own axes."""
        if not isinstance(in_, str) or in_ != "frame":
            raise ArgumentError(f"in_ must be 'ground' or 'frame', not {shown(in_)}")
        ground = self._evaluate(key, values, parameters, None)
        t, q, r = values[0], values[1], values[-1]
        axes = self._evaluate(("pose", key[1]), (t, q, r), parameters, None)[..., :3, :3]
        columns = len(self.speeds) if key[0] == "frame_jacobian" else 1
        pair = ground.reshape(*axes.shape[:-2], 2, 3, columns)
        turned: Array = np.einsum("...ji,...kjc->...kic", axes, pair)
        return turned.reshape(ground.shape)

    def frame_jacobian(
        self,
        frame: str,
        q: State,
        *,
        in_: Axes = "ground",
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """J (..., 6, nu): the velocity of the frame origin is J u; rows [omega, v].

        Where joints are prescribed, their part of the velocity is no part of J u. Axes as for
        :meth:`velocity`.
        """
        key, values = ("frame_jacobian", frame), (t, q, r)
        if isinstance(in_, str) and in_ == "ground":
            return self._evaluate(key, values, parameters, out)
        return into(self._turned(key, values, in_, parameters), out)

    def com(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Center of mass of everything that moves (..., 3) [m], ground axes."""
        return self._evaluate(("com", None), (t, q, r), parameters, out)

    def momentum(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Angular momentum about the ground origin and linear momentum (..., 6), ground axes."""
        return self._evaluate(("momentum", None), (t, q, u, r), parameters, out)

    def energy(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
    ) -> Energy:
        """Kinetic, potential and total energy (...) [J]."""
        result = self._evaluate(("energy", None), (t, q, u, r), parameters, None)
        return Energy(*(result[..., k][()] for k in range(3)))
