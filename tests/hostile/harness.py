"""Damaged and forged files, each used in a forked process with limits on time and memory.

A *kind* says how a good file of its kind is used and, where it can, how its content is taken apart
and put together again with every hash in it correct. :func:`campaign` draws mutants by a seed, lets
workers use them and counts the verdicts:

- ``same``: what came out is what the good file gives, to the bit;
- ``refused``: one error of cardan that names the file;
- ``broke``: the file was read, what it led to ended in one error of cardan;
- ``slow``: a forged number that is state makes a long run, which Ctrl-C ends;
- ``other``: other results; allowed for forged files where a number is state (:attr:`Kind.state`);
- everything else fails: ``silent`` (other results elsewhere), ``raw ...`` (an error that is not
  cardan's), ``nameless`` (an error that does not say which file), ``memory``, ``hang``, ``crash``.

At its end a worker uses the good file again, which must give what it gave.
"""

from __future__ import annotations

import gc
import os
import pickle
import random
import resource
import select
import shutil
import signal
import struct
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from cardan.errors import CardanError
from hostile.mutations import SPECIAL, Mutant, mutant, special

CPU = 10.0  # seconds of one use, at most
WALL = 60.0  # seconds after which a use that computes nothing hangs
ROOM = 1 << 30  # bytes that a worker may take beside what it has at its start
BATCH = 250  # mutants of one worker
HARD = 3600  # seconds of computing of one worker, at most
LENGTH = struct.Struct("<I")
FAILED = ("raw", "nameless", "memory", "hang", "crash", "silent")

Parts = dict[str, Any]


class Slow(BaseException):
    """A use took its time, and could be ended."""


def _late(*_: Any) -> None:
    raise Slow


@dataclass(frozen=True)
class Kind:
    """A kind of file.

    Attributes:
        name: Of the kind.
        file: A good one; workers get copies of the folder that it lies in.
        read: Reads the file at a path; errors of cardan in it must name the file.
        use: What a user does with what was read; returns bytes, equal where results are.
        unpack: Content -> parts by name: plain data (as of JSON) or arrays; None where a file has
            no parts.
        pack: The inverse, with all hashes in it made anew.
        state: Whether a place in the parts, such as ``("head", "t")``, holds state: another value
            there may give other results.
        draw: Makes mutants.
    """

    name: str
    file: Path
    read: Callable[[Path], Any]
    use: Callable[[Any], bytes]
    unpack: Callable[[bytes], Parts] | None = None
    pack: Callable[[Parts], bytes] | None = None
    state: Callable[[tuple[Any, ...]], bool] = field(default=lambda place: False)
    draw: Callable[[random.Random, Kind, bytes, int], Mutant] = mutant


@dataclass(frozen=True)
class Tally:
    """Verdicts of a campaign.

    Attributes:
        name, seed: Of the kind and the draw.
        counts: Mutants by verdict.
        failures: What must not be: number of the mutant, how it was made, verdict, details.
    """

    name: str
    seed: int
    counts: Counter[str]
    failures: tuple[str, ...]

    def __str__(self) -> str:
        counts = ", ".join(f"{n} {verdict}" for verdict, n in sorted(self.counts.items()))
        lines = [f"{self.name}: {sum(self.counts.values())} mutants of seed {self.seed}: {counts}"]
        return "\n".join([*lines, *(f"  {line}" for line in self.failures[:20])])


def specials(kind: Kind, folder: Path) -> Tally:
    """Use everything in the place of a file that is not a regular file, each once."""
    return campaign(replace(kind, draw=special), len(SPECIAL), 0, folder)


def campaign(kind: Kind, count: int, seed: int, folder: Path, first: int = 0) -> Tally:
    """Use mutants ``first ... first + count - 1`` of a seed, in workers.

    Args:
        kind: The kind of file.
        count: Mutants.
        seed: Mutant k is drawn by ``random.Random(f"{name} {seed} {k}")``: it can be made alone.
        folder: For copies of the file; on a disk that holds some of them.
    """
    good = kind.use(kind.read(kind.file))
    assert good == kind.use(kind.read(kind.file)), f"{kind.name}: good results differ"
    counts: Counter[str] = Counter()
    failures: list[str] = []
    for number, told, verdict, detail in _verdicts(kind, count, seed, folder, first, good):
        counts[verdict.split()[0]] += 1
        if verdict.split()[0] in FAILED:
            failures.append(f"mutant {number} ({told}): {verdict}: {detail}")
    assert sum(counts.values()) == count
    return Tally(kind.name, seed, counts, tuple(failures))


