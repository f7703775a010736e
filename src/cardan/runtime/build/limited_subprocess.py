"""Run a program that must neither outlive this process nor take the machine with it."""

from __future__ import annotations

import os
import signal
import subprocess
import threading
from collections.abc import Collection, Mapping, Sequence

from ... import processes
from ...errors import BuildError
from ...records import dataclass

# The shell keeps the program and a watcher in one process group. The watcher reads a pipe that
# nobody writes to: it ends with the process that started all this, however that ends, and takes
# the group with it.
SHELL = "/bin/sh"
SCRIPT = """\
ulimit -v "$1" 2>/dev/null; ulimit -t "$2" 2>/dev/null; shift 2
exec 3<&0
"$@" </dev/null 3<&- &
program=$!
(read -r _; kill -KILL 0) <&3 >/dev/null 2>&1 &
watcher=$!
exec 3<&-
wait "$program"; status=$?
kill -KILL "$watcher"
exit "$status"
"""
# our ends of those pipes, and the thread that waits
LIFELINES: dict[int, int] = {}


@dataclass(frozen=True)
class Limits:
    """Time and memory that a compiler may take.

    Attributes:
        seconds: Time, on the clock and of the processor [s].
        memory: Address space of each of its processes [MiB].
    """

    seconds: int = 600
    memory: int = 8192

    @classmethod
    def of_environment(cls) -> Limits:
        """Limits from ``CARDAN_COMPILE_SECONDS`` and ``CARDAN_COMPILE_MEMORY`` [MiB].

        Raises:
            BuildError: one is not a positive whole number.
        """
        limits = {}
        for name in ("seconds", "memory"):
            variable = f"CARDAN_COMPILE_{name.upper()}"
            text = os.environ.get(variable, "").strip()
            if text and not (text.isascii() and text.isdigit() and 0 < int(text) < 10**9):
                raise BuildError(f"{variable}={text!r} must be a positive whole number")
            if text:
                limits[name] = int(text)
        return cls(**limits)


@dataclass(frozen=True)
class Answer:
    """End of a program: its status, its output, and a flag for a timeout."""

    status: int
    output: str
    errors: str
    late: bool = False


def stop(threads: Collection[int] | None = None) -> None:
    """End what some threads wait for; by default let go of everything."""
    for end, thread in list(LIFELINES.items()):
        if threads is None or thread in threads:
            _let_go(end)


def _let_go(end: int) -> None:
    # whoever takes it out closes it
    if LIFELINES.pop(end, None) is not None:
        os.close(end)


# a forked child must not keep the compilers of its parent alive
processes.after_fork(stop)


def run(command: Sequence[str], limits: Limits, environment: Mapping[str, str]) -> Answer:
    """Run a program to its end, its limits, or the end of this process.

    Without that shell (Windows) the limit of time holds alone, and the program may outlive this
    process where that is killed.

    Raises:
        OSError: it cannot be started. KeyboardInterrupt: nothing of it runs any more.
    """
    if not os.path.exists(SHELL):
        return _without_shell(command, limits, environment)
    line = [SHELL, "-c", SCRIPT, "cardan", str(limits.memory * 1024), str(limits.seconds)]
    ours, theirs = os.pipe()
    LIFELINES[theirs] = threading.get_ident()
    try:
        # an own group: Ctrl-C reaches us, and we stop it as a whole
        process = subprocess.Popen(
            [*line, *command],
            stdin=ours,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=dict(environment),
            process_group=0,
            text=True,
            errors="replace",
        )
        try:
            output, errors = process.communicate(timeout=limits.seconds)
            return Answer(process.returncode, output, errors)
        except subprocess.TimeoutExpired:
            return Answer(-signal.SIGKILL, "", "", late=True)
        finally:
            _end(process)
    finally:
        os.close(ours)
        _let_go(theirs)


def _without_shell(
    command: Sequence[str], limits: Limits, environment: Mapping[str, str]
) -> Answer:
    """Run a program to its end or its limit of time."""
    try:
        done = subprocess.run(
            command,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            env=dict(environment),
            timeout=limits.seconds,
            text=True,
            errors="replace",
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Answer(-1, "", "", late=True)
    return Answer(done.returncode, done.stdout, done.stderr)


def _end(process: subprocess.Popen[str]) -> None:
    """Nothing of the group goes on."""
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
