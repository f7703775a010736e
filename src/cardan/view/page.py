"""One self-contained page that plays a motion: no network, no server, nothing to install."""

from __future__ import annotations

import html
import json
import re
import sys
import tempfile
import webbrowser
from collections.abc import Sequence
from dataclasses import field, replace
from functools import cache
from pathlib import Path
from typing import TypeAlias, final

import numpy as np
from numpy.typing import NDArray

from ..arguments import checked
from ..atomic_file import folder, written
from ..errors import ArgumentError, CardanError, ModelError, near
from ..records import dataclass
from ..runtime.trajectory import frame_history
from ..runtime.trajectory.trajectory import TrajectoryRecord
from . import curves, plain_page, scene_page
from . import drawing as drawn
from .curves import HasHistories
from .drawing import Abscissa, Drawing
from .packing import JsonObject, deflated, text_of
from .supports import supports

PICTURES = 1500  # a longer motion gets fewer pictures per second
HERE = Path(__file__).parent
PAGES = ("3d", "plain")
MARK = re.compile("__(TITLE|SCRIPT|DATA|BLOB|PROGRAM|START|ABSCISSA|LIVE|WASM)__")
HEIGHT = 560  # of a page in a notebook
Live: TypeAlias = "tuple[JsonObject, str]"


@final
@dataclass(frozen=True, repr=False)
class Page:
    """A page; notebooks show it, ``os.fspath`` gives its file.

    Attributes:
        html: Its text.
        path: Its file, None where it was not written.
    """

    html: str = field(repr=False)
    path: Path | None = None

    def __fspath__(self) -> str:
        return str(self.saved())

    def saved(self) -> Path:
        """Its file; a temporary one where it has none yet."""
        if self.path is None:
            with tempfile.NamedTemporaryFile("w", -1, "utf-8", suffix=".html", delete=False) as to:
                to.write(self.html)
            object.__setattr__(self, "path", Path(to.name))
        assert self.path is not None
        return self.path

    def open(self) -> Page:
        """Open it in a browser; its file is printed where there is none."""
        path = self.saved()
        if not webbrowser.open(path.resolve().as_uri()):
            print(f"no browser was found; the page is {path}", file=sys.stderr)
        return self

    def __repr__(self) -> str:
        return f"Page({str(self.path) if self.path else f'{len(self.html)} characters'})"

    def _repr_html_(self) -> str:
        # the page runs in a frame of its own, without access to the notebook
        return (
            f'<iframe srcdoc="{html.escape(self.html)}" sandbox="allow-scripts allow-downloads" '
            f'title="motion" loading="lazy" style="width:100%;height:{HEIGHT}px;border:0"></iframe>'
        )


@checked
def animate(
    motion: TrajectoryRecord,
    path: str | Path | None = None,
    *,
    show: str | Sequence[str] | None = None,
    plots: str | Sequence[str] | None = None,
    follow: str | None = None,
    traces: str | Sequence[str] = (),
    meshes: str | float | bool = "auto",
    page: str = "3d",
    fps: float = 60.0,
    title: str | None = None,
) -> Page:
    """A self-contained page that plays the motion in any browser.

    Without a path, a notebook shows the page in place; elsewhere it is opened in the browser.

    Args:
        motion: The motion.
        path: HTML file. It appears complete or not at all.
        show: What shows from the start, of ``"reactions"``, ``"forces"``, ``"contacts"``,
            ``"frames"``, ``"springs"``, ``"stress"``, ``"strain"``, ``"displacement"`` and
            ``"floor"``. Reactions are computed only if they are named; the page can hide each.
            Beams and superelements are colored by stress where it is known, of von Mises in
            superelements; ``"strain"`` colors beams, ``"displacement"`` superelements.
        plots: Names of histories below the picture, as ``motion[name]``, and ``"energy"``; by
            default energies, coordinates and outputs.
        follow: Body, superelement or frame that the camera goes with.
        traces: Frames whose paths are drawn.
        meshes: ``"auto"`` reduces meshes to 200,000 triangles, ``"full"`` keeps all, a
            number from 0 to 1 that share of them; False draws links.
        page: ``"3d"``, or ``"plain"``: drawn on a 2-D canvas, for browsers without WebGL.
        fps: Pictures per second of play; long motions get fewer.
        title: Headline, the name of the model by default.

    Returns:
        The page; ``.path`` is its file.

    Raises:
        ModelError: a motion without poses or with places that are not finite, or a file that
            cannot be written. ArgumentError: an unknown layer, body or kind of page.
    """
    return page_of(
        [motion], path, show=show, plots=plots, follow=follow, traces=traces, meshes=meshes,
        page=page, fps=fps, title=title,
    )  # fmt: skip


