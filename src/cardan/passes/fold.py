"""Fold: every node once more through its constructor, and nothing that is not needed.

Numbers that meet are folded, structural zeros and ones disappear, equal expressions become one.
"""

from __future__ import annotations

from ..ir.function import Function
from ..ir.rewrite import rebuild_function


def fold(function: Function) -> Function:
    """The function in a graph that holds only what its results need."""
    return rebuild_function(function, thorough=True)
