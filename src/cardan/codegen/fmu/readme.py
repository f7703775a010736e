"""``documentation/index.html`` of an FMU: what an importer should know."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ...schema.integrators import KERNELS
from ...schema.manifest import Manifest
from .description import FmuContent
from .request import KINDS, FmuRequest
from .variables import KINDS as TABLE
from .variables import of_kind

LOOPS = (
    "Loops are closed by constraints. Continuous states are all coordinates and speeds of the "
    "spanning tree, more than there are degrees of freedom. Start values that an importer sets are "
    "guesses: loops are closed next to them at the end of the initialization. In model exchange "
    "the derivatives obey the constraints, and where the importer's integrator drifts off by more "
    "than the tolerance, CompletedIntegratorStep asks for an event at which the state is projected "
    "onto the loops (valuesOfContinuousStatesChanged)."
)
QUATERNIONS = (
    "Rotations are unit quaternions, scalar first, body to parent. In model exchange they may "
    "drift: their direction alone counts, and beyond the tolerance an event normalizes them."
)
EVENTS = (
    "Events: in model exchange state events are the signs of the event.* variables, samples and "
    "jumps in time are time events (nextEventTime); in co-simulation they happen within steps, at "
    "their own times."
)
ELEMENTS = (
    "The model consists of finite elements: co-simulation only. Its parameters are fixed: they are "
    "set before the end of the initialization. There are no directional derivatives."
)
INPUTS = (
    "Inputs are constant over a communication step, unless their derivatives are given "
    "(FMI 2.0, fmi2SetRealInputDerivatives, up to the third)."
)


def page(manifest: Manifest, request: FmuRequest, d: FmuContent, checked: str) -> str:
    """The page.

    Args:
        manifest: Of the model.
        request: What was asked for.
        d: Its description.
        checked: Which binaries were run, and which were not.
    """
    method = KERNELS[request.integrators[0]]
    facts = [
        f"FMI {request.version.name}: {' and '.join(KINDS[kind] for kind in d.kinds)}.",
        f"Co-simulation integrates with {method.name} ({method.source})."
        if "cs" in d.kinds
        else "",
        "The tolerance of the importer is the relative one of a step; the absolute one is a "
        "thousandth of it, at most 1e-9.",
        checked,
        LOOPS if manifest.multipliers and manifest.projected and not manifest.absolute else "",
        QUATERNIONS if manifest.quaternions and not manifest.absolute else "",
        EVENTS if manifest.events else "",
        INPUTS if manifest.inputs else "",
        ELEMENTS if manifest.absolute else "",
        "SI units, radians; degrees where they are shown.",
    ]
    rows = [(kind.name, of_kind(d.variables, kind.name)) for kind in TABLE]
    cells = "".join(
        f"<tr><td>{kind}</td><td>{len(listed)}</td><td>{_first([v.name for v in listed])}</td></tr>"
        for kind, listed in rows
        if listed
    )
    paragraphs = "".join(f"<p>{escape(text)}</p>\n" for text in facts if text)
    title = escape(manifest.name)
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>{title}</title></head><body>\n<h1>{title}</h1>\n"
        f"<p>A multibody model, written by cardan.</p>\n{paragraphs}"
        "<table><tr><th>variables</th><th>how many</th><th>names</th></tr>"
        f"{cells}</table>\n"
        "<p>Compile only what you trust: C runs with all your rights.</p>\n</body></html>\n"
    )


def _first(names: Sequence[str]) -> str:
    """The first names of many."""
    more = f" and {len(names) - 8} more" if len(names) > 8 else ""
    return escape(", ".join(names[:8]) + more)
