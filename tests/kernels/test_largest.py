"""Largest errors in the kernels: what is not a number is the largest, and stays."""

from __future__ import annotations

import ctypes
import re
from pathlib import Path

import numpy as np
import pytest

import cardan.kernels
from cardan.runtime.build import kernels
from cardan.runtime.sparse.block_solver import plan_record
from cardan.runtime.sparse.plan import plan

# an error that fmax gathers is 0 of numbers that are none: iterations end on it, steps are accepted
ERRORS = "by|change|correction|gap|inside|left|off|worst"
# `if (!(x <= largest)) largest = x`: of a NaN the next number takes the place
LOST = re.compile(
    r"if \(!\((?P<x>[^;{]+?) <= (?P<largest>\*?[\w>.\[\]-]+)\)\)(?: \{)?\s+"
    r"(?P=largest) = (?P=x)[;,]"
)
DROPPED = re.compile(rf"(\*?(?:{ERRORS})) = (?:fmax|cardan_most)\(\1, ")
CHOSEN = re.compile(
    rf"(\*?(?:{ERRORS})) = \w+ <=? \1 \? \1 :|(\*?(?:{ERRORS})) = (\w+) > \2 \? \3 :"
)


@pytest.mark.parametrize(
    "wrong",
    [
        "    if (!(here <= *left))\n        *left = here;",
        "        if (!(e * e <= worst)) {\n            worst = e * e;",
        "    *left = fmax(*left, fabs(x));",
        "    worst = off <= worst ? worst : off;",
        "    worst = off > worst ? off : worst;",
    ],
)
def test_the_mistake_is_seen(wrong: str) -> None:
    assert any(pattern.search(wrong) for pattern in (LOST, DROPPED, CHOSEN))


def test_no_number_takes_the_place_of_what_is_none() -> None:
    """In the C of all kernels: errors are gathered by ``cardan_worst`` and ``cardan_exceeds``."""
    folder = Path(next(iter(cardan.kernels.__path__)))
    files = [*folder.rglob("*.c"), *folder.rglob("*.h")]
    assert len(files) > 150
    wrong = {
        f"{file.name}: {' '.join(match[0].split())}"
        for file in files
        for pattern in (LOST, DROPPED, CHOSEN)
        for match in pattern.finditer(file.read_text("utf-8"))
    }
    assert not wrong


class _Panel(ctypes.Structure):
    """``cardan_panel``: a supernode of numbers."""

    _fields_ = (
        *((name, ctypes.c_ssize_t) for name in ("first", "n", "later")),
        *((name, ctypes.c_void_p) for name in ("d", "u", "lt")),
    )


@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_bound_that_is_not_a_number_stays(place: int) -> None:
    """Of three supernodes that do not meet, one has a factor that is not a number."""
    separate = plan([2, 2, 2], [])
    record, left = plan_record(separate), ctypes.c_double(0)
    sums, supernodes = np.zeros(6), 3
    for s in range(supernodes):
        d = np.full(4, np.nan if s == place else 1.0)
        panel = _Panel(2 * s, 2, 0, d.ctypes.data, d.ctypes.data, d.ctypes.data)
        kernels.library().cardan_sparse_bound(
            ctypes.byref(record),
            ctypes.c_ssize_t(s),
            ctypes.byref(panel),
            ctypes.c_void_p(sums.ctypes.data),
            ctypes.byref(left),
        )
    assert np.isnan(left.value)
