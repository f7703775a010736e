"""The page of a model that runs in it; ``live.js`` runs, ``live_panel.js`` has the sliders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from ..arrays import Array
from ..codegen.wasm import prebuilt
from ..errors import CardanError
from ..runtime.trajectory.trajectory import TrajectoryRecord
from .drawing import Drawing, solids_of
from .packing import JsonObject, deflated
from .page import Page, drawing_page, text_of
from .solids import Solid

KERNELS = "kernels"
# values of a slider at which solids are looked at; what of a solid they may change
SAMPLES = 9
GEOMETRY = frozenset({"a", "b", "r", "end", "size"})
STYLE = """<style>
  #live { position: fixed; left: 14px; top: 56px; width: 260px; max-width: calc(100vw - 28px); z-index: 2; }
  #live details { background: var(--panel, var(--paper)); border: 1px solid var(--faint); border-radius: 10px; padding: 6px 12px 8px; }
  #live summary { cursor: pointer; border: 0; padding: 2px 0; background: none; font-weight: 600; }
  #live-sliders { display: grid; grid-template-columns: auto minmax(60px, 1fr) auto; gap: 3px 9px; align-items: center; max-height: 45vh; overflow: auto; }
  #live-sliders input { width: 100%; min-width: 0; accent-color: var(--accent); }
  #live-sliders output { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; min-width: 0; }
  #live-buttons { display: flex; gap: 6px; margin-top: 7px; align-items: center; flex-wrap: wrap; }
  #live button, #live select, #live-bar button { width: auto; height: auto; min-height: 30px; border-radius: 7px; border: 1px solid var(--faint); background: transparent; color: inherit; font: inherit; padding: 2px 9px; cursor: pointer; }
  #live-buttons output { min-width: 4.6em; text-align: right; font-variant-numeric: tabular-nums; flex: 1; }
  #live-said { margin: 6px 0 0; color: var(--soft); font-size: 12.5px; } #live-said:empty { display: none; }
  #live-bar { position: fixed; left: 0; right: 0; bottom: 0; display: block; padding: 4px 14px 6px; background: var(--panel, var(--paper)); border-top: 1px solid var(--faint); z-index: 2; font-size: 12.5px; }
  main ~ #live-bar { position: static; flex: none; }
  #live-bar[hidden] { display: none; }
  #live-tabs { display: flex; gap: 4px 12px; flex-wrap: wrap; align-items: center; }
  #live-tabs button { min-height: 24px; padding: 0 8px; } #live-tabs button[aria-selected="true"] { border-color: var(--accent); color: var(--accent); }
  #live-legend { display: flex; gap: 2px 14px; flex-wrap: wrap; font-variant-numeric: tabular-nums; }
  #live-legend span::before { content: ""; display: inline-block; width: 14px; border-top: 3px solid var(--c); margin-right: 5px; vertical-align: middle; }
  #live-strip { position: static; width: 100%; height: 88px; display: block; cursor: default; color: var(--soft); }
  @media (max-width: 640px) { #live { top: 48px; left: 8px; } #live-strip { height: 64px; } }
</style>
"""


def page(
    drawing: Drawing,
    spec: JsonObject,
    module: bytes,
    path: str | Path | None,
    kind: str,
    detail: str | float,
    title: str | None,
) -> Page:
    """The page.

    Args:
        drawing: Some motion of the model, of which the first row is drawn.
        spec: What the page has to know of the model, as ``live.js`` takes it.
        module: The model as WebAssembly.
        path, kind, detail, title: As ``drawing_page`` takes them.
    """
    low, high = _reach(drawing)
    reach = {"low": low, "high": high, "size": max(1e-6, *(b - a for a, b in zip(low, high, strict=True)))}
    # the script of the plain page comes along, deflated
    scripts = ("live.js", "live_panel.js", *(["plain.js"] if kind == "plain" else []))
    program = deflated("".join(map(text_of, scripts)).replace('"use strict";', "").encode())
    block = "\n".join(
        (
            STYLE + '<section id="live"></section>',
            f'<script type="text/plain" id="live-kernels">{deflated(prebuilt.content(KERNELS))}</script>',
            f'<script type="text/plain" id="live-model">{deflated(module)}</script>',
            f'<script type="text/plain" id="live-program">{program}</script>',
            f"<script>{text_of('live_start.js')}</script>",
        )
    )
    return drawing_page(drawing.still, path, kind, detail, title, (spec | {"reach": reach}, block))


def shapes(motion: TrajectoryRecord, sliders: Sequence[JsonObject]) -> list[JsonObject]:
    """What changes in the solids of bodies and ground over the ranges of sliders.

    Args:
        motion: A motion at the usual values.
        sliders: Of parameters and inputs, as ``live.js`` takes them.

    Returns:
        One entry per field that changes: number of the slider, values of the slider, number of the
        body (-1: ground) and of the solid, name of the field, its values.
    """
    usual, changes = _solids(motion), list[JsonObject]()
    for k, slider in enumerate(sliders):
        if slider["kind"] != "parameter" or motion.model is None:
            continue
        values = np.unique([*np.linspace(slider["low"], slider["high"], SAMPLES), slider["value"]])
        rows = [_solids_at(motion, slider["name"], float(value)) for value in values]
        for body, solids in usual.items():
            for n, solid in enumerate(solids):
                # at some values there may be more solids, or others
                each = [row[body][n] if n < len(row.get(body, ())) else solid for row in rows]
                for name in GEOMETRY & solid.keys():
                    seen = [_rounded(one.get(name, solid[name])) for one in each]
                    if any(value != _rounded(solid[name]) for value in seen):
                        entry = {"slider": k, "at": _rounded(values.tolist()), "body": body, "solid": n}
                        changes.append(entry | {"field": name, "values": seen})
    return changes


def _rounded(value: Any) -> Any:
    """Numbers of JSON to six digits."""
    return [_rounded(x) for x in value] if isinstance(value, list) else float(f"{value:.6g}")


def _solids(motion: TrajectoryRecord) -> dict[int, list[Solid]]:
    """Solids by the number of their body; -1: the ground."""
    bodies, ground, *_ = solids_of(motion)
    return {-1: ground, **{k: body.solids for k, body in enumerate(bodies)}}


def _solids_at(motion: TrajectoryRecord, name: str, value: float) -> dict[int, list[Solid]]:
    """The same at another value of a parameter; none where that is impossible."""
    assert motion.model is not None
    try:
        return _solids(replace(motion, model=motion.model.with_parameters({name: value})))
    except CardanError:
        return {}


def _reach(drawing: Drawing) -> tuple[list[float], list[float]]:
    """Corners of the box in which bodies move; of their start alone where they go far."""
    start, every = (_box(drawing, rows) for rows in (slice(0, 1), slice(None)))
    far = np.ptp(every, axis=0).max() > 3 * np.ptp(start, axis=0).max()
    low, high = start if far else every
    return low.tolist(), high.tolist()


def _box(drawing: Drawing, rows: slice) -> Array:
    """Corners (2, 3) of the box around what is drawn at some rows."""
    lows, highs = [], []
    for body in drawing.bodies:
        poses = body.poses[rows]
        for solid in body.solids if all("a" in s for s in body.solids) else ():
            ends = [np.asarray(solid[key], dtype=np.float64) for key in ("a", "b") if key in solid]
            radius = float(np.linalg.norm(solid["size"]) / 2 if "size" in solid else solid.get("r", 0.0))
            for end in ends:
                at = poses[:, :3, :3] @ end + poses[:, :3, 3]
                lows.append(at.min(axis=0) - radius)
                highs.append(at.max(axis=0) + radius)
        lows.append(poses[:, :3, 3].min(axis=0))
        highs.append(poses[:, :3, 3].max(axis=0))
    return np.array([np.min(lows, axis=0), np.max(highs, axis=0)])
