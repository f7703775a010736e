"""The method of Hilber, Hughes and Taylor."""

from __future__ import annotations

from dataclasses import replace

from .alpha_family import FAMILY, MODIFIED, STABILIZED

ALPHA = -0.1

METHOD = replace(
    FAMILY,
    name="HHT",
    options=(0.0, -ALPHA, (1 - ALPHA) ** 2 / 4, 0.5 - ALPHA, STABILIZED, MODIFIED),
)
