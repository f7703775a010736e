"""Records that C and Python share: the same fields of the same kinds in the same order."""

from __future__ import annotations

import ctypes
import re

import pytest

from cardan.analyses import record
from cardan.analyses.ensembles import lanes
from cardan.runtime.prebuilt import DIRECTORY

WORD = {"ptrdiff_t": record.COUNT, "real": record.REAL, "double": record.REAL}
WORD["cardan_any_function"] = record.POINTER
RECORDS = [
    ("run.h", "cardan_run", record.Run),
    ("run.h", "cardan_signal", record.Signal),
    ("run.h", "cardan_tick", record.Tick),
    ("abreast.h", "cardan_abreast", lanes.Abreast),
    ("ensemble.h", "cardan_own", lanes.Own),
    ("ensemble.h", "cardan_lane", lanes.Lane),
    ("ensemble.h", "cardan_ensemble", lanes.Driver),
]


def fields(header: str, name: str) -> list[tuple[str, object]]:
    """Name and kind of every field of a struct; a ``cardan_call`` is two pointers."""
    text = re.sub(r"/\*.*?\*/", "", (DIRECTORY / header).read_text(), flags=re.DOTALL)
    found = re.search(rf"struct {name} \{{(.*?)\n\}}", text, flags=re.DOTALL)
    assert found is not None
    listed: list[tuple[str, object]] = []
    for statement in found[1].split(";"):
        words = " ".join(statement.split())
        function = re.search(r"\(\*(\w+)\)\(", words)
        if function:
            listed.append((function[1], record.POINTER))
            continue
        declared = re.match(r"(?:(?:const|volatile|struct) )*(\w+) (.+)", words)
        for part in declared[2].split(",") if declared else ():
            own = part.strip().lstrip("*")
            if "*" in part:
                listed.append((own, record.POINTER))
            elif declared[1] == "cardan_call":
                listed += [(own, record.POINTER), (f"{own}_w", record.POINTER)]
            else:
                listed.append((own, WORD[declared[1]]))
    return listed


@pytest.mark.parametrize(("header", "name", "mirror"), RECORDS, ids=[r[1] for r in RECORDS])
def test_records_agree(header: str, name: str, mirror: type[ctypes.Structure]) -> None:
    here = [(field[0], field[1]) for field in mirror._fields_]
    assert here == fields(header, name)


def test_answers_and_kinds_agree() -> None:
    text = re.sub(r"/\*.*?\*/", "", (DIRECTORY / "run.h").read_text(), flags=re.DOTALL)
    numbers = {n: int(v) for n, v in re.findall(r"CARDAN_([A-Z_]+) = (-?\d+)", text)}
    assert numbers.pop("MOST_ROWS") > 0
    assert len(numbers) == 22
    for name, value in numbers.items():
        assert getattr(record, name) == value, name