def page_of(
    motions: Sequence[TrajectoryRecord],
    path: str | Path | None,
    *,
    abscissa: Abscissa | None = None,
    histories: HasHistories | None = None,
    show: str | Sequence[str] | None = None,
    plots: str | Sequence[str] | None = None,
    follow: str | None = None,
    traces: str | Sequence[str] = (),
    meshes: str | float | bool = "auto",
    page: str = "3d",
    fps: float = 60.0,
    title: str | None = None,
) -> Page:
    """The page of :func:`animate`, of rows that may stand for something else than times.

    Args:
        motions: One behind the other, each with its own parameters.
        abscissa: What the rows stand for; times by default, at which a motion is sampled.
        histories: What has the histories by name, if not the motion.
        path, show, plots, follow, traces, meshes, page, fps, title: As :func:`animate`.
    """
    if page not in PAGES:
        raise ArgumentError(f"page='{page}': there is no such page.{near(page, PAGES)}")
    first = motions[0].manifest
    detail = detail_of(meshes)
    if fps <= 0:
        raise ArgumentError(f"fps={fps:g}: give pictures per second, such as 60")
    if "pose" in first.absent:
        raise ModelError(f"a page shows bodies: {first.absent['pose']}; plot() draws coordinates")
    # the plain page begins in real time
    rate = 1.0 if page == "plain" else None
    options = PageOptions(_names(show), _names(plots), follow, _names(traces) or (), fps, rate)
    drawing = drawing_of(motions, options, abscissa, histories)
    return drawing_page(drawing, path, page, detail, first.name if title is None else title)


def drawing_page(
    drawing: Drawing,
    path: str | Path | None,
    page: str = "3d",
    detail: str | float = "auto",
    title: str | None = None,
    live: Live | None = None,
) -> Page:
    """The page of a drawing, written to a file, opened in a browser or shown in a notebook.

    Args:
        drawing: What it shows.
        path, page, title: As :func:`animate`; the name of the drawing is the headline by default.
        detail: As ``meshes=`` there.
        live: Of a model that runs in the page: what it has to know of it, and elements of HTML.
    """
    text = _filled(drawing, page, detail, drawing.name if title is None else title, live)
    if path is not None:
        return Page(text, publish(Path(path), text))
    return Page(text) if "ipykernel" in sys.modules else Page(text).open()


@dataclass(frozen=True)
class PageOptions:
    """Options of a page, as of :func:`animate`."""

    show: Sequence[str] | None = None
    plots: Sequence[str] | None = None
    follow: str | None = None
    traces: Sequence[str] = ()
    fps: float = drawn.FAST
    rate: float | None = None

    @property
    def layers(self) -> Sequence[str]:
        """Layers that show from the start.

        Raises:
            ArgumentError: there is no such layer.
        """
        for name in self.show or ():
            if name not in drawn.LAYERS:
                raise ArgumentError(
                    f"show={name!r}: there is no such layer.{near(name, drawn.LAYERS)}"
                )
        return drawn.USUAL if self.show is None else (*self.show, "springs", "floor")

    @property
    def colored_by(self) -> str | None:
        """``"stress"``, ``"strain"`` or ``"displacement"``, if beams and surfaces are to show it.

        Raises:
            ArgumentError: two are named.
        """
        named = [name for name in ("stress", "strain", "displacement") if name in (self.show or ())]
        if len(named) > 1:
            raise ArgumentError(f"show={self.show!r}: only one of {', '.join(named)} colors things")
        return named[0] if named else None


def _names(names: str | Sequence[str] | None) -> Sequence[str] | None:
    return (names,) if isinstance(names, str) else names


def detail_of(meshes: str | float | bool) -> str | float:
    """Detail of the meshes: ``"auto"``, ``"full"``, a share, or False without meshes.

    Raises:
        ArgumentError: no such detail.
    """
    if meshes is False:
        return False
    if meshes in ("auto", "full") or meshes is True:
        return "auto" if meshes is True else str(meshes)
    if isinstance(meshes, (int, float)) and 0 < meshes <= 1:
        return float(meshes)
    raise ArgumentError(
        f"meshes={meshes!r}: give 'auto', 'full', a share above 0 and up to 1, or False"
    )


