"""Known values that scenes with superelements have, and beams where they are of a continuum."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from superelements import blades
from superelements import scene_problems as problems

LONG = (
    problems.spin_and_translation,
    problems.frame_of_two,
    problems.spin_of_beams,
    problems.satellite,
    problems.satellite_of_beams,
    problems.top_of_beams,
    blades.top_on_superelements,
    blades.blade_of_beams,
    blades.chains,
)


PROBLEMS = [problems.spinning_bars, *(pytest.param(one, marks=pytest.mark.slow) for one in LONG)]


@pytest.mark.parametrize("problem", PROBLEMS)
def test_known_values(problem: Callable[[], Iterator[problems.Row]]) -> None:
    missed = []
    for what, found, expected, allowed in problem():
        size = np.where(np.asarray(expected) == 0, 1.0, np.abs(expected))
        error = float((np.abs(np.asarray(found) - expected) / size).max())
        print(f"{problem.__name__}, {what}: error {error:.1e} of {allowed:.0e}")
        if not error <= allowed:
            missed.append(f"{what}: {error:.1e} of {allowed:.0e}")
    assert not missed
