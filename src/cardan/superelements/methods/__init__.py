"""Reductions of a component to its interfaces: one method is one file here."""

from __future__ import annotations

from collections.abc import Callable

from ..component import Component
from .craig_bampton import craig_bampton
from .guyan import guyan
from .macneal import macneal
from .method import ReducedBasis
from .rubin import rubin

METHODS: dict[str, Callable[[Component, int], ReducedBasis]] = {
    method.__name__: method for method in (craig_bampton, guyan, macneal, rubin)
}
# methods that keep no modes
STATIC = frozenset({"guyan"})
