"""A page in which a model runs: equations and integrator as WebAssembly, sliders and a mouse."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from .api.compiled_model import CompiledModel
from .api.equations import Equations
from .api.scene import Scene
from .arguments import checked
from .arrays import Array
from .codegen.wasm import live_model
from .codegen.wasm.memory import places, size
from .compilation import compile as compiled
from .errors import ArgumentError, ModelError, brief, near
from .pipeline import derive
from .runtime.trajectory.trajectory import TrajectoryRecord
from .schema.blocks import ORDER
from .schema.manifest import Manifest
from .view import live_page
from .view import page as pages
from .view.drawing import SPRINGS, Drawing
from .view.packing import JsonObject
from .view.solids import Solid

# what a slider runs over where nobody says: parts of the value, or this where it is 0
SPAN, AROUND_ZERO = (0.25, 4.0), (-1.0, 1.0)
# seconds of motion by which the camera is placed
PREVIEW = 5.0
# time in which coordinates go onto the constraints: nothing moves [s]
INSTANT = 1e-9
ENERGIES = ("kinetic", "potential", "total")
# below this rtol the error of a step drowns in rounding
FINEST = 2.5e-14
# words of addresses that mean something else
TAKEN = frozenset({"t", "show", "theme", "bare", "view"})
Range = tuple[float, float] | None


@checked
def page(
    scene: Scene | Equations,
    path: str | Path | None = None,
    *,
    sliders: Mapping[str, Range] | Sequence[str] | None = None,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    u: Mapping[str, ArrayLike] | ArrayLike | None = None,
    plots: str | Sequence[str] | None = None,
    traces: str | Sequence[str] = (),
    drag: bool = True,
    meshes: str | float | bool = "auto",
    page: str = "auto",
    rtol: float = 1e-6,
    title: str | None = None,
) -> pages.Page:
    """A self-contained page in which the model runs: nothing is recorded, everything computed.

    Parameters and inputs are sliders, bodies are pulled with the mouse, and a link holds the values
    (``page.html#m=2``). The equations are WebAssembly that cardan writes itself and the integrator
    is that of ``simulate``: no compiler, no server, no network.

    Args:
        scene: A scene of rigid bodies in joint coordinates, with loops, events and controllers, or
            its equations.
        path: HTML file. It appears complete or not at all. Without one a notebook shows the page,
            or a browser.
        sliders: Parameters and inputs, as names, or with the ends of their ranges
            ``{"m": (0.1, 5), "l": None}``; by default the parameters and inputs that the scene
            declares.
        q, u: Where it starts, as ``simulate`` takes them.
        plots: Histories: coordinates, speeds, outputs, ``"energy"``; by default energies.
        traces: Frames whose paths are drawn.
        drag: Whether the mouse pulls bodies.
        meshes: As ``animate`` takes it.
        page: ``"3d"``, ``"plain"`` (drawn on a 2-D canvas, a tenth of the size), or ``"auto"``:
            plain without meshes.
        rtol: Relative tolerance of the integration; a thousandth of it is the absolute one.
        title: Headline, the name of the model by default.

    Returns:
        The page; ``.path`` is its file.

    Raises:
        ModelError: beams or superelements, or nothing that can be drawn.
        ArgumentError: an unknown parameter, input, history or frame; an empty range.
    """
    equations = _equations(scene)
    kinds = ("auto", *pages.PAGES)
    if page not in kinds:
        raise ArgumentError(f"page='{page}': there is no such page.{near(page, kinds)}")
    if not rtol > 0:
        raise ArgumentError(f"rtol={rtol:g}: give a positive number, such as 1e-6")
    rtol = max(rtol, FINEST)
    model = compiled(equations)
    x = np.asarray(model.simulate((0.0, INSTANT), q=q, u=u, check=True).x[0])
    preview = _preview(model, x)
    options = pages.PageOptions(traces=(traces,) if isinstance(traces, str) else traces)
    for name in options.traces:
        if name not in model.frames:
            raise ArgumentError(f"traces: '{name}' is not a frame.{near(name, model.frames)}")
    drawing = pages.drawing_of([preview], options)
    spec, module = _specification(equations, preview, drawing, x)
    spec |= {"drag": drag, "rtol": rtol, "atol": 1e-3 * rtol}
    spec["sliders"] = _sliders(equations, preview, sliders)
    spec["shapes"] = live_page.shapes(preview, spec["sliders"])
    spec["plots"] = _plots(preview.manifest, "energy" if plots is None else plots)
    if page == "auto":
        solids = [solid for body in drawing.bodies for solid in body.solids]
        page = "3d" if meshes is not False and _has_meshes(solids) else "plain"
    return live_page.page(drawing, spec, module, path, page, pages.detail_of(meshes), title)


def _equations(scene: Scene | Equations) -> Equations:
    """Equations in joint coordinates.

    Raises:
        ModelError: beams or superelements.
    """
    equations = scene if isinstance(scene, Equations) else derive(scene)
    if isinstance(equations, Equations):
        return equations
    raise ModelError(
        f"'{equations.system.name}': a page that computes takes rigid bodies in joint coordinates; "
        "beams, cables and superelements do not run in it. Record their motion: "
        "model.simulate(10.0).animate('page.html')"
    )


def _has_meshes(solids: Sequence[Solid]) -> bool:
    return any(solid["kind"] == "mesh" for solid in solids)


def _specification(
    equations: Equations, preview: TrajectoryRecord, drawing: Drawing, x: Array
) -> tuple[JsonObject, bytes]:
    """What ``live.js`` has to know of the model, and the model as WebAssembly."""
    manifest = preview.manifest
    bodies, traces = [body.name for body in drawing.bodies], list(drawing.traces)
    ends = [row.frames for row in manifest.forces if row.kind in SPRINGS]
    frames = [*bodies, *traces, *(row[end] for row in ends for end in "ab")]
    live = live_model.build(equations, frames, {})
    exported = "cardan_exported_function"
    assert preview.model is not None
    return {
        "scene": live.scene,
        "end": live.end,
        "table": live.table,
        "functions": live.functions,
        "records": live.records,
        "settings": size("cardan_simulation"),
        "slots": list(ORDER),
        "exported": {"size": size(exported), "function": places(exported)["function"][0]},
        "parameters": preview.model.parameters.vector.tolist(),
        "inputs": [float(entry.default) for entry in manifest.inputs],
        "start": {"x": x.tolist(), "s": [float(entry.default) for entry in manifest.s]},
        "closed": bool(manifest.projected and manifest.multipliers),
        "ticks": [[float(tick.period), float(tick.phase)] for tick in manifest.ticks],
        "bodies": bodies,
        "traces": traces,
    }, live.module


def _preview(model: CompiledModel, x: Array) -> TrajectoryRecord:
    """Some motion by which the camera is placed; the start alone where there is none."""
    try:
        motion = model.simulate(PREVIEW, x0=x)
        if motion.success and np.isfinite(motion.x).all():
            return motion
    except ModelError:
        # a model that cannot run for so long is shown all the same
        pass
    return model.simulate((0.0, INSTANT), x0=x)


def _sliders(
    equations: Equations,
    preview: TrajectoryRecord,
    sliders: Mapping[str, Range] | Sequence[str] | None,
) -> list[JsonObject]:
    """What each slider changes, and its range.

    Raises:
        ArgumentError: an unknown name, an empty range.
    """
    assert preview.model is not None
    manifest, p = preview.manifest, preview.model.parameters.vector
    inputs = [entry.name for entry in manifest.inputs]
    parameters = [entry.name for entry in manifest.parameters]
    if isinstance(sliders, str):
        sliders = [sliders]
    elif sliders is None:
        declared = [one.name for one in equations.system.parameters if one.declared]
        sliders = [*declared, *inputs]
    ranges = sliders if isinstance(sliders, Mapping) else dict.fromkeys(sliders)
    rows: list[JsonObject] = []
    for name, span in ranges.items():
        if name in parameters:
            kind, index = "parameter", parameters.index(name)
            unit, value = manifest.parameters[index].unit, float(p[index])
        elif name in inputs:
            kind, index = "input", inputs.index(name)
            unit, value = manifest.inputs[index].unit, float(manifest.inputs[index].default)
        else:
            hint = near(name, [*parameters, *inputs])
            raise ArgumentError(f"sliders: '{name}' is neither a parameter nor an input.{hint}")
        low, high = _span(name, span, value)
        if kind == "parameter":
            _settable(preview, name, low, high)
        key = f"p.{name}" if name in TAKEN else name
        rows.append(
            {"name": name, "key": key, "kind": kind, "index": index, "unit": unit}
            | {"low": min(low, value), "high": max(high, value), "value": value}
        )
    return rows


def _settable(preview: TrajectoryRecord, name: str, *ends: float) -> None:
    """Ensure that a model takes the ends of a range.

    Raises:
        ArgumentError: it refuses one, such as a negative mass.
    """
    assert preview.model is not None
    for end in ends:
        try:
            preview.model.with_parameters({name: end})
        except ModelError as problem:
            raise ArgumentError(f"sliders: {problem}; give another range") from problem


def _span(name: str, span: Range, value: float) -> tuple[float, float]:
    """Ends of the range of a slider.

    Raises:
        ArgumentError: it has none.
    """
    if span is None:
        low, high = sorted(part * value for part in SPAN) if value else AROUND_ZERO
        return low, high
    try:
        low, high = (float(end) for end in (() if isinstance(span, str) else span))
    except (TypeError, ValueError):
        low = high = np.nan
    if not (np.isfinite([low, high]).all() and low < high):
        raise ArgumentError(
            f"sliders: '{name}': {brief(span)} is not a range: give two numbers such as (0.1, 5), "
            "or None"
        )
    return low, high


def _plots(manifest: Manifest, plots: str | Sequence[str]) -> list[JsonObject]:
    """Curves of histories, by unit; where their numbers come from.

    Raises:
        ArgumentError: there is no such history.
    """
    sources: dict[str, tuple[str, int, str]] = {}
    states = [*manifest.coordinates, *manifest.speeds, *manifest.z]
    for k, row in enumerate(states):
        sources[row.name] = "x", k, row.unit
    for k, output in enumerate(manifest.outputs):
        sources[output.name] = "outputs", k, output.unit
    energies = {name: ("energy", k, "J") for k, name in enumerate(ENERGIES)}
    groups: dict[str, list[JsonObject]] = {}
    for name in (plots,) if isinstance(plots, str) else plots:
        if name != "energy" and name not in sources:
            hint = near(name, ["energy", *sources])
            raise ArgumentError(f"plots: there is no history '{name}'.{hint}")
        curves = energies if name == "energy" else {name: sources[name]}
        for label, (of, index, unit) in curves.items():
            groups.setdefault(unit, []).append({"name": label, "of": of, "index": index})
    return [
        {"name": curves[0]["name"] if len(curves) == 1 else _group(unit), "unit": unit}
        | {"curves": curves}
        for unit, curves in groups.items()
    ]


def _group(unit: str) -> str:
    """What curves of a unit are called together."""
    return {"J": "energy", "rad": "angles", "m": "positions", "rad/s": "rates"}.get(unit, "values")
