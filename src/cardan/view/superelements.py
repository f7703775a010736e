"""Modes of superelements as pages and pictures, and superelements of motions as pictures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..arguments import checked
from ..arrays import Array, Integers
from ..errors import ArgumentError, ModelError, brief, counted, near
from ..runtime.models.finite_elements.superelements import DeformedSuperelementRecord
from ..superelements.mode_shapes import FIXED, ModeShape, mode_shape
from ..superelements.moving_surface import stressed_points
from ..superelements.node_dofs import COMPONENTS
from ..superelements.record import SuperelementRecord
from .drawing import FOLLOWED, Abscissa, Drawing, rate_below
from .page import Page, drawing_page
from .solids import DARK, DrawnBody
from .surface_plot import plot_surface
from .surfaces import DISPLACEMENT, NAMES, VON_MISES, DrawnSurface, drawn_surface, outline

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NAME = "component"  # in pictures: a record has no name of its own
LARGEST = 0.12  # displacement of a shape by default, of the size of the component
PICTURES = 60  # of one period
BALL = 0.012  # radius of the mark of an interface, of the size of the component


@checked
def animate(
    record: SuperelementRecord,
    mode: int | str = 1,
    path: str | Path | None = None,
    *,
    which: str = FIXED,
    locked: Sequence[str] | None = None,
    scale: float | None = None,
    color: str | None = DISPLACEMENT,
    title: str | None = None,
) -> Page:
    """A page that plays a mode of the component in any browser, one period again and again.

    Without a path, a notebook shows the page in place; elsewhere it is opened in the browser.

    Args:
        record: The component.
        mode: Number from 1; of static shapes also the motion, such as ``"hinge.rx"``.
        path: HTML file. It appears complete or not at all.
        which: ``"fixed"``, modes with interfaces fixed; ``"free"``, modes of the free component;
            ``"static"``, shapes by unit motions of interfaces.
        locked: Interfaces or motions that are fixed, of ``"fixed"``; all by default.
        scale: Factor of the shape, of unit modal mass, or of 1 m or 1 rad. By default one can see
            it well.
        color: ``"displacement"``; ``"stress"`` of von Mises, where the record has stress at nodes;
            None for one color. The legend has values of the largest deflection that is drawn.
        title: Headline.

    Returns:
        The page; ``.path`` is its file.

    Raises:
        ModelError: no such mode or interface, or no stress. ArgumentError: other unknown words.
        SolveError: as :meth:`.Superelement.modes`.
    """
    shape = mode_shape(record, mode, which, locked)
    phase = 2 * np.pi * np.linspace(0.0, 1.0, PICTURES + 1)
    surface = _surface(record, shape, np.sin(phase), scale, color)
    if shape.omega:
        frequency = shape.omega / (2 * np.pi)
        abscissa, rate = Abscissa(phase / shape.omega), rate_below(FOLLOWED / frequency)
    else:
        abscissa, rate = Abscissa(phase / (2 * np.pi), "part of a period", ""), FOLLOWED / 2
    drawing = Drawing(
        name=shape.description,
        abscissa=abscissa,
        bodies=_interfaces(record, shape, surface.amplitudes[:, 0]),
        ground=[],
        beams=[],
        surfaces=[surface],
        rate=rate,
        layers=(color,) if color else (),
    )
    return drawing_page(drawing, path, title=title)


@checked
def plot(
    record: SuperelementRecord,
    mode: int | str = 1,
    path: str | Path | None = None,
    *,
    which: str = FIXED,
    locked: Sequence[str] | None = None,
    scale: float | None = None,
    color: str | None = DISPLACEMENT,
) -> Figure:
    """A mode of the component as a Matplotlib figure, written to ``path`` if given.

    Args:
        record: The component.
        mode, which, locked, scale, color: As :meth:`.Superelement.animate`.
        path: Picture file; the ending says the format.

    Raises:
        ModelError, ArgumentError, SolveError: as there, or no picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    shape = mode_shape(record, mode, which, locked)
    surface = _surface(record, shape, np.ones(1), scale, color)
    return plot_surface(shape.description, surface, path)


