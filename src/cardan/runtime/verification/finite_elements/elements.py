"""Functions of every kind of element, judged by each other and by laws that no element may break.

Momenta follow from kinetic energies, what constraints transmit from their rows; see
:mod:`.balances` and :mod:`.element_ends`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ..differences import BLURRED, BOUND, MARGIN, worst_of
from . import balances, derivatives, element_ends, element_events, wrenches
from .balances import NO_LAW
from .members import Members, NotThere


def check_kinds(members: Members) -> Iterator[tuple[str, float, str]]:
    """Name, error and reason of every function of a kind."""
    # what modes hold is judged in each of them
    modal, everywhere = "H" in members.table.kind.parts, members.in_all_modes
    for form in members.codes:
        at = everywhere if modal or form in element_events.LAWS else members
        at = at.weighed(form)
        error, why = _text(at, form), ""
        try:
            law = LAWS[form](at) if form in LAWS else NO_LAW
        except NotThere as missed:
            law = f"needs '{missed}'"
        if isinstance(law, str):
            why = law
        elif np.isnan(law):
            why = BLURRED
        else:
            error = worst_of(error, law)
        yield form, error, why


def _text(members: Members, form: str) -> float:
    """C against its expressions, of the largest entry, less what rounding of the inputs may do.

    NaN where expressions give no numbers.
    """
    expected = members.expressions(form)
    if expected is None:
        return np.nan
    results, good = members.call(form), np.isfinite(expected).all(axis=-1)
    if not good.any():
        return np.nan
    expected, results = expected[good], results[good]
    gap = np.nan_to_num(np.abs(results - expected), nan=np.inf).max(axis=-1, initial=0.0)
    size = float(np.abs(expected).max(initial=0.0)) or 1.0
    if gap.max(initial=0.0) > BOUND * size:
        # of the expressions alone: C that differs from call to call would excuse itself
        blur = members.blur(lambda at: (np.asarray(at.expressions(form)),))[good]
        # what is no number says nothing of rounding
        gap = np.maximum(gap - MARGIN * np.where(np.isfinite(blur), blur, 0.0), 0.0)
    return float(gap.max(initial=0.0)) / size


LAWS: dict[str, Callable[[Members], float | str]] = {
    **balances.LAWS,
    **element_ends.LAWS,
    **wrenches.LAWS,
    **element_events.LAWS,
    **derivatives.LAWS,
}
