"""Newmark's method with the average acceleration: no damping, so that it takes no constraints."""

from __future__ import annotations

from ..alpha import Alpha, record

METHOD = record("Newmark", Alpha.newmark())
