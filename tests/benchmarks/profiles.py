"""Where the time of the commonest calls goes, and the least that it could be.

Every piece of work runs in a process of its own. What is mostly Python (the import, loading,
deriving, compiling) is split with cProfile by the packages and by the rooms of cardan, built-in
functions with whoever calls them; what is mostly C, with ``perf`` where it is installed, by the
libraries that the processor was in. Writes docs/performance/profiles.md and prints its tables.

usage: profiles.py [--quick]
"""

from __future__ import annotations

import argparse
import cProfile
import json
import os
import pstats
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

# the zoo stands in the folder above
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.profile_works import WORK

PAGE = Path(__file__).resolve().parents[2] / "docs" / "performance" / "profiles.md"
SECONDS, ROUNDS = 2.0, 7
LISTED = 6
MOST = 3.0  # times of the floor that a call may take
SEEN = 0.015
HEADINGS = ("call", "least", "median", "floor", "to the floor", "where the time goes")
Share = list[tuple[str, float]]
TEXT = """# Where the time goes

The ten commonest calls, each in a process of its own: the least of several rounds, what it is made
of, and the least that it could be (its floor). It should take no more than {most:.0f} times that.
Written by `tests/benchmarks/profiles.py`.
"""


def by_room(profile: cProfile.Profile) -> Share:
    """Seconds by package, those of cardan by room, built-in functions with whoever calls them."""
    seconds: Counter[str] = Counter()
    for (file, _, name), entry in pstats.Stats(profile).stats.items():  # type: ignore[attr-defined]
        own, callers = entry[2], entry[4]
        if file != "~":
            seconds[place(file)] += own
        elif "wait" in name or "poll" in name:
            seconds["the compiler of C"] += own
        elif not callers:
            seconds["Python"] += own
        else:
            for (caller, _, _), part in callers.items():
                seconds[place(caller)] += part[2]
    return shares(seconds)


def place(file: str) -> str:
    """Package of a source file; with the room, where it is cardan's."""
    parts = Path(file).parts
    for package in ("cardan", "numpy", "scipy", "sympy", "ruamel", "Cython"):
        if package in parts:
            after = parts[len(parts) - 1 - parts[::-1].index(package) + 1 :]
            return f"cardan.{Path(after[0]).stem}" if package == "cardan" and after else package
    return "Python"


def shares(seconds: Counter[str]) -> Share:
    """Parts of the sum, the largest first."""
    total = sum(seconds.values()) or 1.0
    return [(name, part / total) for name, part in seconds.most_common(LISTED)]


def by_library(recorded: Path, cache: Path) -> Share:
    """Parts of the time by the library that the processor was in, as perf recorded it."""
    command = ["perf", "report", "-i", str(recorded), "--sort", "dso", "--stdio", "-t", ","]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    seconds: Counter[str] = Counter()
    for line in done.stdout.splitlines():
        part, _, library = line.strip().partition(",")
        if part.strip().endswith("%") or part.strip().replace(".", "").isdigit():
            seconds[library_name(library.strip(), cache)] += float(part.strip().rstrip("%"))
    return shares(seconds)


def library_name(library: str, cache: Path) -> str:
    """What a library is to a reader."""
    if library.startswith("["):
        return "the operating system"
    for start, name in (("libpython", "Python"), ("python", "Python"), ("_abi", "the wrapper")):
        if library.startswith(start):
            return name
    if library.startswith("_multiarray") or "openblas" in library:
        return "NumPy"
    if library.startswith(("libc.", "libc-", "libm.", "libm-")):
        return "the C library"
    for folder in (cache, *kernel_folders()):
        file = folder / library
        if file.exists():
            names = subprocess.run(
                ["nm", "-D", "--defined-only", str(file)], capture_output=True, text=True
            ).stdout
            return "cardan's kernels" if " T cardan_" in names else "generated C"
    return library


def kernel_folders() -> tuple[Path, ...]:
    """Where kernels that came compiled stand."""
    import cardan

    return (Path(cardan.__file__).parent / "kernels" / "built",)


