"""Parts of an ensemble put together: the answers of the whole, to the bit.

Parts come from files that somebody else may have made, or from ensembles of this process. A file is
read twice: once to see that it is whole, and once more to take its blocks, so that nothing it says
about sizes costs memory before the data was seen.
"""

from __future__ import annotations

import glob
import os
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field, replace
from itertools import count, islice, pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ... import regular_file
from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveWarning, brief, counted, warn
from ...records import dataclass
from ...version import ENSEMBLE_FILE, VERSION
from ..simulation.files.append_log import LogReader, unpacked
from .checkpoint import CURES, DAMAGE, block_in, checks_in
from .collection import Gathered
from .energy_check import EnergyCheck, selected, unaccounted
from .job import BlockResult, Job, Sizes
from .request_record import read
from .result import EnsembleRecord, Request, reported
from .share import Share

LARGEST = 1 << 62  # bytes of a file: as it is read block by block
AGAIN = "the same call, with the same part= and checkpoint=, goes on from there"
SUCH = "give a pattern such as 'runs-*.part', or a list of files and ensembles of parts"
NAMED = 8  # parts that a message names
# what all parts have alike: name of a hash -> what it means that it differs
ALIKE = {"cardan": "another version of cardan computed it"} | {
    name: why for name, why in CURES.items() if name != "part"
}


class Place(NamedTuple):
    """The place of a block, and the shapes of the values that each of its runs has."""

    first: int
    last: int
    shapes: tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class Part:
    """A part that may be joined.

    Attributes:
        where: What it is, for messages.
        whose: Hashes of model, build, plan, settings and reductions, by name.
        request, share, sizes: What it answers, which part it is, and how large the answers are.
        block_results: Gives its blocks, each time it is called.
        places: First and last run of every block, and the shapes of reductions of a run.
        checks: Of energy; None where it is not finished.
        source: What the runs of the whole are computed again from.
    """

    where: str
    whose: Mapping[str, object]
    request: Request = field(repr=False)
    share: Share
    sizes: Sizes
    block_results: Callable[[], Iterator[BlockResult]] = field(repr=False)
    places: Sequence[Place] = field(repr=False)
    checks: tuple[EnergyCheck, ...] | None = field(repr=False)
    source: Job | None = field(default=None, repr=False)


@checked
def join(
    parts: str | Path | Sequence[str | Path | EnsembleRecord], *, check: bool = False
) -> EnsembleRecord:
    """One ensemble of all its parts, with the bits of ``model.ensemble`` of all runs at once.

    Args:
        parts: A pattern of the files that ``checkpoint=`` named, such as ``"runs-*.part"``; or a
            list of files and of ensembles that ``part=`` made. Nothing in a file is ever executed.
        check: Raise where a run failed.

    Returns:
        Last states, status and reductions of all runs. ``run(i)`` needs the model, which no file
        holds: it is there where one of the parts is an ensemble of this process.

    Raises:
        ModelError: no such files; a part that is missing, there twice, not finished, damaged or of
            another ensemble. SolveError: a run that failed, with ``check``.
    """
    clock = time.perf_counter()
    # nothing is put together before every run is known to be there once
    chosen = _complete([_part(one) for one in _listed(parts)])
    share = chosen[0].share
    sizes = replace(chosen[0].sizes, runs=share.runs)
    # in the order of the whole, in which sums have its bits
    gathered, checks = Gathered(sizes), list[EnergyCheck]()
    for part in chosen:
        first = part.share.first
        for block_result in part.block_results():
            gathered.add(_shifted(block_result, first))
        checks += [one._replace(run=first + one.run) for one in part.checks or ()]
    # every part looked at its worst runs: those of the whole are among them
    missed = unaccounted(selected(checks))
    gathered.add_messages(missed)
    record = EnsembleRecord.of(
        gathered,
        _request([part.request for part in chosen], share),
        time.perf_counter() - clock,
        f"joined from {counted(share.count, 'part')}",
        gathered.done,
        source=next((part.source for part in chosen if part.source is not None), None),
    )
    for text in gathered.merged_warnings():
        warn(text, SolveWarning)
    return reported(record, missed, check)


