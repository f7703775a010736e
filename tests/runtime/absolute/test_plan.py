"""The pattern of sparse matrices, the order of elimination, and what a plan costs."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.errors import ArgumentError
from cardan.runtime.sparse.pattern import Pattern, pattern
from cardan.runtime.sparse.plan import Plan, plan
from cardan.runtime.sparse.systems import assembled
from runtime.absolute.structures import STRUCTURES, Structure, bars, grid, line
from table import each


def chain(n: int) -> Plan:
    return plan([6] * n, [np.array(line(n)).reshape(-1, 2)])


def added(made: Pattern, groups: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Ones of every element, added in place as a mesh does and by plain indexing."""
    numbers, dense = np.zeros(made.values), np.zeros((made.n, made.n))
    first, sizes = made.first, made.sizes
    for blocks, places in zip(groups, made.places, strict=True):
        for element, place in zip(blocks, places, strict=True):
            for i, block in enumerate(element):
                for j, other in enumerate(element):
                    if place[i, j] < 0:
                        assert made.multiplier[block]
                        assert made.multiplier[other]
                        continue
                    for row in range(sizes[block]):
                        at = place[i, j] + row * made.stride[block]
                        numbers[at : at + sizes[other]] += 1
                    dense[first[block] : first[block + 1], first[other] : first[other + 1]] += 1
    return numbers, dense


def test_elements_add_in_place() -> None:
    sizes, multiplier = [6, 3, 0, 1, 5], [0, 0, 0, 0, 1]
    groups = [np.array([[0, 1], [1, 3]]), np.array([[0, 1, 2, 4], [0, 3, 2, 4]])]
    made = plan(sizes, groups, multiplier)
    numbers, dense = added(made.pattern, groups)
    assert (assembled(made, numbers).toarray() == dense).all()
    assert made.pattern.csr[1][-1] == made.pattern.values == len(numbers)
    # rows of the CSR are sorted, without doubles
    assert assembled(made, numbers).has_canonical_format


@each("name", STRUCTURES)
def test_every_number_goes_to_its_own_place(name: str) -> None:
    made = STRUCTURES[name].plan()
    taken = np.zeros(made.factors, int)
    per = np.diff(made.load_start)
    panel, n, later = (np.repeat(x, per) for x in (made.panel, np.diff(made.start), made.later))
    strides = np.where(made.load[:, 2] < panel + n * n, n, later)
    for (_, _, to, rows, columns, _, _, turned), stride in zip(made.load, strides, strict=True):
        down, across = (1, stride) if turned else (stride, 1)
        np.add.at(taken, to + down * np.arange(rows)[:, None] + across * np.arange(columns), 1)
    assert taken.max() == 1
    assert taken.sum() == made.pattern.values
    assert sorted(made.order) == list(range(made.pattern.n))


def test_chains_keep_their_order_and_do_not_fill() -> None:
    made = chain(50)
    assert (made.order == np.arange(300)).all()
    # D of every node, U and Lt between neighbours; the last two are one
    assert made.factors == 48 * 3 * 36 + 12 * 12


@pytest.mark.parametrize(("name", "added"), [("branches", 0), ("ring of beams", 2 * 9)])
def test_little_fill(name: str, added: int) -> None:
    """Blocks of the factors: those of the matrix in trees; a ring of n adds n - 3 pairs."""
    structure = STRUCTURES[name]
    made = structure.plan()
    own = np.diff(made.start)
    blocks = structure.nodes + 2 * len(structure.beams) + added
    assert int((own * (own + 2 * made.later)).sum()) == 36 * blocks


def test_trees_of_bodies_do_not_fill() -> None:
    """Bodies with their joints: each meets the one before, with what stands there as well."""
    made = STRUCTURES["bodies in a tree"].plan()
    # a body of 6, rows of its joint, coordinates of joints to those after it
    assert int(made.later.max()) <= 6 + 6 + 3


def test_joints_go_with_their_bodies() -> None:
    """A row of bodies: speeds, the six rows of the joint before and its coordinate in one block."""
    made = Structure(30, [], bars(30)).plan()
    assert set(np.diff(made.start)[:-1]) == {13}
    assert (made.later[:-1] == 13).all()


def test_redundant_rows_do_not_join_everything() -> None:
    made = Structure(30, [], bars(30), again=30).plan()
    assert made.widest <= 40


def test_wide_fronts_are_cut() -> None:
    made = plan([6] * 400, [np.array(grid(20))])
    assert made.widest == 48
    assert made.operations < 3e7


@pytest.mark.parametrize(
    "structure",
    [
        lambda n: chain(n),
        lambda n: Structure(n, [], bars(n)).plan(),
        lambda n: plan([6] * n, [np.array([*line(n), (n - 1, 0)])]),
        lambda n: plan([6] * n, [np.array([(i, i // 2) for i in range(1, n)])]),
        lambda n: plan(
            [6] * n, [np.array([(i, j) for i in range(n) for j in (i + 1, i + 3) if j < n])]
        ),
    ],
    ids=["chain", "bodies", "ring", "tree", "ladder"],
)
def test_growth_is_linear(structure: object) -> None:
    small, large = (structure(n) for n in (500, 4000))  # type: ignore[operator]
    for count in ("operations", "factors"):
        assert getattr(large, count) <= 8.2 * getattr(small, count)
    assert len(large.target) + len(large.load) <= 8.2 * (len(small.target) + len(small.load))


def test_operations_of_a_chain() -> None:
    """LU of a block, two solves with six columns and one product, and nothing else."""
    assert chain(101).operations - chain(100).operations == 70 + 216 + 216


def test_nothing_at_all() -> None:
    made = plan([], [])
    assert made.pattern.n == made.factors == made.operations == 0
    assert "0 unknowns" in repr(made)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([6], [[[0, 1]]]), "cliques of group 0: blocks 0 to 1, there are 1"),
        (([6], [[[0]], [[-1]]]), "cliques of group 1: blocks -1 to -1"),
        (([6], [[0]]), r"shape \(1,\) instead of \(n, k\)"),
        (([6, -1], []), "block 1 has -1 unknowns"),
        (([6, 6], [], [True]), "multiplier: 1 entries for 2 blocks"),
        (([6, 6], [], None, [True]), "massless: 1 entries for 2 blocks"),
        (([50_000], []), "2,500,000,000 numbers is too large"),
    ],
)
def test_what_does_not_fit_is_refused(arguments: tuple[object, ...], message: str) -> None:
    with pytest.raises(ArgumentError, match=message):
        plan(*arguments)  # type: ignore[arg-type]


def test_factors_beyond_counting_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cardan.runtime.sparse.plan.LARGEST", 1000)
    with pytest.raises(ArgumentError, match=r"factors of 5,[0-9]* numbers are too large"):
        chain(50)


def test_unknowns_know_their_block() -> None:
    made = pattern([2, 0, 3], [])
    assert [made.block_of(i) for i in range(5)] == [0, 0, 2, 2, 2]