def _verdicts(
    kind: Kind, count: int, seed: int, folder: Path, first: int, good: bytes
) -> Iterator[tuple[int, str, str, str]]:
    """Number, description, verdict and detail of every mutant."""
    done, end = first, first + count
    while done < end:
        last = min(done + BATCH, end)
        for number, told, verdict, detail in _worker(kind, range(done, last), seed, folder, good):
            done = number + 1
            yield number, told, verdict, detail


def _worker(
    kind: Kind, numbers: range, seed: int, folder: Path, good: bytes
) -> Iterator[tuple[int, str, str, str]]:
    """Verdicts of one forked worker; the mutant that ends it is the last of them."""
    reading, writing = os.pipe()
    gc.collect()
    worker = os.fork()
    if worker == 0:
        os.close(reading)
        # what a worker raises must not run the parent's tests again
        code = 1
        try:
            _work(kind, numbers, seed, folder, good, writing)
            code = 0
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(code)
    os.close(writing)
    told: tuple[int, str] | None = None
    status = 0
    try:
        with open(reading, "rb", buffering=0) as stream:
            while (message := _received(stream, worker)) is not None:
                step, *content = message
                if step == "use":
                    told = (content[0], content[1])
                elif step == "verdict" and told is not None:
                    yield (*told, *content)
                    told = None
    finally:
        _, status = os.waitpid(worker, 0)
    if told is not None:
        ended = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
        hung = ended in (signal.SIGXCPU, signal.SIGKILL)
        name = signal.Signals(ended).name if ended else f"exit {os.WEXITSTATUS(status)}"
        yield (*told, "hang" if hung else "crash", name)
    else:
        assert status == 0, f"{kind.name}: a worker ended after mutants {numbers}: {status}"


def _send(writing: int, message: Any) -> None:
    content = pickle.dumps(message)
    content = LENGTH.pack(len(content)) + content
    while content:
        content = content[os.write(writing, content) :]


def _received(stream: Any, worker: int) -> Any:
    """The next message; None when the worker has ended, or hung and was killed."""
    content, wanted = b"", LENGTH.size
    while len(content) < wanted:
        if not select.select([stream], [], [], WALL)[0]:
            os.kill(worker, signal.SIGKILL)
            return None
        some = stream.read(wanted - len(content))
        if not some:
            return None
        content += some
        if wanted == LENGTH.size == len(content):
            wanted += LENGTH.unpack(content)[0]
    return pickle.loads(content[LENGTH.size :])


def _work(kind: Kind, numbers: range, seed: int, folder: Path, good: bytes, writing: int) -> None:
    """Use mutants in this process, which must not return to its caller."""
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    # where C does not let itself be interrupted this is never called, and the hard limit kills
    signal.signal(signal.SIGXCPU, _late)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (_taken() + ROOM,) * 2)
    own = folder / f"worker{os.getpid()}"
    content = kind.file.read_bytes()
    for number in numbers:
        drawn = random.Random(f"{kind.name} {seed} {number}")
        shutil.copytree(kind.file.parent, own, symlinks=True)
        try:
            path = own / kind.file.name
            made = kind.draw(drawn, kind, content, number)
            _send(writing, ("use", number, made.told))
            made.put(path)
            _limit()
            _send(writing, ("verdict", *_verdict(kind, made, path, good)))
        finally:
            shutil.rmtree(own, ignore_errors=True)
    _limit()
    assert kind.use(kind.read(kind.file)) == good, "harm to the good file"


def _taken() -> int:
    """Bytes of addresses that this process has."""
    return int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()


def _limit() -> None:
    """From now on, so many seconds of computing."""
    spent = time.process_time()
    resource.setrlimit(resource.RLIMIT_CPU, (int(spent + CPU) + 1, HARD))


def _verdict(kind: Kind, made: Mutant, path: Path, good: bytes) -> tuple[str, str]:
    """Verdict and detail of one use."""
    opened = False
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            content = kind.read(path)
            opened = True
            result = kind.use(content)
    except CardanError as error:
        if opened:
            return "broke", ""
        named = path.name in str(error) or path.parent.name in str(error)
        return ("refused", "") if named else ("nameless", f"{type(error).__name__}: {error}")
    except Slow:
        state = made.forged and any(kind.state(place) for place in made.places)
        return ("slow", "") if state else ("hang", traceback.format_exc(limit=-3))
    except MemoryError:
        return "memory", traceback.format_exc(limit=-3)
    except Exception as error:
        return f"raw {type(error).__name__}", traceback.format_exc(limit=-3)
    if result == good:
        return "same", ""
    if made.forged and any(kind.state(place) for place in made.places):
        return "other", ""
    return "silent other numbers", made.told
