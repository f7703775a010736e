"""Mechanisms of the zoo: lanes give the bits of single runs, whatever the joints and forces."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import cardan as cd
from analyses.ensembles.test_bits import lanes, same
from cardan.runtime.models.constraint_projection import Closing
from mechanisms import ZOO
from spread import some

pytestmark = pytest.mark.optimized


@pytest.mark.parametrize("name", some(sorted(ZOO), 7))
def test_bits(name: str) -> None:
    model = cd.compile(ZOO[name].build())
    if Closing.of(model).rows or not model.nu:
        pytest.skip("no tree that moves")
    states = model.random_state(2, (13,))
    with warnings.catch_warnings():
        # some break down, all in the same way
        warnings.simplefilter("ignore", cd.SolveWarning)
        alone = model.ensemble(0.2, x0=states, lanes=1, threads=1)
        wide = lanes(model, 0.2, x0=states, threads=1)
        motion = wide.run(5)
    same(wide, alone)
    assert wide.job.width > 1
    assert motion.status == alone.status[5]
    np.testing.assert_array_equal(motion.x[-1], alone.final[5])
