"""The generalized-alpha method by Chung and Hulbert."""

from __future__ import annotations

from ..alpha import Alpha, record

METHOD = record("GeneralizedAlpha", Alpha.chung_hulbert(), chosen=True)
