"""Records that C and Python share: read from the headers, held against what compilers make."""

from __future__ import annotations

import ctypes
import shutil
from pathlib import Path

import pytest

from cardan.analyses.simulation import run_record
from cardan.errors import BuildError
from cardan.runtime.build import cache, kernels
from cardan.schema import kernel_files, product_records, records, short_run_records
from table import each

ANSWERS = (
    *("DONE", "MORE", "FULL", "STOPPED", "EVENT", "NOT_FINITE", "TOO_SMALL", "MODEL", "INPUT"),
    *("SIZE", "CONSTRAINT_OPEN", "ROTATION_TOO_LARGE", "UNSOLVED", "EVENT_LIMIT", "CHATTER"),
    "ROTATION_UNRESOLVED",
    *("MODE", "IMPACT", "TICK", "END", "MARK", "HALT"),
)
STRUCTURES: dict[str, type[ctypes.Structure]] = {
    "cardan_run": records.Run,
    "cardan_method": records.Method,
    "cardan_signal": records.Signal,
    "cardan_tick": records.Tick,
    "cardan_short_runs": short_run_records.ShortRuns,
    "cardan_account": short_run_records.Account,
    "cardan_steps": records.Steps,
    "cardan_adjoint": records.Adjoint,
    "cardan_tangent": records.Tangent,
    "cardan_input_function": records.InputFunction,
    "cardan_input_functions": records.InputFunctions,
    "cardan_run_pointer": records.RunPointer,
    "cardan_lane": records.Lane,
    "cardan_ensemble": records.Driver,
    "cardan_form": records.Form,
    "cardan_group": records.Group,
    "cardan_movers": records.Movers,
    "cardan_mesh": records.MeshRecord,
    "cardan_state": records.StateRecord,
    "cardan_data_slopes": product_records.DataSlopes,
    "cardan_summands": product_records.SummandRecord,
    "cardan_frame": product_records.FrameRecord,
    "cardan_mesh_product": product_records.ProductRecord,
    "cardan_sparse": records.PlanRecord,
    "cardan_sparse_factors": records.FactorsRecord,
    "cardan_target": records.TargetRecord,
    "cardan_position": records.PositionRecord,
    "cardan_solid": records.SolidRecord,
    "cardan_wasm_function": records.WasmFunction,
}


def test_layouts_are_those_of_the_headers() -> None:
    """kernels/layouts.c is what the headers say; write it anew with ``records.layouts()``."""
    assert kernel_files.text("layouts.c") == records.layouts()


def test_every_record_is_known() -> None:
    assert set(STRUCTURES) == set(records.RECORDS)


@each("name", STRUCTURES)
def test_fields_begin_where_c_has_them(name: str) -> None:
    records.check(kernels.library(), name, STRUCTURES[name])


def test_fields_of_lanes_begin_where_c_has_them() -> None:
    width = cache.compiler().level.lanes
    if width == 1:
        pytest.skip("no vectors here")
    library = kernels.library(lanes=width)
    records.check(library, "cardan_simd", records.SimdSteps)
    records.check(library, "cardan_lane_method", records.LaneMethod)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("real period, phase;", "real phase, period;"), "its field 'period' begins at 16 bytes"),
        (("ptrdiff_t count;", "int count[3];"), "it is as long as 48 bytes"),
    ],
)
def test_records_of_another_version_are_refused(
    tmp_path: Path, change: tuple[str, str], says: str
) -> None:
    """A library whose header differs by the order or by the kind of a field."""
    for path in kernel_files.files("*.h"):
        shutil.copy(path, tmp_path)
    text = (tmp_path / "run.h").read_text("utf-8")
    assert change[0] in text
    (tmp_path / "run.h").write_text(text.replace(*change), "utf-8")
    source = tmp_path / "tick.c"
    shutil.copy(kernel_files.file("layouts.c"), source)
    library = cache.build([source], [tmp_path]).load()
    with pytest.raises(BuildError, match=f"record cardan_tick: {says}.*install cardan again"):
        records.check(library, "cardan_tick", records.Tick)


def test_answers_and_kinds_agree() -> None:
    """What Python calls the answers of kernels and the kinds of events."""
    numbers = {n: v for n, v in records.constants("run.h").items() if n.isupper()}
    assert numbers.pop("CARDAN_MOST_ROWS") > 0
    assert set(numbers) == {f"CARDAN_{name}" for name in ANSWERS}
    for name, value in numbers.items():
        assert getattr(run_record, name.removeprefix("CARDAN_")) == value, name