def _listed(parts: object) -> list[str | Path | EnsembleRecord]:
    """Files and ensembles.

    Raises:
        ModelError: a pattern that nothing matches. ArgumentError: something else.
    """
    if isinstance(parts, str | Path):
        text = os.fspath(parts)
        if os.path.exists(text):
            return [Path(text)]
        files = sorted(glob.glob(text))
        if not files:
            raise ModelError(f"join: no file is called '{text}' in {Path.cwd()}: {SUCH}")
        return [Path(file) for file in files]
    sources = list(parts) if isinstance(parts, Sequence) else []
    wrong = [one for one in sources if not isinstance(one, str | Path | EnsembleRecord)]
    if wrong or not sources:
        raise ArgumentError(f"join({brief(wrong[0] if wrong else parts)}): {SUCH}")
    return sources


def _part(source: str | Path | EnsembleRecord) -> Part:
    """A part, wherever it comes from."""
    if isinstance(source, EnsembleRecord):
        return _of_ensemble(source)
    return _of_file(Path(source))


def _of_ensemble(ensemble: EnsembleRecord) -> Part:
    results, share = ensemble.part_results, ensemble.request.share
    name = f"ensemble of '{ensemble.request.model}'"
    if results is None or share is None:
        divided = share is not None and not share.undivided
        why = "it comes from a saved file" if divided else "it was made without part="
        raise ModelError(
            f"join: this {name} has no blocks that can be joined: {why}. Join the files that "
            "checkpoint= named, or ensembles that model.ensemble(..., part=(k, n)) gave"
        )
    return Part(
        "an ensemble of this process",
        {"cardan": VERSION, **results.whose},
        ensemble.request,
        share,
        results.sizes,
        lambda: iter(results.block_results),
        [_place(one) for one in results.block_results],
        results.checks,
        results.source,
    )


def _place(block_result: BlockResult) -> Place:
    values = (parts.get("value") for parts in block_result.parts.values())
    shapes = tuple(() if value is None else value.shape[1:] for value in values)
    return Place(block_result.first, block_result.last, shapes)


def _of_file(path: Path) -> Part:
    """The part in a checkpoint.

    Raises:
        ModelError: it is none, damaged, or of another version.
    """
    places, checks = list[Place](), None
    with _reader_of(path) as reader:
        whose = reader.stated()
        stated = next(reader.records(), None) if whose is not None else None
        if whose is None or stated is None:
            raise ModelError(f"join: {path} has no run of an ensemble yet: {AGAIN}")
        with _naming(path):
            request, share, sizes = read(_arrays(stated))
            if whose.get("part") != str(share):
                raise ValueError("it is two parts at once")
        # one record at a time is in memory
        for content in reader.records():
            with _naming(path):
                arrays = _arrays(content)
                if checks is not None:
                    raise ValueError("something stands behind its end")
                if "checks" in arrays:
                    checks = checks_in(arrays, len(share))
                else:
                    places.append(_place(block_in(arrays, sizes)))

    def block_results() -> Iterator[BlockResult]:
        with _reader_of(path) as reader:
            reader.stated()
            next(reader.records(), None)
            # no more than were looked at: others may be there by now
            for place, content in zip(places, reader.records(), strict=False):
                with _naming(path):
                    block_result = block_in(_arrays(content), sizes)
                if _place(block_result) != place:
                    raise ModelError(f"join: {path} changes while it is read: {AGAIN}")
                yield block_result

    return Part(str(path), whose, request, share, sizes, block_results, places, checks)


@contextmanager
def _reader_of(path: Path) -> Iterator[LogReader]:
    """A checkpoint, open for reading.

    Raises:
        ModelError: it is not a file that can be read.
    """
    try:
        file = regular_file.open_regular(path, LARGEST)
    except OSError as error:
        raise ModelError(f"join: parts: {path} cannot be opened: {error.strerror}") from error
    with file:
        yield LogReader(file.fileno(), path, ENSEMBLE_FILE)


@contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Errors of damaged records that name their file."""
    try:
        yield
    except DAMAGE as error:
        raise ModelError(
            f"join: {path} holds a record that is of no ensemble: {error}. Remove it and compute "
            "the part again"
        ) from None


def _arrays(content: bytes) -> dict[str, Array]:
    """The arrays of a record.

    Raises:
        ValueError: they are larger than the record: cardan packs nothing tighter.
    """
    arrays = unpacked(content)
    if sum(array.nbytes for array in arrays.values()) > len(content):
        raise ValueError("it grows when it is read")
    return arrays


def _complete(parts: Sequence[Part]) -> list[Part]:
    """All parts of one ensemble, by their numbers.

    Raises:
        ModelError: they are not.
    """
    ordered = sorted(parts, key=lambda part: part.share.number)
    for one, after in pairwise(ordered):
        _refuse_unequal(ordered[0], after)
        if one.share.number == after.share.number:
            raise ModelError(
                f"join: {one.share} is there twice, {one.where} and {after.where}: leave out one"
            )
    share = ordered[0].share
    _refuse_missing({part.share.number for part in ordered}, share.count, _names(ordered))
    for part in ordered:
        _refuse_unfinished(part)
    if len({place.shapes for part in ordered for place in part.places}) > 1:
        raise ModelError(f"join: {_names(ordered)} have values of several shapes in one reduction")
    ends = [0, *(part.share.last for part in ordered)]
    if [part.share.first for part in ordered] != ends[:-1] or ends[-1] != share.runs:
        raise ModelError(f"join: {_names(ordered)} leave out runs or have them twice")
    return ordered


def _refuse_missing(numbers: set[int], total: int, sources: str) -> None:
    """Refuse fewer parts than there are; a file may speak of any number of them."""
    left = total - len(numbers)
    if left:
        absent = (str(k) for k in count(1) if k not in numbers)
        names = ", ".join(islice(absent, min(left, NAMED))) + ", ..." * (left > NAMED)
        noun, verb, them = ("part", "is", "it") if left == 1 else ("parts", "are", "them")
        raise ModelError(
            f"join: {noun} {names} of {total} {verb} missing from {sources}: compute {them} by "
            f"the same call with part=(k, {total}), --part k/{total}"
        )


def _refuse_unequal(one: Part, other: Part) -> None:
    """Refuse two parts that are not of one ensemble."""
    wrong = [why for name, why in ALIKE.items() if one.whose.get(name) != other.whose.get(name)]
    if (one.share.count, one.share.runs) != (other.share.count, other.share.runs):
        wrong += [f"it is {other.share}, of {counted(other.share.runs, 'run')}"]
    if not wrong and _form(one) != _form(other):
        wrong += ["it has another request"]
    if wrong:
        raise ModelError(
            f"join: {other.where} is not a part of the same ensemble as {one.where} ({one.share} "
            f"of {counted(one.share.runs, 'run')}): {'; '.join(wrong)}"
        )


def _form(part: Part) -> tuple[object, ...]:
    """All of a request that says how answers are put together."""
    request = part.request
    return (
        *(request.model, request.entries, request.counts, request.start, request.end),
        *(request.times.tobytes(), request.names),
        [(name, one.phrase()) for name, one in part.sizes.reductions.items()],
        [(name, values.shape[1:]) for name, values in request.varied.items()],
    )


def _refuse_unfinished(part: Part) -> None:
    """Refuse a part that lacks runs, and one whose blocks do not fit each other."""
    places = sorted(part.places)
    if part.checks is None:
        done = sum(place.last - place.first for place in places)
        raise ModelError(
            f"join: {part.share}, {part.where}, is not finished: {done} of {len(part.share)} runs "
            f"are there; {AGAIN}"
        )
    ends = [0, *(place.last for place in places)]
    if [place.first for place in places] != ends[:-1] or ends[-1] != len(part.share):
        raise ModelError(f"join: {part.where} leaves out runs or has them twice")


def _names(parts: Sequence[Part]) -> str:
    return ", ".join(part.where for part in parts[:NAMED]) + ", ..." * (len(parts) > NAMED)


def _shifted(block_result: BlockResult, first: int) -> BlockResult:
    """A block by the numbers that its runs have in the whole."""
    return replace(
        block_result,
        first=first + block_result.first,
        messages={first + k: text for k, text in block_result.messages.items()},
        warnings={first + k: texts for k, texts in block_result.warnings.items()},
    )


def _request(requests: Sequence[Request], share: Share) -> Request:
    """The request of the whole."""
    varied: dict[str, Array] = {}
    for name in requests[0].varied:
        varied[name] = np.concatenate([request.varied[name] for request in requests])
    return replace(requests[0], varied=varied, share=Share(1, 1, 0, share.runs, share.runs))
