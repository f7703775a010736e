"""The same named values start the same configuration and speeds in every kind of coordinates."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.simulation.starts import finite_element_start
from cardan.errors import DerivationError, ModelError
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from mechanisms.closed_planar import four_bar_angles
from mechanisms.flexible import FLEXIBLE

# in every run; the others where there is time
SHOWN = ("slider_crank",)
OPEN = ("universal", "planar")
BENT = ("pendulum",)
# the nearest of neighboring positions is where a sum of squares is least: to the root of rounding
NEAREST = 1e-6
HELD = 1e-9
PLACE = 0.1  # of the motion that the loops of a mechanism allow
CASES = ("all", "two", "first", "last", "none")
# named is the place of the last window: the first is flat then, and does not move
REFUSED = {("parallelogram", "none"), ("parallelogram", "last")}
FEWEST = 66


def slowly(names: Mapping[str, Any], shown: tuple[str, ...]) -> list[Any]:
    """Names, most of them marked slow."""
    return [n if n in shown else pytest.param(n, marks=pytest.mark.slow) for n in names]


@functools.cache
def models(name: str) -> tuple[cd.CompiledModel, cd.CompiledModel]:
    """A closed mechanism in joint and in absolute coordinates."""
    build = CLOSED[name].build
    return cd.compile(build()), cd.compile(build(), coordinates="absolute")


def started(
    model: cd.CompiledModel, q: Mapping[str, Any], u: Mapping[str, Any]
) -> dict[str, float] | str:
    """Coordinates and speeds of a start by name, or why there is none."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        try:
            x = model.initial(q, u)
        except ModelError as problem:
            return str(problem)
    names = (*model.coordinates, *model.speeds)
    return dict(zip(names, x.tolist(), strict=False))


def places(name: str) -> dict[str, Any]:
    """Coordinates of the joints of the tree at a place of the motion."""
    model = models(name)[0]
    every = CLOSED[name].configuration(PLACE)
    own = [j["name"] for j in model.manifest["joints"] if j["q"] and j["q"][1]]
    return {joint: every[joint] for joint in own if joint in every}


def named(values: Mapping[str, Any], case: str) -> dict[str, Any]:
    """Those of the values that are named in a case."""
    joints = list(values)
    chosen = {"all": joints, "two": joints[:2], "first": joints[:1], "last": joints[-1:]}
    return {joint: values[joint] for joint in chosen.get(case, [])}


@pytest.mark.parametrize("name", slowly(CLOSED, ("parallelogram",)))
def test_an_export_starts_like_its_model(name: str, tmp_path: Path) -> None:
    cd.derive(CLOSED[name].build()).export(tmp_path / "export")
    exported, model = cd.load_model(tmp_path / "export"), models(name)[0]
    for case in CASES:
        q = named(places(name), case)
        assert started(exported, q, {}) == started(model, q, {}), case


@functools.cache
def compared(name: str, case: str) -> int:
    """How many starts of a closed mechanism were compared, at rest and moving; all are alike."""
    relative, absolute = models(name)
    q, count = named(places(name), case), 0
    for speed in (None, 0.7):
        first = relative.speeds[0]
        u = {} if speed is None else {first: speed}
        one, other = started(relative, q, u), started(absolute, q, u)
        if isinstance(one, str) or isinstance(other, str):
            # refused in both: a start at which branches meet, or speeds that do not fit
            assert isinstance(one, str), (one, other)
            assert isinstance(other, str), (one, other)
            continue
        for entry, value in one.items():
            assert other[entry] == pytest.approx(value, abs=NEAREST), entry
        for start in (one, other):
            for joint, given in q.items():
                entries = [
                    n for n in relative.coordinates if n == joint or n.startswith(joint + ".")
                ]
                got = [start[n] for n in entries]
                np.testing.assert_allclose(got, np.ravel(given), atol=HELD)
            assert speed is None or start[first] == pytest.approx(speed, abs=HELD)
        count += 1
    return count


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("name", slowly(CLOSED, SHOWN))
def test_closed_mechanisms_start_alike(name: str, case: str) -> None:
    print(name, case, "starts compared:", compared(name, case))


def test_enough_starts_were_compared() -> None:
    """A law that only sees refusals shows nothing."""
    assert len(CLOSED) >= 7
    assert sum(compared(name, case) for name in SHOWN for case in CASES) == 2 * len(CASES)


@pytest.mark.slow
def test_starts_of_most_mechanisms_were_compared() -> None:
    """Only where branches meet may all starts of a case be refused."""
    pairs = {(name, case) for name in CLOSED for case in CASES}
    counts = {pair: compared(*pair) for pair in sorted(pairs)}
    print("starts compared:", counts)
    assert {pair for pair, count in counts.items() if not count} <= REFUSED
    assert sum(counts.values()) >= FEWEST


