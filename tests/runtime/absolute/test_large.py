"""Beams of many elements: what is told once, planned once, and grows with their number alone."""

from __future__ import annotations

import json
import threading
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import fields
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import cardan as cd
from cardan.codegen.finite_elements import manifest_rows, model_folder
from cardan.errors import ModelError
from cardan.runtime.models.finite_elements.elements import Elements, State
from cardan.runtime.models.finite_elements.mesh import Mesh
from cardan.runtime.sparse import matrices
from cardan.schema.rows import Rows, dumped
from mechanisms.flexible import elastica

DOCS = Path(__file__).parents[3] / "docs"


def mesh_of(model: cd.CompiledModel) -> Mesh:
    found = model._source.results(model).mesh  # type: ignore[attr-defined]
    assert isinstance(found, Mesh)
    return found


@pytest.mark.parametrize("plane", [None, "z"])
def test_many_nodes_have_the_rows_of_few(
    plane: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = elastica(7)
    scene.beam(
        "arc", scene.ground, (0, 2, 0), cd.section.general(EA=1, GA=1, GJ=1, EI=1), elements=5
    )
    equations = cd.derive(scene, "absolute", plane=plane)  # type: ignore[arg-type]
    few = model_folder.base(equations, ()).data
    monkeypatch.setattr(manifest_rows, "LISTED", 0)
    many = model_folder.base(equations, ()).data
    for key in ("coordinates", "speeds", "joints"):
        assert isinstance(many[key], Rows)
        assert list(many[key]) == few[key]
    assert [row["name"] for row in few["coordinates"]] == list(equations.coordinates)
    assert [row["name"] for row in few["speeds"]] == list(equations.speeds)


def test_manifest_and_header_do_not_grow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(manifest_rows, "LISTED", 0)
    sizes = []
    for n in (50, 100):
        model = cd.compile(elastica(n), directory=tmp_path / str(n))
        told = json.loads((tmp_path / str(n) / "manifest.json").read_text("utf-8"))
        kept = [told[key]["listed"] for key in ("coordinates", "speeds", "joints")]
        sizes.append([*map(len, kept), (tmp_path / str(n) / "model.h").read_text().count("\n")])
        assert model.nq == 7 * n
        assert model.coordinates[-7] == f"beam.node{n - 1}.qw"
    assert sizes[0] == sizes[1]
    # they answer as models whose rows are written out
    written = cd.compile(elastica(100), directory=tmp_path / "written")
    q = model.equilibrium().q
    monkeypatch.undo()
    again = cd.compile(elastica(100), directory=tmp_path / "again")
    assert isinstance(written.manifest["joints"], Rows)
    assert isinstance(again.manifest["joints"], list)
    assert np.array_equal(again.equilibrium().q, q)


def test_tables_of_the_plan_grow_as_the_mesh() -> None:
    lengths = []
    for n in (200, 400, 800):
        plan = mesh_of(cd.compile(elastica(n))).plan
        arrays = [getattr(plan, f.name) for f in fields(plan)]
        lengths.append(plan.factors + sum(a.size for a in arrays if isinstance(a, np.ndarray)))
    first, second, third = lengths
    # differences double with the number of elements, but for what ends leave
    assert third - second == pytest.approx(2 * (second - first), rel=0.02)


def test_other_numbers_do_not_plan_again(monkeypatch: pytest.MonkeyPatch) -> None:
    planned, plan = [], matrices.plan

    def counted(*arguments: object) -> object:
        planned.append(1)
        return plan(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(matrices, "plan", counted)
    model = cd.compile(elastica(6))
    tips = [model.with_parameters(P=P).equilibrium()["beam.end.py"] for P in (1.0, 2.0, 3.0)]
    assert len(planned) == 1
    assert tips[0] < tips[1] < tips[2]


def test_threads_connect_functions_once() -> None:
    found, calls = mesh_of(cd.compile(elastica(6))), []
    load, begun = found._load, threading.Barrier(4)

    def counted(symbols: object) -> object:
        calls.append(symbols)
        return load(symbols)  # type: ignore[arg-type]

    found._load = counted  # type: ignore[assignment]

    def connect() -> None:
        begun.wait()
        found.connect("energy", "momentum")

    threads = [threading.Thread(target=connect) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(calls) == 1


@pytest.mark.usefixtures("cache_directory")
@pytest.mark.parametrize("wrong", [False, True])
def test_threads_wait_until_functions_are_judged(wrong: bool) -> None:
    found = mesh_of(cd.compile(elastica(2)))
    begun, end = threading.Event(), threading.Event()

    def judge(elements: Elements, fresh: Sequence[str]) -> None:
        # who judges calls them, and waits for nobody
        elements.total("energy", 2, State(q=np.tile([0.0, 0, 0, 1, 0, 0, 0], 2)))
        begun.set()
        assert end.wait(60)
        if wrong:
            raise cd.BuildError("it is wrong")

    found._judge = judge
    with ThreadPoolExecutor(2) as pool:
        first = pool.submit(found.connect, "energy")
        assert begun.wait(60)
        second = pool.submit(found.connect, "energy")
        early = wait([second], 0.2).done
        end.set()
        errors = [task.exception(60) is not None for task in (first, second)]
    assert not early
    assert errors == [wrong, wrong]


def test_functions_that_cannot_be_published_are_forgotten(
    cache_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    model, kept = cd.compile(elastica(2)), []
    found, keep = mesh_of(model), model._objects.publish

    def full(symbol: str) -> object:
        kept.append(symbol)
        if len(kept) > 1:
            raise cd.BuildError("no space left")
        return keep(symbol)

    with monkeypatch.context() as patch:
        patch.setattr(model._objects, "publish", full)
        with pytest.raises(cd.BuildError, match="no space left"):
            found.connect("energy", "momentum")
    assert list(cache_directory.glob(".new-*")) == []
    found.connect("energy", "momentum")
    assert list(cache_directory.glob(".new-*")) == []


def test_full_matrices_of_many_speeds_are_refused() -> None:
    model = cd.compile(elastica(700))
    with pytest.raises(ModelError, match=r"4200 speeds.*modes"):
        model.linearize()


def test_manifest_with_runs_follows_the_schema(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(manifest_rows, "LISTED", 0)
    data = json.loads(dumped(model_folder.base(cd.derive(elastica(7)), ()).data))
    schema = json.loads((DOCS / "manifest.schema.json").read_text("utf-8"))
    jsonschema.validate(data, schema)
