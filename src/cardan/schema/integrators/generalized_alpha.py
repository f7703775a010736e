"""The generalized-alpha method by Chung and Hulbert."""

from __future__ import annotations

from dataclasses import replace

from .alpha_family import FAMILY, MODIFIED, STABILIZED

RHO_INF = 0.8  # what is too fast for a step keeps this part of itself
AM, AF = (2 * RHO_INF - 1) / (RHO_INF + 1), RHO_INF / (RHO_INF + 1)

METHOD = replace(
    FAMILY,
    name="GeneralizedAlpha",
    options=(AM, AF, (1 - AM + AF) ** 2 / 4, 0.5 - AM + AF, STABILIZED, MODIFIED),
    conditions=("damping_capped", *FAMILY.conditions),
)
