"""The hard cases: every one a file with a scene, an oracle and what is expected of every method."""

from __future__ import annotations

from . import (
    bricard,
    chain,
    chaos,
    chatter,
    fast_top,
    flexible,
    four_bar,
    free_body,
    gimbal,
    mass_ratio,
    reduced,
    satellite,
    stick_slip,
    stiff_spring,
    units,
)
from .case import Case

CASES: dict[str, Case] = {
    case.name: case
    for case in (
        chaos.CASE,
        *gimbal.CASES,
        fast_top.CASE,
        chain.CASE,
        mass_ratio.CASE,
        stiff_spring.CASE,
        four_bar.CASE,
        bricard.CASE,
        units.TINY,
        units.HUGE,
        free_body.CASE,
        free_body.LONG,
        stick_slip.CASE,
        chatter.CHATTER,
        chatter.SETTLED,
        satellite.CASE,
        *flexible.CASES,
        *reduced.CASES,
    )
}

__all__ = ["CASES", "Case"]
