"""Files of parts: what is refused, what goes on, and what forged sizes cost."""

from __future__ import annotations

import errno
import hashlib
import io
import json
import os
import pickle
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.ensembles.test_parts import KEEP, PARTS, RUNS, divided, equal
from cardan import number_file, processes, version
from cardan.analyses.ensembles import joining
from cardan.analyses.simulation.files.append_log import LENGTH

# what is refused


def broken(parts: list[Path], match: str) -> None:
    with pytest.raises(cd.ModelError, match=match):
        cd.Ensemble.join(parts)


def test_missing_and_repeated_parts_are_named(double: cd.CompiledModel, tmp_path: Path) -> None:
    divided(double, tmp_path, RUNS)
    files = [tmp_path / f"runs-{k}.part" for k in range(1, PARTS + 1)]
    broken(files[:2] + files[3:], r"part 3 of 8 is missing from .*: compute it .* part=\(k, 8\)")
    broken(files[2:4] + files[5:], "join: parts 1, 2, 5 of 8 are missing")
    broken([*files, files[4]], r"part 5 of 8 is there twice, .*runs-5\.part and .*runs-5\.part")
    with pytest.raises(cd.ModelError, match=r"no file is called '.*none-\*'"):
        cd.Ensemble.join(str(tmp_path / "none-*"))
    broken([tmp_path / "none"], "parts: .*none cannot be opened: No such file")
    for wrong in ([], 3, [None], [double.ensemble(**RUNS), 5]):
        with pytest.raises(cd.ArgumentError, match=r"a list of files and ensembles|give"):
            cd.Ensemble.join(wrong)  # type: ignore[arg-type]
    with pytest.raises(cd.ModelError, match="made without part="):
        cd.Ensemble.join([double.ensemble(**RUNS)])


OTHERS: dict[str, tuple[dict[str, Any], str]] = {
    "tolerance": ({"rtol": 1e-7}, "another time, method or tolerance"),
    "seed": ({"seed": 6}, "its runs start elsewhere"),
    "reductions": ({"reduce": "max of elbow"}, "it keeps other reductions"),
    "count": ({"runs": 601}, "part 2 of 3, of 601 runs"),
}


@pytest.mark.parametrize("case", OTHERS)
def test_parts_of_other_requests_are_refused(
    case: str, double: cd.CompiledModel, tmp_path: Path
) -> None:
    divided(double, tmp_path, RUNS, 3)
    changed, match = OTHERS[case]
    path = tmp_path / "other.part"
    double.ensemble(**RUNS | changed, part=(2, 3), checkpoint=path)
    files = [tmp_path / "runs-1.part", path, tmp_path / "runs-3.part"]
    broken(files, rf"other\.part is not a part of the same ensemble as .*runs-1.*{match}")
    with pytest.raises(cd.ModelError, match="belongs to another ensemble"):
        double.ensemble(**RUNS, part=(2, 3), checkpoint=path)
    with pytest.raises(cd.ModelError, match="it is another part of the runs"):
        double.ensemble(**RUNS, part=(2, 3), checkpoint=files[0])


