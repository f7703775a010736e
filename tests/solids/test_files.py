"""Files of Gmsh, Abaqus and CalculiX, and files with faults."""

from __future__ import annotations

import random
import re
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan import solids as fem
from cardan.solids.cells import SOLIDS

FILES = Path(__file__).with_name("files")
GMSH = ("lug.msh", "lug22.msh")
VOLUME = (60 * 30 * 10 - np.pi * 8**2 * 10) * 1e-9
DECK = """** two cubes
*Node, nset=All
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
19, 2, 0, 0
20, 2, 1, 0
21, 2, 0, 1
22, 2, 1, 1
99, 5, 5, 5
*ELEMENT, TYPE=c3d8, ELSET=First
10, 1, 2, 3, 4,
5, 6, 7, 8
*Element, type=C3D8R
20, 2, 19, 20, 3, 6, 21, 22, 7
*ELEMENT, TYPE=B31, ELSET=Rods
30, 1, 2
*Elset, elset=Both
FIRST, 20, 30
*Nset, nset=Left, generate
5, 8, 3
1, 4, 3
*Nset, nset=More
left, 2
*Surface, name=End
20, S4
*Surface, name=Side, type=element
Both, S1
*Surface, name=Points, type=node
left
*Material, name=Steel
"""


@pytest.mark.parametrize("name", [*GMSH, "lug.inp"])
def test_a_lug_of_gmsh(name: str) -> None:
    """The same mesh in three formats: names, volume, weight on the hole."""
    if name in GMSH:
        pytest.importorskip("meshio")
    mesh = fem.read(FILES / name, scale=1e-3)
    assert {"hole", "root", "lug"} <= set(mesh.names)
    hole, root = mesh.nodes("hole"), mesh.nodes("root")
    x, y = mesh.points[hole, :2].T * 1e3
    assert np.hypot(x - 45, y) == pytest.approx(8, rel=0.02)
    assert len(root) == len(np.flatnonzero(abs(mesh.points[:, 0]) < 1e-9))
    assert len(mesh.nodes("lug")) == len(mesh.points)
    M = fem.assembled(mesh, cd.material(E=70e9, nu=0.3, rho=2700))[0]
    assert M.sum() / 3 == pytest.approx(2700 * VOLUME, rel=3e-4)
    body = fem.solid(mesh, cd.material(E=70e9, nu=0.3, rho=2700))
    push = fem.pressure(body, "root", 1e6).reshape(-1, 3).sum(axis=0)
    assert push == pytest.approx([1e6 * 300e-6, 0, 0], abs=1e-9)
    around = fem.pressure(body, "hole", 1e6).reshape(-1, 3)
    assert abs(around.sum(axis=0)).max() < 1e-9
    # outward pressure on a hole pushes away from its axis
    assert (around[hole] * (mesh.points[hole] - [0.045, 0, 0]))[:, :2].sum() > 0


def test_formats_give_the_same_body() -> None:
    pytest.importorskip("meshio")
    first, *others = (fem.read(FILES / name, scale=1e-3) for name in (*GMSH, "lug.inp"))
    for other in others:
        assert abs(first.points - other.points).max() < 1e-15
        assert (first.cells["tet10"] == other.cells["tet10"]).all()
        assert (first.nodes("hole") == other.nodes("hole")).all()