def rods(lengths: tuple[float, float, float], distance: float) -> cd.Scene:
    """Three rods in a plane between two pivots."""
    scene, end = cd.Scene("rods", gravity=(0, -9.81, 0)), None
    for k, length in enumerate(lengths):
        rod = scene.body(f"rod{k}", 1.0, inertia=(0.1,) * 3)
        scene.joint(f"J{k}", cd.Revolute("z"), scene.ground if end is None else end, rod)
        end = rod.at(length, 0, 0)
    scene.joint("J3", cd.Revolute("z"), end, scene.ground.at(distance, 0, 0), cut=True)
    return scene


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
@pytest.mark.parametrize("offset", [0.0, 3e-9, 1e-5])
def test_stretched_rods_do_not_start(coordinates: str, offset: float) -> None:
    """Rods on one line between pivots as far apart as they are long: nothing moves, though the

    constraints have a freedom more, here and wherever a search ends beside it. A little less far,
    the rank is lost nowhere.
    """
    model = cd.compile(rods((1.0, 0.7, 0.5), 2.2 - offset**2), coordinates=coordinates)
    start = started(model, {"J0": offset}, {})
    assert isinstance(start, str) == (offset < 1e-6), start
    assert isinstance(start, dict) or "1 of 2 independent constraints" in start


def even() -> cd.Scene:
    """A slider-crank whose crank may stand as far above its line as below."""
    scene = cd.Scene("even", gravity=(0, -9.81, 0))
    crank, rod, slide = (scene.body(n, 1.0, inertia=(0.1,) * 3) for n in ("crank", "rod", "slide"))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(1, 0, 0), rod)
    scene.joint("guide", cd.Prismatic("x"), scene.ground, slide)
    scene.joint("C", cd.Revolute("z"), rod.at(1, 0, 0), slide, cut=True)
    return scene


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_tie_names_both_positions(coordinates: str) -> None:
    """Both are told, the same one is taken in every kind of coordinates, and naming decides."""
    model = cd.compile(even(), coordinates=coordinates)
    third = np.pi / 3
    with pytest.warns(cd.SolveWarning, match="equally near to two positions") as told:
        x = model.initial({"guide": 1.0})
    (said,) = [str(w.message) for w in told if "equally near" in str(w.message)]
    assert f"A = {third:.6g}, B = {-2 * third:.6g}; or A = {-third:.6g}" in said
    start = dict(zip(model.coordinates, x.tolist(), strict=False))
    assert (start["A"], start["B"]) == pytest.approx((third, -2 * third), abs=NEAREST)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        other = model.initial({"guide": 1.0, "A": -third})
    assert other[model.coordinates.index("B")] == pytest.approx(2 * third, abs=NEAREST)


@pytest.mark.parametrize("model", [0, 1], ids=["relative", "absolute"])
def test_the_nearest_branch_is_taken(model: int) -> None:
    """Of both assemblies of a four-bar, in closed form, the one nearer to all angles 0."""
    bars, others = models("four_bar")[model], 0
    at = [bars.coordinates.index(name) for name in ("B", "D")]
    for theta in np.linspace(-3.1, 3.1, 63 if model == 0 else 21):
        begin = started(bars, {"A": theta}, {})
        assert isinstance(begin, dict), begin
        taken = np.array(list(begin.values()))[at]
        branches = [four_bar_angles(theta, side) for side in (1, -1)]
        angles = np.array([[branch["B"], branch["D"]] for branch in branches])
        angles = (angles + np.pi) % (2 * np.pi) - np.pi
        near, far = sorted(np.linalg.norm(angles, axis=1))
        assert np.linalg.norm(taken) == pytest.approx(near, abs=1e-9)
        # the search from 0 ends on the farther one where both are far
        others += far < 1.2 * near
    print(f"{others} of the starts have two branches at nearly the same distance")
    assert others >= 5


@pytest.mark.parametrize("name", slowly(ZOO, OPEN))
def test_trees_start_alike(name: str) -> None:
    member = ZOO[name]
    try:
        absolute = cd.compile(member.build(), coordinates="absolute")
    except DerivationError as refused:
        pytest.skip(str(refused))
    relative = cd.compile(member.build())
    for state in member.states:
        one, other = started(relative, state.q, state.u), started(absolute, state.q, state.u)
        assert isinstance(one, dict), one
        assert isinstance(other, dict), other
        for entry, value in one.items():
            if entry in other:
                assert other[entry] == pytest.approx(value, abs=HELD), entry


@pytest.mark.parametrize("name", slowly(FLEXIBLE, BENT))
def test_flexible_scenes_hold_what_is_named(name: str) -> None:
    """A joint that is named is held, alone or beside others, and the start repeats itself."""
    model = cd.compile(FLEXIBLE[name]())
    joints = [j for j in model.manifest["joints"] if j["q"][1] == 1 and j["kind"] != "free"]
    before = started(model, {}, {})
    assert isinstance(before, dict), before
    for joint in joints:
        start = started(model, {joint["name"]: 0.2}, {})
        assert isinstance(start, dict), start
        assert start[joint["name"]] == 0.2
        gaps = model.constraints(np.array([start[n] for n in model.coordinates]))
        assert np.abs(gaps).max(initial=0.0) < HELD
        every = {n["name"]: start[n["name"]] for n in joints}
        again = started(model, every, {})
        assert isinstance(again, dict), again
        for entry, value in start.items():
            assert again[entry] == pytest.approx(value, abs=NEAREST), entry


