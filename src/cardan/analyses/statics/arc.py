"""Load paths by their length: through limit loads, where the load turns back."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...runtime.models.loaded_model import LoadedModel
from ..continuation.curve import Curve
from ..continuation.equilibria import EquilibriumFamily, Loaded
from ..continuation.family import along_parameter
from ..continuation.follow import Place as ArcPlace
from ..continuation.follow import Reach, place
from ..continuation.mode_changes import corner_within
from ..continuation.special_points import EVENT, FOLD, Test, Watch
from ..continuation.stability_cache import StabilityCache
from ..continuation.tracing import trace
from .continuation_step import Crossing, Place, place_of
from .equilibrium import EquilibriumRecord
from .load_path import Loading
from .newton import Search
from .static_problem import Problem

MOST = 1000  # points of a path


def follow_by_length(
    model: LoadedModel,
    problem: Problem,
    way: Loading,
    start: Search,
    row: Callable[[Search, Place], EquilibriumRecord],
    rows: list[tuple[float, EquilibriumRecord]],
    crossed: list[Crossing],
) -> str:
    """Note equilibria up to the end of the loads; why they end before, or nothing.

    Args:
        model, problem, way: What is loaded, along which path.
        start: The equilibrium at its start; its row is the caller's.
        row: Makes a row of an equilibrium.
        rows, crossed: Take rows and critical loads as they come.
    """
    family = EquilibriumFamily.of(problem, way, start.point)
    stabilities, names = StabilityCache(problem), [e.name for e in model.manifest.events]
    curve = Curve(family, [place(family, family.start(start.point), along_parameter(family))])
    last = _place(stabilities, curve.places[0], None)
    noted = 0

    def on_step(curve: Curve) -> None:
        nonlocal last, noted
        here = _place(stabilities, curve.places[-1], last)
        for special in curve.special[noted:]:
            if special.kind != EVENT:
                exact = _place(stabilities, special.place, last)
                limit = special.kind == FOLD
                after, of = (exact, "limit") if limit else (here, "held")
                crossed.append(Crossing(last, after, of, exact))
        noted, last = len(curve.special), here
        rows.append((here.s, row(Search(here.point, 0, True, np.zeros(0)), here)))

    end = Test.at("the end", 1.0, family)
    watch = Watch(
        stabilities.count, stabilities.growth, tests=[end], most=MOST, switches=False,
        corner=lambda step, number: corner_within(family, names, step, number),
    )  # fmt: skip
    trace(curve, watch, Reach(), on_step)
    if curve.status == "finished":
        on_step(curve)
        return ""
    return f"the path {curve.ended}"


def _place(stabilities: StabilityCache, at: ArcPlace, last: Place | None) -> Place:
    """A place of the path with its stability."""
    loaded: Loaded = at.point
    return place_of(loaded.s, loaded.point, stabilities.stability(loaded), last)