def written(folder: Path, text: str, name: str = "deck.inp") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def test_sets_and_surfaces_of_abaqus(tmp_path: Path) -> None:
    mesh = fem.read(written(tmp_path, DECK), scale=1.0)
    assert len(mesh.points) == 12
    assert mesh.cells["hex8"].shape == (2, 8)
    assert mesh.nodes("Left").tolist() == [0, 3, 4, 7]
    assert mesh.nodes("More").tolist() == [0, 1, 3, 4, 7]
    assert mesh.nodes("Points").tolist() == [0, 3, 4, 7]
    assert len(mesh.nodes("All")) == 12
    assert mesh.nodes("First").tolist() == list(range(8))
    assert len(mesh.nodes("Both")) == 12
    ends, sides = mesh.faces("End")["quad4"], mesh.faces("Side")["quad4"]
    assert (mesh.points[ends][:, :, 0] == 2).all()
    assert (mesh.points[sides][:, :, 2] == 0).all()
    assert (len(ends), len(sides)) == (1, 2)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("20, 2, 19,", "20, 2, 77,"), r"deck.inp: element 20: there is no node 77"),
        (("C3D8R", "C3D6"), r"\*ELEMENT in line 19 .*elements C3D6 are not treated.*C3D10"),
        (("20, S4", "20, S9"), r"surface End: 20, S9: give element or set, and S1 to S6"),
        (("20, S4", "Nothing, S4"), r"surface End: there is no set Nothing"),
        (("20, S4", "30, S4"), r"surface End: its elements do not exist"),
        (("left, 2", "lift, 2"), r"set More: there is no set lift"),
        (("left, 2", "1234"), r"set More: there is no node 1234"),
        (("1, 4, 3\n", "1, 999999999, 1\n"), r"\*NSET in line 25 cannot be read"),
        (("5, 6, 7, 8", "5, 6, 7"), r"element 10 has 7 nodes, C3D8 has 8"),
        (("3, 1, 1, 0", "3, 1, one, 0"), r"\*NODE in line 2 cannot be read"),
        (("3, 1, 1, 0", "3, 1, nan, 0"), r"deck.inp: node 2 lies at \[1.0, nan, 0.0\]"),
        (("*Material", "*Include, input=b.inp\n*Material"), r"\*INCLUDE .*join them"),
        (("8, 0, 1, 1", "7, 0, 1, 1"), r"\*NODE in line 2 .*node 7 is there twice: .*instances"),
        (("20, 2, 19,", "10, 2, 19,"), r"element 10 is there twice"),
        (("*Node, nset=All", "*Node, system=C"), r"cylindrical or spherical coordinates are not"),
        (("*Material", "*Instance, name=I\n1., 0, 0\n*Material"), r"I: instances that are moved"),
        (("*Material", "*Ngen\n1, 9\n*Material"), r"\*NGEN .*list them"),
        (("TYPE=c3d8,", "KIND=c3d8,"), r"\*ELEMENT in line 16 cannot be read: 'TYPE' is missing"),
    ],
)
def test_decks_with_faults(tmp_path: Path, change: tuple[str, str], says: str) -> None:
    assert change[0] in DECK
    with pytest.raises(cd.ModelError, match=says):
        fem.read(written(tmp_path, DECK.replace(*change)), scale=1.0)


def test_nodes_in_one_place_are_merged(tmp_path: Path) -> None:
    """Two cubes that do not share nodes; what lies nearer than the distance becomes one."""
    apart = DECK.replace("99, 5, 5, 5", "52, 1, 0, 1e-7\n53, 1, 1, 0\n56, 1, 0, 1\n57, 1, 1, 1")
    apart = apart.replace("20, 2, 19, 20, 3, 6, 21, 22, 7", "20, 52, 19, 20, 53, 56, 21, 22, 57")
    path = written(tmp_path, apart)
    with pytest.raises(cd.ModelError, match=r"nodes 5 and 14 lie in one place.*merge="):
        fem.read(path, scale=1.0)
    mesh = fem.read(path, scale=1.0, merge=1e-6)
    assert len(mesh.points) == 12
    assert len(mesh.nodes("End")) == 4
    with pytest.raises(cd.ModelError, match="merge=-1: give a distance"):
        fem.read(path, scale=1.0, merge=-1)


def test_what_is_left_out_is_said(tmp_path: Path) -> None:
    deck = DECK + "*NSET, NSET=Alone\n99\n"
    with pytest.warns(cd.ModelWarning, match=r"1 set with nodes or faces of no solid cell.*Alone"):
        mesh = fem.read(written(tmp_path, deck), scale=1.0)
    assert "Alone" not in mesh.names


