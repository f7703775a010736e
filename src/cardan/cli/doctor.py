"""``cardan doctor``: what works on this machine, and what to do about the rest.

Look at everything cardan builds on: compiler, compile cache, versions, processor, extras.

Every line says ok, or what to do about it.

examples:
  cardan doctor                        what works here
  cardan doctor --prune                empty the cache of what was not used for 30 days
  cardan doctor --prune --older 7      ... for a week;  --all: of everything

exit status: 0 all is well, 1 something needs doing.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from pathlib import Path

from ..build import cache_folder, prune
from . import health
from .health import Finding

DAYS = 30.0


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument("--json", action="store_true", help="print JSON for another program")
    cache = parser.add_argument_group("the compile cache")
    cache.add_argument("--prune", action="store_true", help="remove what is old, damaged or left")
    limit = cache.add_mutually_exclusive_group()
    older = f"with --prune: not used for so many days (default {DAYS:g})"
    limit.add_argument("--older", metavar="DAYS", type=_days, help=older)
    limit.add_argument("--all", action="store_true", help="with --prune: everything")


def _days(text: str) -> float:
    value = float(text)
    if not (math.isfinite(value) and value >= 0):
        raise argparse.ArgumentTypeError(f"{text} is not a number of days")
    return value


def run(options: argparse.Namespace) -> int:
    """Print the findings, or prune. Returns the exit status."""
    if options.prune:
        return _prune(options)
    if options.older is not None or options.all:
        print("cardan doctor: --older and --all go with --prune", file=sys.stderr)
        return 2
    findings = health.findings()
    if options.json:
        print(json.dumps([vars(finding) for finding in findings], indent=1))
    else:
        _show(findings)
    return 0 if all(finding.ok for finding in findings) else 1


def _show(findings: list[Finding]) -> None:
    from .terminal import console

    out, width = console(), max(len(finding.name) for finding in findings)
    for finding in findings:
        mark = "ok " if finding.ok else "-> "
        out.print(f"{mark} {finding.name:{width}}  {finding.says}", soft_wrap=True)
        if finding.cure:
            out.print(f"    {'':{width}}  {finding.cure}", soft_wrap=True)


def _prune(options: argparse.Namespace) -> int:
    place: Path = cache_folder.configured()
    reason = cache_folder.refusal(place) if place.exists() else ""
    if reason:
        print(f"cardan doctor: {place} is left alone: {reason}", file=sys.stderr)
        return 1
    days = 0.0 if options.all else DAYS if options.older is None else options.older
    gone = prune.prune(place, days)
    if options.json:
        print(json.dumps({"folder": str(place), **vars(gone)}, indent=1))
        return 0
    print(
        f"removed {gone.objects} objects, {gone.models} models and {gone.leftovers} leftovers of "
        f"{place}: {gone.size / 1e6:.1f} MB"
    )
    return 0
