"""Sums over elements in tables, however their functions are evaluated."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from ....arrays import Array
from ....records import dataclass
from ....schema.records import PARTS
from .tables import Table, Tables

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

# unknowns of its own that an element of mixed form has: its stress
INNER = 6
NO_STIFFNESS: Mapping[int, Array] = MappingProxyType({})


@dataclass(frozen=True)
class State:
    """State at which elements are evaluated; blocks that are left out count as zeros.

    Attributes:
        q, u, udot: Coordinates (nq,), speeds and their derivatives (nu,).
        lam: Multipliers (m,).
        t, r: Time [s] and inputs (nr,).
        z, s: Internal states and modes of elements.
        du, inner: Of a search: increments (nu,), and unknowns that elements keep themselves.
    """

    q: Array
    u: Array | None = None
    udot: Array | None = None
    lam: Array | None = None
    t: float = 0.0
    r: Array | None = None
    z: Array | None = None
    s: Array | None = None
    du: Array | None = None
    inner: Array | None = None


def _all(_: Table) -> bool:
    return True


class Elements(ABC):
    """The tables of a model with functions and data."""

    tables: Tables
    data: Sequence[Array]
    inner: int

    def read(self, number: int, at: State, inner: int = 0) -> dict[str, Array]:
        """Inputs of the functions of a group, (n, size) each, or (size,) for all of them.

        Args:
            number, at: Which group, where.
            inner: Where the unknowns that its elements keep themselves begin in ``at.inner``.
        """
        tables, group = self.tables, self.tables.groups[number]
        n = len(group)
        places = tables.places_of(group)
        columns, zero = tables.columns(group), np.zeros(tables.nu)
        blocks = {"q": at.q[places], "p": self.data[number]}
        for name, block in (("u", at.u), ("udot", at.udot), ("du", at.du)):
            blocks[name] = (zero if block is None else block)[columns]
        lam = np.zeros(tables.m) if at.lam is None else at.lam
        blocks["lam"] = lam[tables.lines(number)]
        for name, which, block in (("z", group.z, at.z), ("s", group.s, at.s)):
            blocks[name] = np.zeros((n, 0)) if which is None or block is None else block[which]
        if at.inner is not None and "mixed" in group.kind.functions:
            blocks["z"] = at.inner[inner : inner + INNER * n].reshape(n, INNER)
        blocks["r"] = np.zeros(tables.nr) if at.r is None else at.r
        blocks["t"] = np.array([at.t])
        blocks["e"] = np.zeros((n, group.kind.ne))
        blocks["tau"] = np.zeros((n, group.kind.frictions + group.kind.responses))
        return blocks

    @abstractmethod
    def balance(self, at: State) -> tuple[Array, Array, Array]:
        """M udot + h - f - Gᵀ lam (nu,), residuals of positions (mp,), of speeds (m,)."""

    @abstractmethod
    def gamma(self, at: State) -> Array:
        """gamma (m,) with G udot = gamma."""

    @abstractmethod
    def total(self, form: str, size: int, at: State) -> Array:
        """Sum (size,) of a function over the elements: ``energy``, ``momentum``, ``power``."""

    @abstractmethod
    def results(self, form: str, at: State) -> list[Array]:
        """Results of the elements (n, size), for every group that has the function."""

    @abstractmethod
    def accelerations(self, at: State, tau: Array | None = None) -> tuple[Array, Array]:
        """udot (nu,) and multipliers (m,) under the forces of the elements and tau (nu,).

        Raises:
            SolveError: something can move that has neither mass nor inertia; it is named.
        """

    @abstractmethod
    def rates(self, q: Array, u: Array) -> Array:
        """qdot (nq,)."""

    @abstractmethod
    def move(self, q: Array, du: Array) -> Array:
        """Coordinates (nq,) moved by an increment (nu,) along the speeds."""

    @abstractmethod
    def call(self, name: str, at: State, size: int, tau: Array | None = None) -> Array:
        """``close_position`` or ``close_velocity``: the closed block, then what was open.

        Args:
            name, at, size: Which, where, length of the result.
            tau: Other than 0 along speeds (nu,) that are held.
        """

    def settled(self, at: State) -> Array:
        """Unknowns that elements keep themselves in a search, as they are at a position."""
        start = replace(at, inner=np.zeros(self.inner), du=np.zeros(self.tables.nu))
        return self.stepped(start)

    def stepped(self, at: State) -> Array:
        """The same after the increment ``at.du``."""
        steps = self.results("mixed_step", at)
        return np.concatenate([rows.ravel() for rows in steps]) if steps else np.zeros(0)

    def loads(self, at: State) -> Array:
        """Sizes (nu,) of the loads that act: forces of all elements but joints, beams, springs."""
        groups = [g for g in self.tables.groups if "balance" in g.kind.functions]
        loads: Array = np.zeros(self.tables.nu)
        for group, values in zip(groups, self.results("balance", at), strict=True):
            kind = group.kind
            spring = "energy" in kind.functions and "momentum" not in kind.functions
            if not (kind.m or spring):
                np.add.at(loads, self.tables.columns(group), np.abs(values[:, : kind.nu]))
        return loads

    def mixed_balance(self, at: State) -> tuple[Array, Array, Array]:
        """Same as :meth:`balance`, where elements keep unknowns ``at.inner`` themselves."""
        force, gaps, rates = self.balance(at)
        groups = self.tables.groups
        balanced = [g for g in groups if "balance" in g.kind.functions]
        plain = {id(g): x for g, x in zip(balanced, self.results("balance", at), strict=True)}
        mixed = [g for g in groups if "mixed" in g.kind.functions]
        for group, values in zip(mixed, self.results("mixed", at), strict=True):
            nu = group.kind.nu
            change = values[:, :nu] - plain[id(group)][:, :nu]
            np.add.at(force, self.tables.columns(group), change)
        return force, gaps, rates

    def mixed_tangent(self, at: State, parts: Sequence[str] = PARTS) -> dict[str, csr_matrix]:
        """Same as :meth:`tangent`, likewise."""
        groups = self.tables.groups
        numbers = [k for k, g in enumerate(groups) if "mixed" in g.kind.functions]
        stiffness = dict[int, Array]()
        for k, values in zip(numbers, self.results("mixed", at), strict=True):
            nu = groups[k].kind.nu
            stiffness[k] = values[:, nu : nu + nu * nu]
        return self.tangent(at, parts, stiffness=stiffness)

    def tangent(
        self,
        at: State,
        parts: Sequence[str] = PARTS,
        of: Callable[[Table], bool] = _all,
        stiffness: Mapping[int, Array] = NO_STIFFNESS,
    ) -> dict[str, csr_matrix]:
        """Matrices of all elements by name.

        K, C, M (nu, nu), R, G (m, nu): derivatives of the balance, rows of constraints; H (m, m):
        which of these no mode holds; L (m, nu): of elements with friction that follows from
        reactions the derivatives of the balance by -lam, in place of G.

        Args:
            at: The state.
            parts: Which of them.
            of: True of the elements whose matrices they are.
            stiffness: K of groups by their number (n, nu nu) that have another one.
        """
        tables = self.tables
        numbers = [k for k, g in enumerate(tables.groups) if "balance_tangent" in g.kind.functions]
        results = self.results("balance_tangent", at)
        pairs = [(k, x) for k, x in zip(numbers, results, strict=True) if of(tables.groups[k])]
        matrices = {}
        for name in parts:
            having = [(k, x) for k, x in pairs if name in tables.groups[k].kind.parts]
            pattern = tables.pattern(name, tuple(k for k, _ in having))
            blocks = [
                stiffness[k] if name == "K" and k in stiffness else _block(tables, name, k, x)
                for k, x in having
            ]
            matrices[name] = pattern.matrix(blocks)
        return matrices


def _block(tables: Tables, name: str, number: int, values: Array) -> Array:
    """Numbers of a matrix among the results of a group (n, size)."""
    rows, columns = tables.block(name, number)
    start = tables.groups[number].kind.parts[name]
    return values[:, start : start + rows.shape[1] * columns.shape[1]]
