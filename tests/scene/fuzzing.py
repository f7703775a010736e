"""How much is tried by chance: the same few every day, or as many new cases as are asked for."""

from __future__ import annotations

import os

from hypothesis import HealthCheck, settings

CASES = os.environ.get("CARDAN_FUZZ")
FUZZ = settings(
    max_examples=int(CASES or 100),
    derandomize=CASES is None,
    database=None,
    deadline=None,
    suppress_health_check=list(HealthCheck),
)