def test_beams_start_without_bending() -> None:
    """Nothing is said of the rod: it starts as a rigid one does, in closed form."""
    model = cd.compile(FLEXIBLE["slider_crank"](4))
    start = started(model, {}, {})
    assert isinstance(start, dict), start
    # along its line the crank at 150 rad/s moves the near end across, the far one stays
    rod = -150 * 0.15 / 0.3
    joints = {"guide.u": 0.0, "rod.start.u": rod - 150, "rod.end.u": rod}
    for name, expected in joints.items():
        assert start[name] == pytest.approx(expected, abs=NEAREST), name
    turning = [name for name in start if name.startswith("rod.node") and name.endswith(".u.z")]
    assert len(turning) == 2
    for name in turning:
        assert start[name] == pytest.approx(rod, abs=NEAREST), name
    # what is named is held, and bends the rod
    bending = started(model, {}, {"guide": 1.0})
    assert isinstance(bending, dict), bending
    assert bending["guide.u"] == pytest.approx(1.0, abs=HELD)


SOLVED = ("slider_crank", "four_bar", "andrews", "stewart")


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("name", slowly(dict.fromkeys(SOLVED), (*SHOWN, "four_bar")))
def test_closed_forms_start_alike(name: str, case: str) -> None:
    """With nothing named, and with joints that a loop determines, positions and speeds."""
    plain, solved = models(name)[0], closed_form(name)
    q = named(places(name), case)
    first = plain.split(plain.initial(q))[0]
    moving = plain.close_velocity(first, np.ones(plain.nu))[: plain.nu]
    follower = next(j["solved"]["u"][0] for j in solved.manifest["joints"] if j["solved"])
    given = dict(zip(plain.speeds, moving.tolist(), strict=True))
    # speeds that fit stand where the position is named as a whole
    some = [{}, given, {follower: given[follower]}] if case == "all" else [{}]
    for u in some[: 3 if solved.nu == 1 else 2]:
        one, other = started(plain, q, u), started(solved, q, u)
        assert isinstance(one, dict), one
        assert isinstance(other, dict), other
        for entry, value in other.items():
            assert one[entry] == pytest.approx(value, abs=NEAREST), entry
    CLOSED_FORMS[name, case] = len(q)


CLOSED_FORMS: dict[tuple[str, str], int] = {}


@functools.cache
def closed_form(name: str) -> cd.CompiledModel:
    return cd.compile(CLOSED[name].build(), constraints="closed_form")


def test_enough_closed_forms_were_compared() -> None:
    shown = [CLOSED_FORMS.get(("slider_crank", case)) for case in CASES]
    print("closed forms compared:", CLOSED_FORMS)
    assert None not in shown or shown == [None] * len(CASES)


@pytest.mark.parametrize(
    ("q", "u", "said"),
    [
        ({"A": 1.1, "guide": 0.5}, {}, "'C' closes gives 0.331816"),
        ({"guide": 0.7}, {}, "'C' closes gives"),
        ({"A": 1.1}, {"A": 1.0, "B": 5.0}, "speeds of 'B' are inconsistent"),
        ({"A": 1.1, "B": (1.0, 2.0)}, {}, "2 values, expected 1"),
    ],
)
def test_b13_values_that_do_not_fit_are_refused(q: Any, u: Any, said: str) -> None:
    """What loops in closed form determine was refused whether it fitted or not."""
    with pytest.raises(cd.CardanError, match=said):
        closed_form("slider_crank").initial(q, u)


def test_searches_begin_where_bent_beams_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """With all joints named nothing is moved that a beam be strained less: none is sought."""
    scene = cd.Scene("sprung", gravity=(0, 0, -9.81))
    arm = scene.body("arm", mass=1.0, com=(0.25, 0, 0), inertia=(0.01, 0.02, 0.02))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm)
    scene.force("spring", cd.JointSpring("hinge", 80.0))
    section = cd.section.general(EA=2e3, GA=1e3, GJ=1.5, EI=2.0, rhoA=1.0, rhoI=1e-3)
    scene.beam("beam", arm.at(0.5, 0, 0), (0.8, 0, 0), section, elements=2, up="z")
    model = cd.compile(scene, coordinates="absolute")
    rest = model.equilibrium()
    places = {row["name"]: row["q"] for row in model.manifest["joints"]}
    q = {n: rest.q[a : a + size] for n, (a, size) in places.items() if n != "arm"}
    assert len(q) == 3

    def search(*_: object) -> None:
        raise AssertionError("joints are sought that are all named")

    monkeypatch.setattr(finite_element_start, "assembled", search)
    again = model.equilibrium(q=q)
    assert again.iterations <= 2
    np.testing.assert_allclose(again.q, rest.q, rtol=0, atol=1e-9)