def test_files_that_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(cd.ModelError, match="cannot be read: No such file"):
        fem.read(tmp_path / "none.inp")
    with pytest.raises(cd.ModelError, match="it is a directory"):
        fem.read(tmp_path)
    pytest.importorskip("meshio")
    for name, text in (("a.msh", "$MeshFormat\n9.9 0 8\n"), ("a.xyz", "1"), ("a.vtu", "<a/>")):
        with pytest.raises(cd.ModelError, match="meshio cannot read it"):
            fem.read(written(tmp_path, text, name))


def test_a_count_beyond_the_file_is_refused_at_once(tmp_path: Path) -> None:
    pytest.importorskip("meshio")
    text = (FILES / "lug.msh").read_text()
    count = re.search(r"\$Nodes\n(\d+ 396 1 396)", text)
    assert count
    text = text.replace(count[1], count[1].replace("396", "39999999"))
    with pytest.raises(cd.ModelError, match="says that it has 39999999 nodes, in"):
        fem.read(written(tmp_path, text, "many.msh"))


@pytest.mark.parametrize(
    "lines",
    ["*NSET, NSET=A, GENERATE\n" + "1, 9000000, 1\n" * 200, "*NSET, NSET=root\nroot\n" * 60],
    ids=["ranges", "itself"],
)
def test_a_few_lines_do_not_fill_the_memory(tmp_path: Path, lines: str) -> None:
    """Ranges again and again, and a set that doubles with every line."""
    deck = (FILES / "lug.inp").read_text() + "\n" + lines
    with pytest.raises(cd.ModelError, match=r"more than 10000000 labels in all sets; leave some"):
        fem.read(written(tmp_path, deck, "deck.inp"), scale=1e-3)


def test_wedges_are_refused_by_name(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]], float)
    meshio.Mesh(points, [("wedge", [[0, 1, 2, 3, 4, 5]])]).write(tmp_path / "a.vtk")
    with pytest.raises(cd.ModelError, match=r"cells of the kind wedge; treated are tet4, tet10"):
        fem.read(tmp_path / "a.vtk")


def test_without_meshio_the_cure_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "meshio", None)
    with pytest.raises(ModuleNotFoundError, match=r"pip install 'cardan\[fem\]'"):
        fem.read(FILES / "lug.msh")
    fem.read(FILES / "lug.inp", scale=1e-3)


@pytest.mark.parametrize("name", [*GMSH, "lug.inp"])
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.filterwarnings("ignore")
def test_mutants_end_in_messages(name: str, seed: int, tmp_path: Path) -> None:
    """Bytes exchanged, lines cut or doubled: a mesh or a ModelError, nothing else."""
    if name in GMSH:
        pytest.importorskip("meshio")
    rng = random.Random(seed)
    lines = (FILES / name).read_text().splitlines()
    for _ in range(3):
        k = rng.randrange(len(lines))
        choice = rng.randrange(4)
        if choice == 0:
            del lines[k : k + rng.randrange(1, 30)]
        elif choice == 1:
            lines[k] = lines[rng.randrange(len(lines))]
        elif choice == 2:
            lines[k] = lines[k].replace(str(rng.randrange(10)), rng.choice(["-", "9999999", "x"]))
        else:
            del lines[rng.randrange(k, len(lines)) :]
            lines = lines or ["x"]
    path = written(tmp_path, "\n".join(lines), name)
    try:
        fem.read(path, scale=1e-3)
    except cd.ModelError:
        return


def test_the_page_lists_all_kinds_of_cells() -> None:
    page = (Path(__file__).parents[2] / "docs" / "superelements.md").read_text("utf-8")
    rows = re.findall(r'^\| `"(\w+)"` \| (\d+) \| (\w+) \|', page, re.M)
    cells = {cell.kind: (str(len(cell.nodes)), cell.abaqus[0]) for cell in SOLIDS.values()}
    assert {kind: (nodes, name) for kind, nodes, name in rows} == cells
