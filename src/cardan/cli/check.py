"""``cardan check``: everything about a scene that is wrong, or will not act as one may think.

Complain about a scene, each complaint with its cure.

An error says why the scene cannot be used, with line and column where a file has them, or that it
describes nothing real, such as an impossible inertia. A warning names what is there and does not
act, or what cannot be computed. A note says what was changed on the way, such as 1.5708 that became
pi/2.

examples:
  cardan check pendulum.yaml
        complaints, the worst first
  cardan check arm.urdf --json
        a list of {"file": "arm.urdf", "level": "error" | "warning" | "note", "says": "..."}

exit status: 0 no errors, 1 errors.
"""

from __future__ import annotations

import argparse
import json
import sys
import warnings
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import CardanError, DerivationError, ImpossibleWarning, ModelWarning, SolveWarning
from ..records import dataclass
from .options import scene as scene_options
from .options.spelling import spelled

if TYPE_CHECKING:
    from ..api.equations import Equations, FiniteElementEquations


LEVELS = ("error", "warning", "note")


@dataclass(frozen=True)
class Complaint:
    """Something a user should know: its level, and what it is with what to do about it."""

    level: str
    says: str


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    scene_options.arguments(parser)
    parser.add_argument("--json", action="store_true", help="print JSON for another program")


def run(options: argparse.Namespace) -> int:
    """Print the complaints. Returns the exit status."""
    problems = [
        Complaint(complaint.level, spelled(complaint.says, options))
        for complaint in complaints(options)
    ]
    if options.json:
        rows = [{"file": str(options.file), **asdict(complaint)} for complaint in problems]
        print(json.dumps(rows, indent=1))
    else:
        for complaint in problems:
            # what was found in the text says file and line itself
            named = Path(options.file).name in complaint.says
            where = "" if named else f"{options.file}: "
            print(f"{where}{complaint.level}: {complaint.says}")
        counts = [(sum(c.level == level for c in problems), level) for level in LEVELS]
        totals = ", ".join(f"{n} {level}{'s' * (n != 1)}" for n, level in counts)
        print(f"{options.file}: {totals}", file=sys.stderr)
    return 1 if any(complaint.level == "error" for complaint in problems) else 0


def complaints(options: argparse.Namespace) -> list[Complaint]:
    """Complaints about a scene, the worst first."""
    from ..api.equations import FiniteElementEquations
    from ..pipeline import derive

    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            equations = derive(scene_options.load(options))
        except (CardanError, OSError) as problem:
            return [Complaint("error", str(problem)), *_doubts(said, ())]
    notes = equations.system.notes
    problems = [*_doubts(said, notes), *(Complaint("warning", note) for note in notes)]
    snaps = [Complaint("note", str(snap)) for snap in equations.system.snaps]
    if isinstance(equations, FiniteElementEquations):
        return problems + _started(equations) + snaps
    try:
        # constraints that cannot be derived are no matter of massless bodies: nothing runs
        if equations.constraint_rows:
            equations.function("constraint_jacobian")
    except DerivationError as problem:
        return [Complaint("error", str(problem)), *problems]
    try:
        equations.function("forward_dynamics")
    except DerivationError as problem:
        problems.append(Complaint("warning", f"no forward dynamics: {problem}"))
    else:
        problems += _open_circuits(equations) or _tried(equations)
    return problems + snaps


def _doubts(said: Iterable[warnings.WarningMessage], notes: Iterable[str]) -> list[Complaint]:
    """Warnings of reading a scene that no note repeats, what cannot be first."""
    texts = {str(w.message): w.category for w in said if issubclass(w.category, ModelWarning)}
    new = {text: kind for text, kind in texts.items() if not any(note in text for note in notes)}
    wrong = [text for text, kind in new.items() if issubclass(kind, ImpossibleWarning)]
    warnings_left = [Complaint("warning", text) for text in new if text not in wrong]
    return [*(Complaint("error", text) for text in wrong), *warnings_left]


def _started(equations: FiniteElementEquations) -> list[Complaint]:
    """Try to start a scene in finite-element coordinates from its reference configuration."""
    from ..pipeline import compile
    from ..runtime.models.initial import start_of

    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            model = compile(equations)
            x, _ = start_of(model, {}, {})
            model.forward_dynamics(x[: model.nq], x[model.nq : model.nq + model.nu])
        except CardanError as problem:
            return [Complaint("warning", f"no forward dynamics: {problem}")]
    messages = dict.fromkeys(str(w.message) for w in said if w.category is SolveWarning)
    return [Complaint("warning", message) for message in messages]


def _open_circuits(equations: Equations) -> list[Complaint]:
    """Loops that do not close, found before code is written."""
    if not equations.system.closed:
        return []
    feasibility = equations.feasibility()
    return [] if feasibility.closes else [Complaint("error", str(feasibility))]


def _tried(equations: Equations) -> list[Complaint]:
    """Check the compiled functions at random states for faults that only numbers show."""
    from ..pipeline import compile

    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            model = compile(equations, functions=("forward_dynamics",))
            model.prepare("forward_dynamics")
            model.verify()
        except CardanError as problem:
            return [Complaint("error", str(problem))]
    messages = dict.fromkeys(str(w.message) for w in said if w.category is SolveWarning)
    return [Complaint("warning", message) for message in messages]
