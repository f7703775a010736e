"""Superelements in scene files: records, matrices and meshes beside them, and what is refused."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import mmwrite

import cardan as cd
from cardan.codegen.fingerprint import fingerprint
from cardan.number_file import packed, unpacked
from cardan.scene.files.yaml import from_text
from cardan.superelements import storage
from scene.test_scene_schema import complaints, document
from superelements.components import brick, brick_matrices, faces
from table import each

TESTS = Path(__file__).parents[1]
BAR = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}
INTERFACE = "interface: {root: [11, 12, 13, 14], tip: [51, 52, 53, 54]}"


def written(folder: Path, section: str, more: str = "") -> Path:
    """A scene with superelements in a folder."""
    path = folder / "scene.yaml"
    path.write_text(f"cardan: 2\nsuperelements:\n  {section}\n{more}", encoding="utf-8")
    return path


def with_files(folder: Path, files: Iterable[Path]) -> None:
    for file in files:
        shutil.copy(file, folder / file.name)


def assert_same_record(one: Any, other: Any) -> None:
    for name in ("M", "C", "K", "basis", "stress"):
        assert np.array_equal(getattr(one, name), getattr(other, name)), name
    assert repr(one) == repr(other)


def crane() -> cd.Scene:
    """Superelements that beams, joints and other superelements begin and end at."""
    scene = cd.Scene("crane")
    record, other = brick(modes=2), brick(modes=1)
    first = scene.superelement("first", record, {"root": scene.ground.at(0, 0, 1)}, frame="root")
    tube, steel = cd.section.tube(0.1, 0.08), cd.material(E=2e11, nu=0.3, rho=7800)
    rope = scene.beam("mast", first.at("tip"), (3, 0, 1), tube, steel, elements=2)
    second = scene.superelement("a/b c", other, {"root": rope.end}, weights=(0.1, 0.6))
    scene.beam("end", second.at("tip").at(0, 0, 0.1), (6, 0, 1), tube, steel, elements=2)
    third = scene.superelement("third", record, frame="chord", inertia="corotated")
    tool = scene.body("tool", 1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), "end.end", third.at("root"))
    place = third.at("tip").at(0.1, 0, 0)
    scene.joint("flange", cd.Fixed(), place, tool)
    scene.superelement("fourth", other, {"root": place, "tip": tool.at(0, 0, 1)})
    return scene


def test_saved_and_read_again(tmp_path: Path) -> None:
    scene, path = crane(), tmp_path / "crane.yaml"
    scene.save(path)
    names = sorted(file.name for file in tmp_path.iterdir())
    # one file for each record, in letters that every system has
    assert names == ["crane.a_b_c.npz", "crane.first.npz", "crane.yaml"]
    assert complaints(document(path)) == []
    loaded = cd.load(path)
    assert [*loaded.superelements] == [*scene.superelements]
    for name, one in scene.superelements.items():
        again = loaded.superelements[name]
        assert_same_record(again.record, one.record)
        for key in ("joined", "frame", "weights", "stiffening", "inertia"):
            assert getattr(again, key) == getattr(one, key)
        assert isinstance(again.record, cd.superelement.Superelement)
    assert fingerprint(cd.derive(loaded)) == fingerprint(cd.derive(scene))
    loaded.save(tmp_path / "second.yaml")
    text = (tmp_path / "second.yaml").read_text(encoding="utf-8")
    assert text.replace("second.", "crane.") == path.read_text(encoding="utf-8")


def test_names_that_one_file_would_have(tmp_path: Path) -> None:
    scene = cd.Scene("pair")
    for k, name in enumerate(("a b", "a_b", "A_B")):
        scene.superelement(name, brick(modes=k), {"root": scene.ground.at(0, k, 0)})
    scene.save(tmp_path / "pair.yaml")
    loaded = cd.load(tmp_path / "pair.yaml")
    counts = [one.record.n - one.record.n_boundary for one in loaded.superelements.values()]
    assert counts == [0, 1, 2]


def test_a_scene_with_them_is_a_part_of_another(tmp_path: Path) -> None:
    part = cd.Scene("part")
    part.superelement("arm", brick(modes=1), {"root": part.ground.at(0, 0, 1)})
    (tmp_path / "parts").mkdir()
    part.save(tmp_path / "parts" / "part.yaml")
    more = "include:\n  left: {file: parts/part.yaml, at: {body: ground, at: [0, 1, 0]}}\n"
    path = written(
        tmp_path, "own: {file: parts/part.arm.npz, interfaces: {tip: left.arm.tip}}", more
    )
    scene = cd.load(path)
    assert [*scene.superelements] == ["left.arm", "own"]
    assert scene.superelements["own"].joined == {"tip": "left.arm.tip"}


def test_matrices_beside_the_scene(tmp_path: Path) -> None:
    with_files(tmp_path, (TESTS / "superelements" / "files").iterdir())
    reduction = "method: rubin, modes: 3, damping: 0.01, at: {tip: [1, 0, 0]}, rigid: {tip: rbe3}"
    path = written(
        tmp_path, f"bar: {{matrices: {{file: bar.sti, {INTERFACE}, {reduction}}}, frame: root}}"
    )
    assert complaints(document(path)) == []
    matrices = cd.superelement.read(tmp_path / "bar.sti")
    record = matrices.reduce(
        BAR, method="rubin", modes=3, damping=0.01, at={"tip": (1, 0, 0)}, rigid={"tip": "rbe3"}
    )
    placed = cd.load(path).superelements["bar"]
    assert placed.frame == "root"
    assert_same_record(placed.record, record)


def test_matrices_in_files_of_any_name(tmp_path: Path) -> None:
    M, K, nodes = brick_matrices()
    mmwrite(tmp_path / "K.mtx", K, symmetry="symmetric", precision=17)
    mmwrite(tmp_path / "M.mtx", M, symmetry="symmetric", precision=17)
    np.savetxt(tmp_path / "nodes.csv", nodes, delimiter=",", fmt="%.17g")
    sets = {name: nodes_of.tolist() for name, nodes_of in faces().items()}
    files = "file: K.mtx, mass: M.mtx, nodes: nodes.csv"
    path = written(tmp_path, f"b: {{matrices: {{{files}, interface: {json.dumps(sets)}}}}}")
    record = cd.load(path).superelements["b"].record
    np.testing.assert_allclose(record.M, brick().M, rtol=1e-9, atol=1e-12)
    assert record.n == brick().n


def test_a_mesh_beside_the_scene(tmp_path: Path) -> None:
    with_files(tmp_path, [TESTS / "solids" / "files" / "lug.inp"])
    material = "{E: 70e9, nu: 0.3, rho: 2700, expansion: 2.3e-5}"
    section = (
        f"lug: {{mesh: {{file: lug.inp, scale: 1e-3, material: {material}, modes: 2, "
        "interfaces: {base: root, pin: hole}, stress: root, stiffening: base}, "
        "frame: base, stiffening: true}"
    )
    path = written(tmp_path, section)
    assert complaints(document(path)) == []
    record = cd.superelement.from_mesh(
        tmp_path / "lug.inp",
        cd.material(E=70e9, nu=0.3, rho=2700, expansion=2.3e-5),
        {"base": "root", "pin": "hole"},
        modes=2,
        stress="root",
        stiffening="base",
        scale=1e-3,
    )
    placed = cd.load(path).superelements["lug"]
    assert_same_record(placed.record, record)
    assert placed.stiffening
    cd.load(path).save(tmp_path / "saved.yaml")
    assert cd.load(tmp_path / "saved.yaml").superelements["lug"].stiffening
    with pytest.raises(cd.ModelError, match=r"meshes are reduced where cardan\.load reads"):
        from_text(path.read_text(encoding="utf-8"), name="scene.yaml", folder=tmp_path)


REFUSED = {
    "a: {file: none.npz}": "there is no file 'none.npz' below the folder of the scene",
    "a: {file: ../part.npz}": "leads out of the declared folders",
    "a: {file: /etc/passwd}": "there is no file '/etc/passwd'",
    "a: {file: out.npz}": "there is no file 'out.npz'",
    "a: {file: bar.sti}": "is not a superelement of cardan",
    "a: {file: folder.npz}": "there is no file 'folder.npz'",
    "a: {file: tampered.npz}": "its hash differs from that of its content",
    "a: {file: cut.npz}": "is not a superelement of cardan, or is damaged",
    "a: {file: future.npz}": "which reads superelement format 1",
    "a: {}": "one of file (a record), matrices and mesh; this one has none",
    "a: {frame: mean}": "this one has none",
    "a: {file: part.npz, mesh: {file: b, material: {E: 1}, interfaces: {}}}": "file and mesh",
    "a: [part.npz]": "is wanted, not a list",
    "a: part.npz": "a superelement such as {file: boom.npz",
    "a: {fil: part.npz}": "a superelement has no key 'fil'. Keys: file",
    "a: {file: [part.npz]}": "a text is wanted, not a list",
    "a: {file: part.npz, interfaces: [root]}": "places by name is wanted, not a list",
    "a: {file: part.npz, interfaces: {rot: ground}}": "there is no interface 'rot'. "
    "Known: root, tip. Did you mean 'root'?",
    "a: {file: part.npz, interfaces: {root: nowhere}}": "frame 'nowhere' does not exist",
    "a: {file: part.npz, interfaces: {root: a.tip}}": "frame 'a.tip' does not exist",
    "a: {file: part.npz, interfaces: {root: 3}}": "frame '3' does not exist",
    "a: {file: part.npz, interfaces: {root: {at: [1, 2, 3]}}}": "a frame needs the key 'body'",
    "a: {file: part.npz, interfaces: {root: ground, root: ground}}": "the key 'root' is here twice",
    "a: {file: part.npz}\n  a: {file: part.npz}": "the key 'a' is here twice",
    "a: {file: part.npz}\n  a.root: {file: part.npz, frame: no}": "there is no frame 'no'",
    "a: {file: part.npz, frame: men}": "Did you mean 'mean'?",
    "a: {file: part.npz, frame: [1]}": "a text is wanted, not a list",
    "a: {file: part.npz, weights: 1}": "a list of numbers is wanted",
    "a: {file: part.npz, weights: [1]}": "give 2 numbers of at least 0",
    "a: {file: part.npz, weights: [1, -1]}": "give 2 numbers of at least 0",
    "a: {file: part.npz, weights: [1, x]}": "x",
    "a: {file: part.npz, inertia: nodl}": "Did you mean 'nodal'?",
    "a: {file: part.npz, frame: root, stiffening: true}": "stiffening",
    "a: {file: part.npz, stiffening: 1}": "true or false is wanted",
    "a: {file: part.npz, loads: [1]}": "factors by name is wanted, not a list",
    "a: {file: part.npz, loads: {heat: 1}}": "no load 'heat'. Give loads= to the reduction",
    "a: {file: part.npz, loads: {gravity: 1}}": "by gravity= of the scene already",
    "a: {file: part.npz, loads: {heat: unknown}}": "unknown",
    "a: {matrices: bar.sti}": "matrices such as {file: ..., interface: ...} is wanted",
    "a: {matrices: {file: bar.sti}}": "matrices needs the key 'interface'",
    f"a: {{matrices: {{file: bar.sti, mass: x.mas, {INTERFACE}}}}}": "no file 'x.mas'",
    f"a: {{matrices: {{file: alone.sti, {INTERFACE}}}}}": "no file alone.mas beside it; give mass=",
    f"a: {{matrices: {{file: part.npz, {INTERFACE}}}}}": "is a reduced component",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, modes: 2.5}}}}": "an integer is wanted",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, modes: -1}}}}": "give 0 or more",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, modes: 999999}}}}": "999999",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, method: rubn}}}}": "Did you mean 'rubin'?",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, at: {{tip: [1]}}}}}}": "three finite numbers",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, rigid: {{tip: [1]}}}}}}": "a text is wanted",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, damping: [x]}}}}": "x",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, rayleigh: [1]}}}}": "rayleigh",
    f"a: {{matrices: {{file: bar.sti, {INTERFACE}, static_shapes: [heat]}}}}": "heat",
    "a: {matrices: {file: bar.sti, interface: {root: [11, 1.5]}}}": "an integer is wanted",
    "a: {matrices: {file: bar.sti, interface: {root: []}}}": "give a node or nodes",
    "a: {matrices: {file: bar.sti, interface: {root: x}}}": "root",
    "a: {matrices: {file: bar.sti, interface: {}}}": "interface",
    "a: {mesh: {file: lug.inp}}": "a mesh needs the key 'material'",
    "a: {mesh: {file: lug.inp, material: {E: 1, nu: 0, rho: 1}, interfaces: {base: rot}}}": "rot",
    "a: {mesh: {file: lug.vtu, material: {E: 1}, interfaces: {base: root}}}": ".inp and .msh",
    "a: {mesh: {file: bar.inp, material: {E: 1, nu: 0}, interfaces: {base: 1}}}": "bar.inp",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with good files and bad ones, and a record outside of it."""
    home = tmp_path_factory.mktemp("scene")
    inside = home / "inside"
    (inside / "folder.npz").mkdir(parents=True)
    with_files(inside, (TESTS / "superelements" / "files").iterdir())
    with_files(inside, [TESTS / "solids" / "files" / "lug.inp"])
    shutil.copy(inside / "lug.inp", inside / "lug.vtu")
    shutil.copy(inside / "bar.sti", inside / "alone.sti")
    brick(modes=1).save(home / "part.npz")
    good = (home / "part.npz").read_bytes()
    (inside / "part.npz").write_bytes(good)
    (inside / "out.npz").symlink_to(home / "part.npz")
    (inside / "cut.npz").write_bytes(good[: len(good) // 2])
    arrays = unpacked(good)
    (inside / "tampered.npz").write_bytes(packed({**arrays, "K": 2 * arrays["K"]}))
    about = json.loads(str(arrays[storage.ABOUT]))
    about[storage.SUPERELEMENT.word] = 99
    future = packed({**arrays, storage.ABOUT: np.array(json.dumps(about))})
    (inside / "future.npz").write_bytes(future)
    return inside


@pytest.mark.filterwarnings("ignore::cardan.ModelWarning")
@each("section", REFUSED)
def test_refused(section: str, folder: Path) -> None:
    path = written(folder, section)
    with pytest.raises((cd.ModelError, cd.TopologyError)) as caught:
        cd.load(path)
    message = str(caught.value)
    assert REFUSED[section] in message
    assert re.match(r"scene\.yaml:\d+:\d+: ", message), message
    assert len(message) < 700


def test_a_fault_that_shows_later_has_its_place(folder: Path) -> None:
    more = "bodies: {tool: {mass: 1}}\njoints: {a: {type: free, parent: ground, child: tool}}\n"
    path = written(folder, "a: {file: part.npz, interfaces: {root: ground}}", more)
    with pytest.raises(cd.ModelError, match=r"scene\.yaml:3:3: superelement 'a': the name 'a' of"):
        cd.derive(cd.load(path))


def test_companions_do_not_lead_out(folder: Path, tmp_path: Path) -> None:
    """A link beside a file, whose name nobody wrote, is not followed out of the folder."""
    inside = tmp_path / "inside"
    inside.mkdir()
    for ending in (".sti", ".dof", ".inp"):
        shutil.copy(folder / f"bar{ending}", inside)
    shutil.copy(folder / "bar.mas", tmp_path)
    (inside / "bar.mas").symlink_to(tmp_path / "bar.mas")
    path = written(inside, f"a: {{matrices: {{file: bar.sti, {INTERFACE}}}}}")
    with pytest.raises(cd.ModelError, match=r"no file bar\.mas beside it"):
        cd.load(path)
    (inside / "bar.mas").unlink()
    shutil.copy(folder / "bar.mas", inside)
    assert cd.load(path).superelements
