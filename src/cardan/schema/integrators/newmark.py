"""Newmark's method with the average acceleration: no damping, so that it takes no constraints."""

from __future__ import annotations

from dataclasses import replace

from .alpha_family import FAMILY, MODIFIED, STABILIZED

METHOD = replace(FAMILY, name="Newmark", options=(0.0, 0.0, 0.25, 0.5, STABILIZED, MODIFIED))
