"""Files of other programs: what they hold is read, what is wrong in them is refused by its line."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import mmwrite

import cardan as cd
from cardan.number_file import packed
from cardan.superelements.readers import READERS
from superelements.components import BAR, FILES, brick_matrices, frequencies
from table import each

ENDS = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}
DIRECTION = {"x": 1, "y": 2, "z": 3}
# printed by CalculiX 2.20 for the same input with *FREQUENCY
PRINTED = (5.687239e3, 6.887220e3, 7.515588e3, 1.372882e4)


@cache
def bar() -> Any:
    return cd.superelement.read(BAR)


def test_files_of_calculix() -> None:
    """A real run: 4 hexahedra, their eigenvalues as the program printed them."""
    matrices = bar()
    assert matrices.dofs[:4] == ((11, "x"), (11, "y"), (11, "z"), (12, "x"))
    np.testing.assert_array_equal(matrices.nodes[-1], [1.2, 0.25, 0.15])
    counts = [np.count_nonzero(matrix.toarray()) for matrix in (matrices.K, matrices.M)]
    said = f"60 rows, {counts[0]} entries of K, {counts[1]} of M, 20 nodes"
    assert repr(matrices).endswith(said)
    omega = frequencies(matrices.M.toarray(), matrices.K.toarray(), zeros=6)
    np.testing.assert_allclose(omega[:4], PRINTED, rtol=4e-7)
    # mean frames and all modes leave the component as it is
    record = matrices.reduce(ENDS, rigid="rbe3", modes=48)
    np.testing.assert_allclose(record.modes().frequencies[:4], PRINTED, rtol=4e-7)
    assert record.properties.mass == pytest.approx(2700 * 1.2 * 0.25 * 0.15, rel=1e-12)
    assert max(record.check.residual) < 1e-13


Writer = Callable[[Path], dict[str, Path]]


def entries() -> list[tuple[np.ndarray, list[tuple[int, int, int, int, float]]]]:
    """K and M, and the lower triangle of each with nodes and directions."""
    labels = [(node, DIRECTION[name]) for node, name in bar().dofs]
    result = []
    for matrix in (bar().K.toarray(), bar().M.toarray()):
        rows = [
            (*labels[i], *labels[j], matrix[i, j])
            for i in range(60)
            for j in range(i + 1)
            if matrix[i, j]
        ]
        result.append((matrix, rows))
    return result


def node_table(folder: Path, numbered: bool = True) -> Path:
    path = folder / "nodes.csv"
    rows = zip(bar().node_ids, bar().nodes, strict=True)
    lines = [
        ", ".join([*([str(k)] if numbered else []), *(repr(float(v)) for v in x)]) for k, x in rows
    ]
    path.write_text("\n".join(["# nodes", *lines]), "utf-8")
    return path


def npz(folder: Path, sparse: bool = False) -> dict[str, Path]:
    arrays: dict[str, np.ndarray] = {"nodes": bar().nodes, "node_ids": np.array(bar().node_ids)}
    for name, matrix in (("K", bar().K), ("M", bar().M)):
        coo = matrix.tocoo()
        if sparse:
            arrays |= {f"{name}_rows": coo.row, f"{name}_columns": coo.col}
            arrays[f"{name}_values"] = coo.data
        else:
            arrays[name] = matrix.toarray()
    path = folder / "bar.npz"
    path.write_bytes(packed(arrays))
    return {"path": path}


def matrix_market(folder: Path, dense: bool = False, general: bool = False) -> dict[str, Path]:
    paths = [folder / "K.mtx", folder / "M.mtx"]
    for path, matrix in zip(paths, (bar().K, bar().M), strict=True):
        symmetry = "general" if general else "symmetric"
        content = matrix.toarray() if dense else matrix
        mmwrite(path, content, symmetry=symmetry, precision=17)
    return {"path": paths[0], "mass": paths[1], "nodes": node_table(folder)}


def short_nastran(folder: Path, free: bool) -> dict[str, Path]:
    """Fields of eight columns, or between commas, by hand; two entries in a line."""
    path, lines = folder / "bar.pch", []

    def card(*fields: object) -> str:
        if free:
            return ",".join(f"{field}" for field in fields)
        return "".join(f"{field:<8}" for field in fields)

    for name, (_, rows) in zip(("KAAX", "MAAX"), entries(), strict=True):
        lines.append(card("DMIG", name, 0, 6, 1, 0, "", "", 60))
        columns: dict[tuple[int, int], list[Any]] = {}
        for a, b, c, d, value in rows:
            text = f"{value:.1e}".replace("e", "").replace("+0", "+").replace("-0", "-")
            columns.setdefault((c, d), []).append((a, b, text))
        for (node, direction), column in columns.items():
            lines.append(card("DMIG", name, node, direction, "", *column[0], ""))
            for k in range(1, len(column), 2):
                more = [one for entry in column[k : k + 2] for one in (*entry, "")]
                lines.append(card("", *more))
    for k, x in zip(bar().node_ids, bar().nodes, strict=True):
        lines.append(card("GRID", k, "", *(f"{v:.3g}" for v in x)))
    path.write_text("\n".join(lines), "utf-8")
    return {"path": path}


def nastran(folder: Path) -> dict[str, Path]:
    """Punch with large fields, by hand."""
    path = folder / "bar.pch"
    lines = ["$ DMIG by hand"]
    for name, (_, rows) in zip(("KAAX", "MAAX"), entries(), strict=True):
        lines.append(f"DMIG    {name:<8}       0       6       2       0              60")
        columns: dict[tuple[int, int], list[Any]] = {}
        for a, b, c, d, value in rows:
            columns.setdefault((c, d), []).append((a, b, value))
        for (node, direction), column in columns.items():
            lines.append(f"DMIG*   {name:<16}{node:>16}{direction:>16}")
            for a, b, value in column:
                text = f"{value:.9E}".replace("E", "D")
                lines.append(f"*       {a:>16}{b:>16}{text:>16}")
    for k, x in zip(bar().node_ids, bar().nodes, strict=True):
        lines.append(f"GRID    {k:>8}        " + "".join(f"{v:>8.3g}" for v in x))
    path.write_text("\n".join(lines), "utf-8")
    return {"path": path}


def abaqus(folder: Path, labeled: bool = True) -> dict[str, Path]:
    paths = [folder / "K.txt", folder / "M.txt"]
    for path, (matrix, rows) in zip(paths, entries(), strict=True):
        if labeled:
            lines = [f" {a},{b}, {c},{d}, {v:.16e}" for a, b, c, d, v in rows]
            lines = ["** by hand", "*MATRIX, NAME=A, TYPE=SYMMETRIC", *lines]
        else:
            places = np.argwhere(matrix != 0)
            lines = [f"{i + 1} {j + 1} {matrix[i, j]:.16e}" for i, j in places]
        path.write_text("\n".join(lines), "utf-8")
    return {"path": paths[0], "mass": paths[1], "nodes": BAR.with_suffix(".inp")}


def calculix(folder: Path) -> dict[str, Path]:
    for ending in (".sti", ".mas", ".dof", ".inp"):
        source = BAR.with_suffix(ending)
        (folder / f"bar{ending}").write_bytes(source.read_bytes())
    return {"path": folder / "bar.sti"}


WRITERS: dict[str, tuple[Writer, float]] = {
    "npz": (npz, 0.0),
    "sparse npz": (lambda folder: npz(folder, sparse=True), 0.0),
    "MatrixMarket": (matrix_market, 1e-15),
    "dense MatrixMarket": (lambda folder: matrix_market(folder, dense=True), 1e-15),
    "general MatrixMarket": (lambda folder: matrix_market(folder, general=True), 1e-15),
    "Nastran": (nastran, 1e-9),
    "short Nastran": (lambda folder: short_nastran(folder, free=False), 0.06),
    "free Nastran": (lambda folder: short_nastran(folder, free=True), 0.06),
    "Abaqus": (abaqus, 1e-15),
    "Abaqus coordinates": (lambda folder: abaqus(folder, labeled=False), 1e-15),
    "CalculiX": (calculix, 0.0),
}


@pytest.mark.parametrize("kind", WRITERS)
def test_every_format_gives_the_same_component(kind: str, tmp_path: Path) -> None:
    write, digits = WRITERS[kind]
    matrices = cd.superelement.read(**write(tmp_path))
    for name in ("K", "M"):
        expected = getattr(bar(), name).toarray()
        values = getattr(matrices, name).toarray()
        np.testing.assert_allclose(values, expected, rtol=digits, atol=0)
    np.testing.assert_allclose(matrices.nodes, bar().nodes)
    assert matrices.node_ids == bar().node_ids
    if digits < 1e-3:
        assert matrices.reduce(ENDS, modes=2).properties.mass == pytest.approx(121.5)


def test_every_reader_is_written_here() -> None:
    assert {one.name.split()[0] for one in READERS} == {
        *("NumPy", "MatrixMarket", "CalculiX", "Nastran", "Abaqus")
    }
    assert [one.name.split()[0] for one in READERS if one.untested] == ["Nastran", "Abaqus"]


def test_the_brick_from_matrix_market() -> None:
    matrices = cd.superelement.read(
        FILES / "se_brick_A_K.mtx", FILES / "se_brick_A_M.mtx", FILES / "se_brick_A_nodes.csv"
    )
    M, K, nodes = brick_matrices()
    np.testing.assert_array_equal(matrices.K.toarray(), K.toarray())
    np.testing.assert_array_equal(matrices.M.toarray(), M.toarray())
    np.testing.assert_array_equal(matrices.nodes, nodes)


def test_positions_may_come_from_the_user(tmp_path: Path) -> None:
    paths = matrix_market(tmp_path)
    del paths["nodes"]
    matrices = cd.superelement.read(**paths)
    with pytest.raises(cd.ModelError, match="give nodes="):
        matrices.reduce({"root": [0, 1, 2, 3]})
    record = matrices.reduce({"root": [0, 1, 2, 3]}, nodes=bar().nodes, modes=1)
    assert record.properties.mass == pytest.approx(121.5)
    plain = cd.superelement.read(**paths, nodes=node_table(tmp_path, numbered=False))
    np.testing.assert_allclose(plain.nodes, bar().nodes)


# kind -> file, what is replaced in it, by what, and what the message says
MUTANTS: list[tuple[str, str, str, str, str]] = [
    ("CalculiX", "bar.sti", "1 1  ", "1 1 ", ""),
    ("CalculiX", "bar.sti", "1 1  3", "1 1  x", r"bar\.sti:1: .* is not a finite number"),
    ("CalculiX", "bar.sti", "1 1  3", "1 1  nan 3", r"bar\.sti:1: 4 numbers, expected 3"),
    ("CalculiX", "bar.sti", "\n2 2 ", "\n2 200000000 ", "names 60 rows, .* of number 200000000"),
    ("CalculiX", "bar.sti", "\n2 2 ", "\n1 1 ", "row 1 and column 1 is there twice"),
    ("CalculiX", "bar.sti", "\n2 2 ", "\n2.5 2 ", "row or column 2.5"),
    ("CalculiX", "bar.sti", "\n2 2 ", "\n-2 2 ", "row or column -2"),
    ("CalculiX", "bar.dof", "11.1\n", "11.7\n", r"bar\.dof:1: '11\.7', expected node\.direction"),
    ("CalculiX", "bar.dof", "11.1\n", "11.1\n11.1\n", "rows? named|twice|entry"),
    ("CalculiX", "bar.dof", "11.1\n", "", "names 59 rows, .* has one of number 60"),
    ("CalculiX", "bar.dof", "11.1\n", "99.1\n", "node 99 has rows, but no position"),
    ("CalculiX", "bar.dof", "11.1\n", "9999999999999999999.1\n", r"bar\.dof:1"),
    ("CalculiX", "bar.inp", "11, 0", "12, 0", "node 12 is there twice"),
    ("CalculiX", "bar.inp", "11, 0,", "11, inf,", "'inf' is not a finite number"),
    ("CalculiX", "bar.inp", "*NODE", "*NODES", r"there is no \*NODE"),
    ("MatrixMarket", "K.mtx", "symmetric", "hermitian", "'hermitian', expected symmetric"),
    ("MatrixMarket", "K.mtx", "real", "complex", "of real numbers"),
    ("MatrixMarket", "K.mtx", "60 60 ", "60 61 ", "expected a square matrix"),
    ("MatrixMarket", "K.mtx", "60 60 ", "9999999999 9999999999 ", "9999999999 rows"),
    ("MatrixMarket", "K.mtx", "60 60 ", "60 60 1", "entries, its head says 1"),
    ("MatrixMarket", "K.mtx", "60 60 ", "50 50 ", "the matrix has 50"),
    ("dense MatrixMarket", "K.mtx", "60 60", "59 59", "entries, its head says"),
    ("Nastran", "bar.pch", "0       6", "0       9", "of form 9 and type 2"),
    ("Nastran", "bar.pch", "6       2", "6       4", "of form 6 and type 4"),
    ("Nastran", "bar.pch", "MAAX", "KBBX", "2 matrices whose names begin with K"),
    ("Nastran", "bar.pch", "DMIG*   KAAX                          11               1",
     "DMIG*   KAAX                          11               0", "scalar point"),
    ("Nastran", "bar.pch", "GRID          11        ", "GRID          11       5", "other axes"),
    ("Nastran", "bar.pch", "D+09\n", "D+0911\n", "does not fit its field"),
    ("Abaqus", "K.txt", " 11,1, 11,1,", " 11,1, 11,9,", "direction 9, expected 1 to 6"),
    ("Abaqus", "K.txt", " 11,1, 11,1,", " 11,1, 11,", r"K\.txt:3: 4 numbers, expected row"),
    ("Abaqus", "K.txt", " 11,1, 11,1,", " 11,1, 11,1, __import__('os'),", r"K\.txt:3: 6 numbers"),
]  # fmt: skip


@pytest.mark.parametrize("number", range(len(MUTANTS)))
def test_a_wrong_file_is_refused_by_its_line(number: int, tmp_path: Path) -> None:
    kind, name, old, new, message = MUTANTS[number]
    paths = WRITERS[kind][0](tmp_path)
    text = (tmp_path / name).read_text("utf-8")
    assert old in text
    (tmp_path / name).write_text(
        text.replace(old, new) if new == "KBBX" else text.replace(old, new, 1), "utf-8"
    )
    if not message:
        cd.superelement.read(**paths)
        return
    with pytest.raises((cd.ModelError, cd.SolveError), match=message):
        cd.superelement.read(**paths).reduce(ENDS, modes=1)


@pytest.mark.parametrize("kind", WRITERS)
def test_a_damaged_file_breaks_nothing(kind: str, tmp_path: Path) -> None:
    """Random bytes changed, cut or repeated: read as something, or refused by an error of ours."""
    paths = WRITERS[kind][0](tmp_path)
    contents = {path: path.read_bytes() for path in {*paths.values()} - {BAR.with_suffix(".inp")}}
    random = np.random.default_rng(7)
    messages: list[str] = []
    for _ in range(25):
        for path, content in contents.items():
            path.write_bytes(content)
        path = [*contents][int(random.integers(len(contents)))]
        damaged = bytearray(contents[path])
        for _ in range(int(random.integers(1, 4))):
            place, length = int(random.integers(len(damaged))), int(random.integers(1, 9))
            way = int(random.integers(3))
            if way == 0:
                damaged[place : place + length] = random.bytes(length)
            elif way == 1:
                del damaged[place : place + length]
            else:
                damaged[place:place] = damaged[place : place + length] * 3
        path.write_bytes(bytes(damaged))
        try:
            cd.superelement.read(**paths)
        except cd.CardanError as error:
            messages.append(str(error))
    assert messages
    assert all(str(tmp_path) in message for message in messages)


def test_comments_may_have_any_letters(tmp_path: Path) -> None:
    paths = calculix(tmp_path)
    text = (tmp_path / "bar.inp").read_bytes().replace(b"bar of four bricks", b"** K\xf6rper 1\xb0")
    (tmp_path / "bar.inp").write_bytes(text)
    dofs = (tmp_path / "bar.dof").read_bytes()
    (tmp_path / "bar.dof").write_bytes(b"\xef\xbb\xbf" + dofs)
    np.testing.assert_array_equal(cd.superelement.read(**paths).nodes, bar().nodes)
    (tmp_path / "bar.dof").write_bytes(dofs + b"\0")
    with pytest.raises(cd.ModelError, match=r"bar\.dof: byte 300 is 0: it is not a text"):
        cd.superelement.read(**paths)


def test_what_is_no_file_of_matrices_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.mtx").write_bytes(
        b"%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 1\n"
    )
    for arguments, message in (
        ({"path": tmp_path / "b.sti"}, "there is no such file"),
        ({"path": tmp_path}, "it is a directory"),
        ({"path": tmp_path / "a.mtx"}, "give mass="),
    ):
        with pytest.raises(cd.ModelError, match=message):
            cd.superelement.read(**arguments)
    (tmp_path / "a.stl").write_bytes(b"solid")
    with pytest.raises(cd.ModelError, match=r"ending is one of \.npz"):
        cd.superelement.read(tmp_path / "a.stl")


@each("word, value", [("1.5D+03", 1500.0), ("1.5+3", 1500.0), ("-2.5E-2", -0.025), ("7", 7.0)])
def test_numbers_as_fortran_writes_them(word: str, value: float) -> None:
    from cardan.superelements.readers.records import number

    assert number(word, "a", 1) == value
    for wrong in ("1_0", "nan", "inf", "0x10", "1e999", "--1", "", "1.5 3"):
        with pytest.raises(cd.ModelError, match="a:1"):
            number(wrong, "a", 1)
