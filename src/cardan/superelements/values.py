"""Numbers and names that users give, checked."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..errors import ModelError, brief

LARGEST = 1e100  # of an entry, far beyond any unit
LONGEST = 200  # letters of a name


def numbers(who: str, values: object) -> Array:
    """Real numbers as an array.

    Raises:
        ModelError: something else.
    """
    try:
        array = unmasked(who, values)
    except ModelError:
        raise
    except ValueError:
        raise ModelError(f"{who}: rows of different lengths; give an array of numbers") from None
    if array.dtype.kind not in "fiu":
        raise ModelError(f"{who}={brief(values)}: give real numbers")
    return array.astype(np.float64)


def unmasked(who: str, values: object) -> NDArray[np.generic]:
    """Values as an array.

    Raises:
        ModelError: some are masked: they are not known.
    """
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ModelError(f"{who}: {int(np.sum(values.mask))} entries are masked; fill them")
    return np.asarray(values)


def checked_name(who: str, name: object) -> str:
    """A name that can be printed and saved.

    Raises:
        ModelError: something else.
    """
    if not isinstance(name, str) or not name or not name.isprintable() or len(name) > LONGEST:
        raise ModelError(
            f"{who}: {brief(name)} is not a name; give 1 to {LONGEST} letters that can be printed"
        )
    return name