def test_parts_of_other_models_builds_and_versions_are_refused(
    double: cd.CompiledModel, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    divided(double, tmp_path, RUNS, 3)
    files = [tmp_path / f"runs-{k}.part" for k in (1, 2, 3)]
    heavy = double.with_parameters({"lower.mass": 3.0})
    heavy.ensemble(**RUNS, part=(1, 3), checkpoint=tmp_path / "heavy.part")
    broken([tmp_path / "heavy.part", *files[1:]], "it was computed with another model")
    good = files[1].read_bytes()
    _, whose, *_ = records(good)
    files[1].write_bytes(good.replace(whose, renamed(whose, "build", "0123-4567")))
    rewritten(files[1])
    broken(files, r"another compiler, processor .*compile with reproducible=True")
    files[1].write_bytes(good.replace(whose, renamed(whose, "cardan", "0.0.1")))
    rewritten(files[1])
    broken(files, "another version of cardan computed it")
    files[1].write_bytes(good.replace(b"cardan ensemble 2", b"cardan ensemble 1", 1))
    broken(files, r"runs-2\.part was written by cardan 0\.1\.0, ensemble checkpoint format 1")


def renamed(whose: bytes, name: str, value: str) -> bytes:
    return json.dumps(json.loads(whose) | {name: value}).encode()


def records(data: bytes) -> list[bytes]:
    """The first line and the records of a file."""
    line, _, left = data.partition(b"\n")
    found = [line]
    while left:
        (length,) = LENGTH.unpack(left[: LENGTH.size])
        start = LENGTH.size + 32
        found.append(left[start : start + length])
        left = left[start + length :]
    return found


def rewritten(path: Path) -> None:
    """Make the length and hash of the first record anew."""
    line, _, left = path.read_bytes().partition(b"\n")
    content = left[LENGTH.size + 32 : left.index(b"}", LENGTH.size + 32) + 1]
    rest = left[LENGTH.size + 32 + len(content) :]
    head = LENGTH.pack(len(content)) + hashlib.sha256(content).digest()
    path.write_bytes(line + b"\n" + head + content + rest)


def test_unfinished_parts_are_named_and_go_on(double: cd.CompiledModel, tmp_path: Path) -> None:
    """Cut anywhere: join says how far it is, the same call goes on, and the bits are the same."""
    whole = double.ensemble(**KEEP)
    divided(double, tmp_path, KEEP, 3)
    files = [tmp_path / f"runs-{k}.part" for k in (1, 2, 3)]
    size = files[1].stat().st_size
    for left in (size - 1, size - 3000, size // 2, 300, 5, 0):
        os.truncate(files[1], left)
        broken(
            files,
            r"part 2 of 3, .*runs-2\.part, is not finished: \d+ of \d+ runs are there; the same"
            if left > 1000
            else r"runs-2\.part has no run of an ensemble yet: the same call",
        )
        double.ensemble(**KEEP, part=(2, 3), checkpoint=files[1])
        assert files[1].stat().st_size == size
        equal(whole, cd.Ensemble.join(files))


KILLED = """
import sys, time, pickle
import cardan as cd
from analyses.ensembles.test_parts import RUNS
from cardan.analyses.ensembles import checkpoint
usual = checkpoint.Checkpoint.add
def slowly(self, piece):
    usual(self, piece)
    print(piece.first, flush=True)
    time.sleep(30)
checkpoint.Checkpoint.add = slowly
with open(sys.argv[1], "rb") as file:
    model = pickle.load(file)
model.ensemble(**RUNS, part=(2, 3), checkpoint=sys.argv[2], threads=1)
"""


def test_a_killed_part_goes_on(double: cd.CompiledModel, tmp_path: Path) -> None:
    (tmp_path / "model").write_bytes(pickle.dumps(double))
    divided(double, tmp_path, RUNS, 3)
    path = tmp_path / "runs-2.part"
    path.unlink()
    tests = str(Path(__file__).parents[2])
    command = [sys.executable, "-c", KILLED, str(tmp_path / "model"), str(path)]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([*sys.path, tests])}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "0\n"
        child.send_signal(signal.SIGKILL)
    pattern = str(tmp_path / "runs-*.part")
    with pytest.raises(cd.ModelError, match=r"part 2 of 3, .*is not finished"):
        cd.Ensemble.join(pattern)
    again = double.ensemble(**RUNS, part=(2, 3), checkpoint=path)
    assert 0 < again.restored < len(again)
    equal(double.ensemble(**RUNS), cd.Ensemble.join(pattern))


def test_interrupted_parts_are_not_joined(double: cd.CompiledModel) -> None:
    sent: list[float] = []

    def tick(done: float) -> None:
        if not sent:
            os.kill(os.getpid(), signal.SIGINT)
        sent.append(done)

    parts = [double.ensemble(**RUNS, part=(1, 2))]
    with pytest.warns(cd.SolveWarning, match="interrupted when"):
        parts += [double.ensemble(**RUNS, part=(2, 2), progress=tick, threads=1)]
    with pytest.raises(cd.ModelError, match="an ensemble of this process, is not finished"):
        cd.Ensemble.join(parts)


@pytest.mark.parametrize("part", [3, "3/8", (0, 8), (9, 8), (1, 0), (1.0, 8), (1, 2, 3), (True, 2)])
def test_what_is_no_part(part: Any, double: cd.CompiledModel) -> None:
    with pytest.raises(cd.ArgumentError, match="part="):
        double.ensemble(**RUNS, part=part)


def test_more_parts_than_blocks_are_refused(double: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match=r"600 runs of 'double' are done in 19 blocks.*\(k, 19"):
        double.ensemble(**RUNS, part=(1, 20))
    assert len(double.ensemble(**RUNS, part=(19, 19))) == 24


def test_disks_without_locks_take_parts(
    double: cd.CompiledModel, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lock(handle: int, wait: bool = True) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(processes, "lock", lock)
    divided(double, tmp_path, RUNS, 2)
    equal(double.ensemble(**RUNS), cd.Ensemble.join(str(tmp_path / "*.part")))
    with pytest.raises(cd.ModelError, match=r"cannot be locked: No locks available.*part=\(1, 1\)"):
        double.ensemble(**RUNS, checkpoint=tmp_path / "runs")
    alone = tmp_path / "alone"
    double.ensemble(**RUNS, checkpoint=alone, part=(1, 1))
    equal(double.ensemble(**RUNS), cd.Ensemble.join(alone))


# damaged and hostile files


def test_sizes_that_a_file_speaks_of_cost_nothing(
    double: cd.CompiledModel, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Forged counts of runs and parts are refused before there is room for them."""
    divided(double, tmp_path, RUNS, 2)
    files = [tmp_path / f"runs-{k}.part" for k in (1, 2)]
    good = files[1].read_bytes()
    _, whose, request, *blocks = records(good)
    arrays = number_file.unpacked(request)
    stated = json.loads(arrays["request"].tobytes())
    rooms: list[Any] = []
    monkeypatch.setattr(joining, "Gathered", rooms.append)
    for share in (
        [2, 2, 300, 2**52, 2**52],
        [2, 2**50, 288, 600, 600],
        [2, 2, 2**51, 2**52, 2**53],
    ):
        forged = stated | {"share": share}
        letters = np.frombuffer(json.dumps(forged).encode(), np.uint8)
        packed = number_file.packed(arrays | {"request": letters})
        head = renamed(whose, "part", f"part {share[0]} of {share[1]}")
        files[1].write_bytes(file_of([head, packed, *blocks]))
        with pytest.raises(cd.ModelError, match="runs-2"):
            cd.Ensemble.join(files)
    # zeros that were packed tightly
    large = number_file.unpacked(blocks[0]) | {"x": np.zeros((32, 4))}
    stream = io.BytesIO()
    np.savez_compressed(stream, **large | {"part 0 extra": np.zeros(1_000_000)})
    files[1].write_bytes(file_of([whose, request, stream.getvalue(), *blocks[1:]]))
    broken(files, r"runs-2\.part holds a record that is of no ensemble: it grows")
    assert not rooms


def file_of(contents: list[bytes]) -> bytes:
    """A file of records with their hashes."""
    data = b"cardan ensemble %d\n" % version.ENSEMBLE_FILE.version
    for one in contents:
        data += LENGTH.pack(len(one)) + hashlib.sha256(one).digest() + one
    return data


def test_blocks_that_are_there_twice_are_refused(double: cd.CompiledModel, tmp_path: Path) -> None:
    divided(double, tmp_path, RUNS, 2)
    files = [tmp_path / f"runs-{k}.part" for k in (1, 2)]
    whose, request, *blocks, end = records(files[1].read_bytes())[1:]
    for order in ([*blocks, blocks[0], end], [*blocks[1:], end]):
        files[1].write_bytes(file_of([whose, request, *order]))
        broken(files, "leaves out runs or has them twice")
    files[1].write_bytes(file_of([whose, request, *blocks[:-1], end, blocks[-1]]))
    broken(files, "something stands behind its end")
    # any order of blocks is fine: threads finish as they like
    files[1].write_bytes(file_of([whose, request, *blocks[::-1], end]))
    equal(double.ensemble(**RUNS), cd.Ensemble.join(files))