def timed(name: str, rounds: int) -> dict[str, Any]:
    """In this process: times of a call and its floor [s]."""
    call, floor = WORK[name].prepare()
    times: list[float] = []
    end = time.perf_counter() + (SECONDS if rounds > 1 else 0.0)
    while len(times) < rounds or time.perf_counter() < end:
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return {"times": times, "floor": floor}


def split(name: str) -> dict[str, Any]:
    """In this process: where the time of a call goes."""
    work = WORK[name]
    call, _ = work.prepare()
    if not work.compiled:
        profile = cProfile.Profile()
        if not work.once:
            call()
        profile.runcall(call)
        return {"parts": by_room(profile)}
    call()
    return {"parts": sampled(call) if shutil.which("perf") else []}


def sampled(call: Callable[[], object]) -> Share:
    """What perf sees while a call is made again and again."""
    from cardan.runtime.build import cache_folder

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "perf.data"
        command = ["perf", "record", "-e", "cpu-clock", "-F", "1999", "-o", str(file)]
        quiet = subprocess.DEVNULL
        watcher = subprocess.Popen([*command, "-p", str(os.getpid())], stdout=quiet, stderr=quiet)
        end = time.perf_counter() + SECONDS
        while time.perf_counter() < end:
            call()
        watcher.send_signal(signal.SIGINT)
        watcher.wait()
        return by_library(file, cache_folder.directory())


def child(*arguments: str) -> dict[str, Any]:
    """What a process of its own found."""
    command = [sys.executable, __file__, *arguments]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


def measured(name: str) -> tuple[str, ...]:
    """A row of the table: work, least, median, floor, that by the floor, where the time goes."""
    work = WORK[name]
    if work.once:
        rounds = [child("--time", name, "--rounds", "1") for _ in range(ROUNDS)]
        times = sorted(round_["times"][0] for round_ in rounds)
        floor = min(round_["floor"] for round_ in rounds)
    else:
        found = child("--time", name, "--rounds", str(ROUNDS))
        times, floor = sorted(found["times"]), found["floor"]
    parts: Share = child("--split", name)["parts"]
    best = times[0]
    if work.parts:
        floor = best * sum(part for room, part in parts if room in work.parts)
    return (
        work.title,
        length(best),
        length(times[len(times) // 2]),
        f"{length(floor)}: {work.floor}",
        # a floor is measured by itself and may come out a little slower than what contains it
        f"{max(best / floor, 1.0):.1f}" if floor > 0 else "",
        ", ".join(f"{room} {100 * part:.0f} %" for room, part in parts if part > SEEN)
        or "perf is not installed",
    )


def figures(rows: Sequence[Sequence[str]]) -> Iterator[tuple[str, str, str, str]]:
    """Figures to reach, for the table of all."""
    for name, *_, times, _ in rows:
        if times:
            verdict = "yes" if float(times) <= MOST else "no"
            yield f"{name}, by its floor", f"≤ {MOST:.0f}", times, verdict


def length(seconds: float) -> str:
    """A time as people read it."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{1e9 * seconds:.3g} ns"


def main() -> None:
    """Measure, print, write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two calls, no page")
    parser.add_argument("--time", choices=WORK, help=argparse.SUPPRESS)
    parser.add_argument("--split", choices=WORK, help=argparse.SUPPRESS)
    parser.add_argument("--rounds", type=int, default=ROUNDS, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.time:
        print(json.dumps(timed(options.time, options.rounds)))
        return
    if options.split:
        print(json.dumps(split(options.split)))
        return
    from benchmarks.all_figures import save
    from benchmarks.page import markdown
    from benchmarks.provenance import signed

    rows = [measured(name) for name in (["call", "tree"] if options.quick else WORK)]
    table = "\n".join(markdown(HEADINGS, rows, 1))
    print(table)
    save("profiles.md", figures(rows))
    if not options.quick:
        PAGE.write_text(signed(f"{TEXT.format(most=MOST)}\n{table}\n"), "utf-8")


if __name__ == "__main__":
    main()