@checked
def plot_deformed(
    deformed: DeformedSuperelementRecord,
    path: str | Path | None = None,
    *,
    row: int = -1,
    color: str | None = None,
) -> Figure:
    """The deformed superelement as a Matplotlib figure, written to ``path`` if given.

    Args:
        deformed: The superelement.
        path: Picture file; the ending says the format.
        row: Of the motion, the last one by default.
        color: ``"stress"`` of von Mises or ``"displacement"``; by default stress, where it is
            known.

    Raises:
        ModelError: no stress, or no picture file. ArgumentError: there is no such row or color.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    amplitudes, poses = deformed.amplitudes, deformed.pose.reshape(-1, 4, 4)
    z = amplitudes.reshape(-1, amplitudes.shape[-1])
    if color not in (*NAMES, None):
        raise ArgumentError(f"color={brief(color)}: there is no such color.{near(color, NAMES)}")
    if not -len(z) <= row < len(z):
        raise ArgumentError(f"row={row}: '{deformed.name}' has {counted(len(z), 'row')}")
    if color == VON_MISES:
        deformed.check_stress()
    kind = color or (VON_MISES if len(deformed.stressed) else DISPLACEMENT)
    surface = drawn_surface(deformed, kind)
    edges = outline(surface.points, surface.triangles)
    one_row = replace(surface, amplitudes=z[[row]], poses=poses[[row]], outline=edges)
    return plot_surface(deformed.name, one_row, path)


def _surface(
    record: SuperelementRecord,
    shape: ModeShape,
    course: Array,
    scale: float | None,
    color: str | None,
) -> DrawnSurface:
    """The surface of a component in a shape, its amplitude following a course."""
    if color not in (*NAMES, None):
        raise ArgumentError(f"color={brief(color)}: there is no such color.{near(color, NAMES)}")
    if scale is not None and not (math.isfinite(scale) and abs(scale) < 1e100):
        raise ArgumentError(f"scale={scale:g}: give a finite number, the factor of the shape")
    surface, points = record.surface, record.surface_points
    moved = record.surface_displacements(shape.z)
    factor = _visible(record, points, moved) if scale is None else scale
    stressed, stresses = _stresses(record, shape.z, color)
    triangles, lines = surface.triangles, surface.lines
    return DrawnSurface(
        name=NAME,
        points=points,
        triangles=triangles,
        lines=lines,
        outline=outline(points, triangles) if len(triangles) else lines,
        shapes=moved[None],
        amplitudes=factor * course[:, None],
        kind=color,
        stressed=stressed,
        stresses=stresses,
    )


def _visible(record: SuperelementRecord, points: Array, moved: Array) -> float:
    """Factor by which one sees a shape well."""
    positions = np.vstack([points, *(np.array([one.position]) for one in record.interfaces)])
    size = float(np.ptp(positions, axis=0).max()) or 1.0
    largest = float(np.linalg.norm(moved, axis=1).max(initial=0.0))
    return LARGEST * size / largest if largest > 0 else 1.0


def _stresses(record: SuperelementRecord, z: Array, color: str | None) -> tuple[Integers, Array]:
    """Points with stress, and their stress (1, k, 6); none where stress is not drawn.

    Raises:
        ModelError: no point has it.
    """
    if color != VON_MISES:
        return np.zeros(0, np.intp), np.zeros((1, 0, 6))
    points, rows = stressed_points(record)
    if not len(points):
        raise ModelError(
            "color='stress': the component has no stress at nodes that are drawn. Give from_mesh "
            "stress=, the surface or set; or reduce rows of stress whose stress_names are "
            "'17 xx', '17 yy', '17 zz', '17 yz', '17 zx', '17 xy' for node 17"
        )
    return points, record.stresses(z)[rows][None]


def _interfaces(record: SuperelementRecord, shape: ModeShape, course: Array) -> list[DrawnBody]:
    """Balls at the interfaces, which move with them."""
    from scipy.spatial.transform import Rotation

    size = float(np.ptp(record.surface_points, axis=0).max()) or 1.0
    bodies, first = [], 0
    for frame in record.interfaces:
        motion = np.zeros(6)
        for name in frame.components:
            motion[COMPONENTS.index(name)] = shape.z[first]
            first += 1
        poses = np.tile(np.eye(4), (len(course), 1, 1))
        poses[:, :3, 3] = np.asarray(frame.position) + course[:, None] * motion[:3]
        poses[:, :3, :3] = Rotation.from_rotvec(course[:, None] * motion[3:]).as_matrix()
        ball = {"kind": "sphere", "a": [0.0, 0.0, 0.0], "r": BALL * size, **DARK}
        bodies.append(DrawnBody(frame.name, [ball], [], poses))
    return bodies
