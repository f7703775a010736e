"""The method of Hilber, Hughes and Taylor."""

from __future__ import annotations

from ..alpha import Alpha, record

METHOD = record("HHT", Alpha.hht())
