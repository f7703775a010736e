"""Model directories: whole files, several writers, nothing of others touched."""

import hashlib
import json
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest

import cardan as cd
from cardan.codegen import generate, layout, manifest
from cardan.codegen.finite_elements import model_folder
from cardan.equations.record import EquationRecord
from cardan.errors import CodegenError
from codegen.models import arm

NAMES = ("mass_matrix", "bias", "gravity", "qdot", "energy", "com")


def start(folder: Path) -> EquationRecord:
    equations = cd.derive(arm())
    layout.write_model(folder, manifest.base(equations, NAMES))
    return equations


def add(job: tuple[Path, str]) -> None:
    folder, name = job
    equations = start(folder)
    function = equations.function(name)
    layout.add_functions(folder, [(generate(function), function)])


def check_whole(folder: Path) -> dict:
    """Every file is there and is what the manifest speaks of; nothing else lies around."""
    data = json.loads((folder / "manifest.json").read_text("utf-8"))
    for name, stated in data["sha256"].items():
        assert hashlib.sha256((folder / name).read_bytes()).hexdigest() == stated, name
    files = {path.name for path in folder.iterdir()}
    assert files == {"manifest.json", ".lock", *data["sha256"]}
    for entry in data["functions"].values():
        assert data["sha256"][entry["file"]] == entry["sha256"]
    return data


@pytest.mark.parametrize("workers", ["threads", "processes"])
def test_writers_at_the_same_time_lose_nothing(workers: str, tmp_path: Path) -> None:
    jobs = [(tmp_path / "m", name) for name in NAMES]
    if workers == "threads":
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(add, jobs))
    else:
        with ProcessPoolExecutor(2, mp_context=get_context("fork")) as pool:
            list(pool.map(add, jobs))
    assert set(check_whole(tmp_path / "m")["functions"]) == set(NAMES)
    saved = json.loads((tmp_path / "m" / "functions.json").read_text("utf-8"))
    assert set(NAMES) < set(saved)


def test_same_model_keeps_its_functions_another_replaces_them(tmp_path: Path) -> None:
    add((tmp_path, "bias"))
    before = (tmp_path / "manifest.json").read_bytes()
    start(tmp_path)
    assert (tmp_path / "manifest.json").read_bytes() == before
    layout.write_model(tmp_path, manifest.base(cd.derive(arm()), ("bias",)))
    assert check_whole(tmp_path)["available"] == ["bias"]
    assert not layout.missing(tmp_path, ["bias"])
    other = arm()
    other.parameter("extra", 1.0)
    layout.write_model(tmp_path, manifest.base(cd.derive(other), NAMES))
    assert check_whole(tmp_path)["functions"] == {}
    assert not (tmp_path / "bias.c").exists()


def test_a_function_written_twice_is_there_once(tmp_path: Path) -> None:
    add((tmp_path, "bias"))
    add((tmp_path, "com"))
    first = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    add((tmp_path, "bias"))
    saved = json.loads((tmp_path / "functions.json").read_text("utf-8"))
    assert [n for n in saved if n == "bias"] == ["bias"]
    assert first["bias.c"] == (tmp_path / "bias.c").read_bytes()
    check_whole(tmp_path)


def test_a_function_is_there_if_its_text_is(tmp_path: Path) -> None:
    start(tmp_path)
    assert layout.missing(tmp_path, ["bias"])
    add((tmp_path, "bias"))
    assert not layout.missing(tmp_path, ["bias"])
    with open(tmp_path / "bias.c", "a") as file:
        file.write("/* changed */\n")
    assert layout.missing(tmp_path, ["bias"])
    (tmp_path / "bias.c").unlink()
    assert layout.missing(tmp_path, ["bias"])


def test_foreign_and_damaged_directories_are_refused(tmp_path: Path) -> None:
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(CodegenError, match="not empty"):
        start(tmp_path)
    assert (tmp_path / "letter.txt").read_text() == "dear"
    damaged = tmp_path / "damaged"
    add((damaged, "com"))
    text = (damaged / "manifest.json").read_text("utf-8")
    (damaged / "manifest.json").write_text(text[:100], "utf-8")
    (damaged / "model.h").rename(damaged / "other.h")
    with pytest.raises(CodegenError, match="damaged"):
        start(damaged)
    # one that is ours is written anew
    (damaged / "other.h").rename(damaged / "model.h")
    start(damaged)
    assert layout.read(damaged) is not None
    (tmp_path / "empty").mkdir()
    function = cd.derive(arm()).function("com")
    cfile = generate(function)
    with pytest.raises(CodegenError, match="write_model"):
        layout.add_functions(tmp_path / "empty", [(cfile, function)])


def test_model_header_names_every_slot(tmp_path: Path) -> None:
    start(tmp_path)
    text = (tmp_path / "model.h").read_text("utf-8")
    assert "q_shoulder = 7, /* shoulder [rad] */" in text
    assert "u_float_u_px = 3," in text
    assert "p_m = 0, /* m [kg] */" in text
    assert "cardan_nq = 9," in text


def test_a_model_of_elements_writes_its_manifest_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written, write = list[str](), layout._write

    def noted(path: Path, text: str | bytes) -> str:
        written.append(path.name)
        return write(path, text)

    monkeypatch.setattr(layout, "_write", noted)
    equations = cd.derive(arm(), coordinates="absolute")
    model_folder.write(tmp_path, equations, ("rhs",))
    assert written.count("manifest.json") == 1
    data = check_whole(tmp_path)
    assert data["functions"].keys() == {f.name for f in model_folder.functions(equations)}
    # what is there is not written again
    model_folder.write(tmp_path, equations, ("rhs",))
    assert written.count("manifest.json") == 1
    (tmp_path / "node__move.c").write_text("damaged", "utf-8")
    model_folder.write(tmp_path, equations, ("rhs",))
    assert check_whole(tmp_path)["functions"] == data["functions"]