def drawing_of(
    motions: Sequence[TrajectoryRecord],
    options: PageOptions,
    abscissa: Abscissa | None = None,
    histories: HasHistories | None = None,
) -> Drawing:
    """The contents of a page; arguments as of :func:`page_of`."""
    motion = motions[0]
    rate = options.rate or (drawn.slowed(motion) if abscissa is None else _sweeping(abscissa))
    rows = motions
    if abscissa is None:
        rows = [_with_energies(_resampled(motion, options.fps / rate), motion)]
    things = drawn.joined([_things(row, options) for row in rows])
    over = abscissa or things.abscissa
    up, heavy = drawn.upward(motion)
    events = [] if abscissa else [(event.t, event.name) for event in motion.events]
    every = max(1, -(-len(events) // drawn.MOST_EVENTS))
    return replace(
        things,
        abscissa=over,
        histories=curves.histories(rows[0], options.plots, histories)
        if len(over.values) > 1
        else [],
        events=events[::every],
        up=up,
        normal=drawn.plane_of(things.bodies, things.beams, things.surfaces),
        floor=drawn.floor_of(motion, up, heavy),
        rate=rate,
        follow=drawn.body_followed(options.follow, things, motion.manifest),
        layers=options.layers,
    )


def _things(motion: TrajectoryRecord, options: PageOptions) -> Drawing:
    """Bodies, beams, surfaces, springs, arrows and traces of one motion."""
    bodies, ground, beams, surfaces = drawn.solids_of(motion, options.colored_by)
    arrows = drawn.reactions(motion) if "reactions" in options.layers else []
    arrows += drawn.acting(motion)
    return Drawing(
        name=motion.manifest.name,
        abscissa=Abscissa(motion.t),
        bodies=bodies,
        ground=ground,
        beams=beams,
        surfaces=surfaces,
        supports=supports(motion, bodies, beams),
        springs=drawn.springs(motion),
        arrows=arrows,
        traces={name: motion.pose(name)[:, :3, 3] for name in options.traces},
    )


def _sweeping(abscissa: Abscissa) -> float:
    """The speed at which the rows pass in six seconds."""
    return float(np.ptp(abscissa.values)) / 6.0 or 1.0


def _filled(
    drawing: Drawing, page: str, detail: str | float, headline: str, live: Live | None
) -> str:
    """The text of a page."""
    unit = drawing.abscissa.unit
    parts = {
        "TITLE": html.escape(_encodable(headline)),
        "ABSCISSA": html.escape("time" if unit == "s" else drawing.abscissa.name),
        "LIVE": live[1] if live else "",
        "WASM": " 'wasm-unsafe-eval'" if live else "",
    }
    try:
        if page == "plain":
            template = "plain.html"
            script = "" if live else text_of("plain.js")
            parts |= {"SCRIPT": script, "DATA": plain_page.data(drawing)}
        else:
            template = "page.html"
            data, block = scene_page.parts(drawing, detail)
            parts |= {"DATA": data, "BLOB": block}
            parts |= {"PROGRAM": _program(), "START": text_of("three/start.js")}
    except CardanError:
        raise
    except ValueError:
        raise ModelError(
            f"a page shows bodies at finite places; some of '{drawing.name}' are not"
        ) from None
    if live:
        more = json.dumps(live[0], separators=(",", ":"), allow_nan=False)
        parts["DATA"] = f'{parts["DATA"][:-1]},"live":{more}}}'
    # names are the user's: nothing in them may end the script or open a tag
    for character in "<>&\u2028\u2029":
        parts["DATA"] = parts["DATA"].replace(character, f"\\u{ord(character):04x}")
    # in one sweep: what is filled in is never searched for marks
    return MARK.sub(lambda mark: parts[mark[1]], text_of(template))


def _encodable(text: str) -> str:
    """A text without the halves of characters that names of files may hold: UTF-8 has none."""
    return text.encode("utf-8", "replace").decode("utf-8")


@cache
def _program() -> str:
    """The script of the 3-D page, deflated."""
    return deflated((HERE / "page.min.js").read_bytes())


def _resampled(motion: TrajectoryRecord, fps: float) -> TrajectoryRecord:
    """The motion at equal times, where it knows what lies between its rows."""
    last = len(motion) - 1
    span = float(motion.t[-1] - motion.t[0])
    count = int(min(PICTURES, max(2.0, abs(span) * fps + 1.5)))
    times = np.linspace(motion.t[0], motion.t[-1], count)
    if frame_history.can_resample(motion):
        return motion.resample(times)
    if motion.dense is None and len(motion) <= PICTURES:
        return motion
    # the rows that are there, of which many may be close to each other
    sign = 1.0 if span >= 0 else -1.0
    return rows_of(motion, np.unique(np.searchsorted(sign * motion.t, sign * times).clip(0, last)))


def _with_energies(resampled: TrajectoryRecord, motion: TrajectoryRecord) -> TrajectoryRecord:
    """The motion of a file at other times, its energies joined by straight lines."""
    if motion.model is None and "kinetic" in motion.stored:
        way = 1.0 if motion.t[-1] >= motion.t[0] else -1.0
        lines = {
            name: np.interp(way * resampled.t, way * motion.t, motion.stored[name])
            for name in ("kinetic", "potential")
        }
        return replace(resampled, stored={**resampled.stored, **lines})
    return resampled


def rows_of(motion: TrajectoryRecord, rows: NDArray[np.intp]) -> TrajectoryRecord:
    """The motion at some of its rows, with what is stored of them."""
    poses = {k: v[rows] for k, v in motion.stored.items() if k.startswith("pose ")}
    constant = {k: v for k, v in motion.stored.items() if k == "parameters"}
    parts = {name: getattr(motion, name)[rows] for name in ("t", "x", "r", "work_done")}
    return replace(motion, **parts, dense=None, stored={**poses, **constant})


def publish(path: Path, page: str) -> Path:
    """Write a page, in a directory that is made if need be.

    Raises:
        ModelError: as :func:`cardan.atomic_file.replaced`.
    """
    folder(path)
    return written(path, page)
