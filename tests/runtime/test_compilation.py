"""Scenes that were compiled before: what is used again, and what makes a scene another."""

from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan import pipeline
from cardan.errors import NoteOnFiles
from cardan.scene.content import content_hash
from cardan.scene.files.yaml import layout
from cardan.schema.seal import sealed, unsealed
from cardan.version import RUN as VERSIONS
from mechanisms import ZOO
from table import each

Change = Callable[[cd.Scene], object]


@pytest.fixture
def derivations(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the scenes whose equations are derived."""
    names: list[str] = []
    derived = pipeline.compile_scene

    def counted(scene: Any, *arguments: Any, **options: Any) -> cd.CompiledModel:
        names.append(scene.name)
        return derived(scene, *arguments, **options)

    monkeypatch.setattr(pipeline, "compile_scene", counted)
    return names


def pendulum(mass: float = 1.0) -> cd.Scene:
    """A rod and a bob on it, a spring with a measured law, an input and an output."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    length, push = scene.parameter("l", 0.5, "m"), scene.input("push")
    rod = scene.body("rod", mass=mass, com=(0, 0, -length / 2), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod, q0=0.1)
    law = cd.table([-2.0, 0.0, 2.0], [-1.0, 0.0, 1.5])
    scene.force("spring", cd.JointForce("pivot", push - law(scene.q("pivot"))))
    scene.output("height", rod.at(0, 0, -length, name="tip").position()[2], "m")
    return scene


def test_an_equal_scene_is_not_derived_again(cache_directory: Path, derivations: list[str]) -> None:
    first = cd.compile(pendulum())
    value = first.forward_dynamics([0.3], [0.1])
    again = cd.compile(pendulum())
    assert again.directory == first.directory
    assert derivations == ["pendulum"]
    assert np.array_equal(again.forward_dynamics([0.3], [0.1]), value)
    assert again.manifest == first.manifest


def test_functions_that_nobody_called_are_derived_of_the_scene_as_it_was(
    cache_directory: Path, derivations: list[str]
) -> None:
    cd.compile(pendulum())
    scene = pendulum()
    model = cd.compile(scene)
    scene.body("ballast", mass=5.0)
    scene.joint("clamp", cd.Fixed(), scene.bodies["rod"], "ballast")
    assert derivations == ["pendulum"]
    mass = model.mass_matrix([0.3])
    assert derivations == ["pendulum"] * 2
    # inertia about the hinge of the rod, m = 1 kg at l/2 = 0.25 m, without the ballast
    assert mass.item() == pytest.approx(0.1 + 0.25**2, rel=1e-14)


def wing() -> cd.Scene:
    """A beam on a hinge."""
    scene = cd.Scene("wing")
    hub = scene.body("hub", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    section, steel = cd.section.rectangle(0.1, 0.02), cd.material(2e11, 0.3, rho=7800)
    scene.beam("blade", hub, (1, 0, 0), section, steel, elements=2)
    return scene


def test_nothing_that_a_scene_refers_to_changes_what_was_compiled(cache_directory: Path) -> None:
    """Nodes of a beam stand in the beam; so do numbers of arrays in what has them."""
    expected = cd.compile(wing())
    x = expected.random_state(0)
    scene = wing()
    model = cd.compile(scene)
    scene.beams["blade"].at(0.25, name="sensor")
    gradients = model.derivative("energy", wrt=("q", "u"))(*model.split(x))
    others = expected.derivative("energy", wrt=("q", "u"))(*expected.split(x))
    assert [one.tobytes() for one in gradients] == [one.tobytes() for one in others]
    # with the node it is another one
    assert len(cd.compile(scene).bodies) > len(model.bodies)


def test_a_copy_of_a_scene_is_equal_and_independent() -> None:
    """For every joint, force and element of the zoo."""
    for name, mechanism in ZOO.items():
        scene = mechanism.build()
        before = content_hash(scene)
        assert before is not None, name
        other = copy.deepcopy(scene)
        assert content_hash(other) == before, name
        for body in other.bodies.values():
            object.__setattr__(body, "mass", 17)
        assert content_hash(scene) == before, name
        assert not other.bodies or content_hash(other) != before, name


def test_a_function_that_was_not_asked_for_is_refused(cache_directory: Path) -> None:
    for _ in range(2):
        model = cd.compile(pendulum(), functions=["bias"])
        model.bias([0.3], [0.1])
        with pytest.raises(cd.DerivationError, match="mass_matrix"):
            model.mass_matrix([0.3])
    # the same folder, and more of it
    assert cd.compile(pendulum()).mass_matrix([0.3]).shape == (1, 1)


def test_damage_is_mended(cache_directory: Path, derivations: list[str]) -> None:
    model = cd.compile(pendulum())
    value = model.forward_dynamics([0.3], [0.1])
    file = model.directory / "forward_dynamics.c"
    text = file.read_text()
    file.write_text(text.replace("*", "+", 1))
    again = cd.compile(pendulum())
    assert np.array_equal(again.forward_dynamics([0.3], [0.1]), value)
    assert file.read_text() == text
    assert len(derivations) == 2


@each("changes", [{"folder": "../other"}, {"folder": 3}, {"folder": "00"}, {"more": 1},
                  {"available": {"energy": 1}}, {"available": "energy"}, {"available": 3},
                  {"statement": 1}, {"statement": None}, {"statement": "0" * 64}])  # fmt: skip
def test_an_entry_of_the_cache_is_not_believed(
    changes: dict[str, object], cache_directory: Path, derivations: list[str]
) -> None:
    """With the hash of its new content."""
    cd.compile(pendulum())
    (entry,) = (cache_directory / "models").glob("*.json")
    data = unsealed(entry.read_bytes(), by_hand=False)
    entry.write_text(sealed({**data, **changes}))
    derivations.clear()
    cd.compile(pendulum()).forward_dynamics([0.3], [0.1])
    assert derivations == ["pendulum"]


def test_a_damaged_byte_of_the_cache_is_not_believed(
    cache_directory: Path, derivations: list[str]
) -> None:
    """Digits, letters and marks of the entry and the manifest, those of their hashes too."""
    model = cd.compile(pendulum())
    model.forward_dynamics([0.3], [0.1])
    values = model.parameters.vector.copy()
    (entry,) = (cache_directory / "models").glob("*.json")
    folder = entry.parent / unsealed(entry.read_bytes())["folder"]
    whole = {path: path.read_bytes() for path in (entry, *folder.iterdir())}
    for damaged in (entry, folder / "manifest.json"):
        content = whole[damaged]
        head, step = 110, len(content) // 60
        for place in (*range(2, head, 4), *range(head, len(content), step)):
            byte = content[place]
            other = ord("0") + (byte + 1) % 10 if chr(byte).isdigit() else byte ^ 1
            damaged.write_bytes(content[:place] + bytes([other]) + content[place + 1 :])
            derivations.clear()
            model = cd.compile(pendulum())
            assert derivations == ["pendulum"], content[place - 20 : place + 20]
            assert np.array_equal(model.parameters.vector, values)
            for path in {*folder.iterdir()} - whole.keys():
                path.unlink()
            for path, text in whole.items():
                if not path.exists() or path.read_bytes() != text:
                    path.write_bytes(text)


@each("changes", [{"parameters": -9.81}, {"name": "other"}, {"cut": True}, {"unsealed": True}])
def test_a_manifest_that_was_not_written_of_the_scene_is_made_anew(
    changes: dict[str, Any], cache_directory: Path, derivations: list[str]
) -> None:
    """One that is whole in itself, but says something else; or that has lost its hash."""
    value = cd.compile(pendulum()).forward_dynamics([0.3], [0.1])
    (entry,) = (cache_directory / "models").glob("*.json")
    path = entry.parent / unsealed(entry.read_bytes())["folder"] / "manifest.json"
    data = unsealed(path.read_bytes())
    if "parameters" in changes:
        for row in data["parameters"]:
            row["default"] = -1.62 if row["default"] == changes["parameters"] else row["default"]
    elif "name" in changes:
        data |= changes
    elif "cut" in changes:
        data["quaternions"] = [0]
    path.write_text(json.dumps(data) if "unsealed" in changes else sealed(data))
    derivations.clear()
    again = cd.compile(pendulum())
    assert derivations == ["pendulum"]
    assert np.array_equal(again.forward_dynamics([0.3], [0.1]), value)
    # and it is whole from then on
    derivations.clear()
    assert np.array_equal(cd.compile(pendulum()).forward_dynamics([0.3], [0.1]), value)
    assert not derivations


def test_a_model_that_was_pruned_is_derived_again(
    cache_directory: Path, derivations: list[str]
) -> None:
    from cardan.runtime.build.prune import content, prune

    cd.compile(pendulum())
    assert content(cache_directory).models == 1
    prune(cache_directory, 0)
    assert not [*(cache_directory / "models").iterdir()]
    cd.compile(pendulum())
    assert derivations == ["pendulum"] * 2


def test_a_warning_is_given_every_time(cache_directory: Path, derivations: list[str]) -> None:
    for _ in range(3):
        scene = pendulum()
        ends = scene.ground, scene.bodies["rod"]
        scene.force("meeting", cd.SpringDamper(*ends, stiffness=1.0, rest_length=0.1))
        with pytest.warns(cd.ModelWarning, match="meeting"):
            cd.compile(scene)
    assert len(derivations) == 3


def test_a_loop_that_cannot_close_is_said_every_time(cache_directory: Path) -> None:
    def chain(reach: float) -> cd.Scene:
        scene = cd.Scene("chain")
        point = scene.ground.at(0, 0, 0)
        for k in range(3):
            link = scene.body(f"link{k}", mass=1, inertia=(0.1, 0.1, 0.1))
            scene.joint(f"pin{k}", cd.Revolute("y"), point, link)
            point = link.at(0.1, 0, 0)
        scene.joint("end", cd.Revolute("y"), scene.ground.at(reach, 0, 0), point)
        return scene

    for _ in range(3):
        with pytest.warns(cd.SolveWarning, match="stays open"):
            cd.compile(chain(5.0))
    for _ in range(2):
        cd.compile(chain(0.2))
    (folder,) = [one.parent for one in cache_directory.glob("models/*/closes")]
    assert "0.2" in (folder / "manifest.json").read_text("utf-8")


CHANGES: dict[str, Change] = {
    "a last bit": lambda scene: scene.values.update(l=np.nextafter(0.5, 1)),
    "a parameter": lambda scene: scene.parameter("k", 1.0),
    "a body": lambda scene: scene.body("more", mass=1),
    "gravity": lambda scene: setattr(scene, "gravity", (0, 0, -9.8)),
    "another kind of number": lambda scene: setattr(scene, "gravity", (0.0, 0, -9.81)),
    "a name": lambda scene: setattr(scene, "name", "pendulum2"),
    "an output": lambda scene: scene.output("angle", scene.q("pivot")),
    "a table": lambda scene: scene.output("law", cd.table([0, 1], [0, 1])(scene.q("pivot"))),
    "another table": lambda scene: scene.output("law", cd.table([0, 1], [0, 2])(scene.q("pivot"))),
    "its slope": lambda scene: scene.output(
        "law", cd.table([0, 1], [0, 2])(scene.q("pivot")).diff(scene.q("pivot"))
    ),
    "a real symbol": lambda scene: scene.output("x", sympy.Symbol("l", real=True)),
    "a symbol": lambda scene: scene.output("x", sympy.Symbol("l")),
    "an exact number": lambda scene: scene.output("x", sympy.Rational(1, 2)),
    "a float of it": lambda scene: scene.output("x", sympy.Float(0.5)),
    "more digits of it": lambda scene: scene.output("x", sympy.Float("0.5", 40)),
    "an array": lambda scene: scene.settings.update(t_eval=np.array([0.0, 1.0])),
    "its precision": lambda scene: scene.settings.update(t_eval=np.array([0.0, 1.0], np.float32)),
    "its shape": lambda scene: scene.settings.update(t_eval=np.array([[0.0, 1.0]])),
    "texts that join alike": lambda scene: scene.notes.extend(["ab", "c"]),
    "others": lambda scene: scene.notes.extend(["a", "bc"]),
}


def test_whatever_is_changed_makes_another_scene() -> None:
    hashes = {"none": content_hash(pendulum())}
    for name, change in CHANGES.items():
        scene = pendulum()
        change(scene)
        hashes[name] = content_hash(scene)
    assert None not in hashes.values()
    assert len({*hashes.values()}) == len(hashes), hashes
    assert content_hash(pendulum()) == hashes["none"]


def test_every_attribute_counts() -> None:
    """Records of a scene, each with one attribute after the other replaced."""
    scene, before = pendulum(), content_hash(pendulum())
    count = 0
    for table in (scene.bodies, scene.joints, scene.forces, scene.outputs, scene.parameters):
        (record, *_) = table.values()
        for name, value in vars(record).items():
            if value is not scene:
                object.__setattr__(record, name, ("another", value))
                assert content_hash(scene) != before, (record, name)
                object.__setattr__(record, name, value)
                count += 1
    assert count > 25
    assert content_hash(scene) == before


@each(
    "one, other",
    [
        (NoteOnFiles("a"), NoteOnFiles("b")),
        (layout.Number("1"), layout.Number("2")),
        (layout.Row([1]), layout.Row([2])),
        (layout.Flow(a=1), layout.Flow(a=2)),
        (VERSIONS, VERSIONS._replace(word="others")),
    ],
)
def test_classes_derived_of_built_in_ones_show_what_they_hold(one: object, other: object) -> None:
    assert type(one) is type(other)
    assert content_hash(one) == content_hash(copy.deepcopy(one))
    assert content_hash(one) != content_hash(other)


class Heavier(cd.JointForce):
    """Of a user: nobody knows what it says."""


@each(
    "part",
    [
        lambda: 1,
        sympy.Function("f")(sympy.Symbol("x")),
        sympy.Dummy("x"),
        Heavier("pivot", 1.0),
        object(),
        np.array([object()]),
        type(cd.table([0, 1], [0, 1])(sympy.Symbol("x"))),
    ],
)
def test_what_may_hold_more_than_it_shows_has_no_hash(part: object) -> None:
    assert content_hash({"a": [1, part]}) is None


def test_long_numbers_have_hashes() -> None:
    """Python writes no numbers of more than 4300 digits in decimals."""
    longest = [10**5000, 10**5000 + 1, Fraction(1, 10**5000), -(10**5000), 1, True, Fraction(1)]
    assert len({content_hash(number) for number in longest} - {None}) == len(longest)


def test_hashes_are_those_of_other_processes() -> None:
    script = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from runtime.test_compilation import content_hash, pendulum\n"
        "import cardan as cd\n"
        "print(content_hash(pendulum(), {'b', 'a', 'c'}), content_hash(cd.examples['trolley']))\n"
    )
    tests = str(Path(__file__).parents[1])
    lines = {
        subprocess.run(
            [sys.executable, "-c", script, tests],
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("1", "2")
    }
    (line,) = lines
    assert "None" not in line
