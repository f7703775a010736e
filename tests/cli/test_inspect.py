"""``cardan inspect``: on the screen, as a page, as JSON; names cannot break out of any of them."""

from __future__ import annotations

import json
import math
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

import cardan as cd
from cardan.cli import main
from cardan.explain import document, facts
from cardan.explain.writers.html import page
from equations.classical import CLASSICAL
from mechanisms.chain import chain

ARM = Path(__file__).parents[2] / "examples" / "arm.urdf"
VOID = {"meta", "mspace", "br", "wbr"}
HOSTILE = "</title><script>alert(1)</script><img src=x onerror=a()>&\"'[bold]"


class Reader(HTMLParser):
    """Counts tags and checks that they nest."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: dict[str, int] = {}
        self.text = ""

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.tags[tag] = self.tags.get(tag, 0) + 1
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: object) -> None:
        self.tags[tag] = self.tags.get(tag, 0) + 1

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    assert not reader.open
    return reader


def written(scene: cd.Scene) -> str:
    return page(document(cd.derive(scene)))


def test_on_the_screen(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inspect", str(ARM)]) == 0
    found = capsys.readouterr()
    for said in (
        "[elbow: revolute]",
        "forearm.mass",
        "kg\u00a0m²",
        "M[shoulder, elbow] = ",
        "f[waist] = -waist.damping*waist.u    from waist.damping",
        "'elbow.damping' takes energy",
        "SOURCES",
        "OPERATIONS",
    ):
        assert said in found.out
    assert "note: " in found.err
    assert "note: " not in found.out


def test_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inspect", str(ARM), "--json", "--method", "kane"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["method"] == "kane"
    assert [c["name"] for c in found["coordinates"]] == ["waist", "shoulder", "elbow"]
    hand = next(frame for frame in found["frames"] if frame["name"] == "hand")
    assert (hand["body"], hand["part"]) == ("forearm", "hand")
    assert hand["position"] == pytest.approx([0.3, 0, 0])
    assert hand["rotation"][0] == pytest.approx([math.cos(0.5), -math.sin(0.5), 0])
    assert {p["name"]: p["unit"] for p in found["parameters"]}["hand.mass"] == "kg"
    for counts in found["operations"].values():
        assert counts["total"] == sum(counts["operators"].values())
        assert counts["total"] == sum(sum(own.values()) for own in counts["blocks"].values())


def test_a_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["inspect", str(ARM), "-o", "out/arm.html"]) == 0
    assert "wrote out/arm.html" in capsys.readouterr().out
    text = (tmp_path / "out" / "arm.html").read_text(encoding="utf-8")
    found = read(text)
    assert found.tags["svg"] == 1
    assert found.tags["math"] > 3
    # self-contained: no script, nothing fetched
    assert "script" not in found.tags
    assert not re.search(r"(src|href)=", text)
    assert "https://" not in text
    assert all(name in found.text for name in ("waist", "forearm.inertia.xz", "Featherstone"))


@pytest.mark.parametrize("name", CLASSICAL)
def test_pages_of_classical_systems(name: str) -> None:
    found = read(written(CLASSICAL[name].scene()))
    assert "too long" not in found.text
    assert found.tags["math"] >= 2


def test_large_systems_are_folded_or_counted() -> None:
    text = written(chain(12))
    found = read(text)
    assert "named intermediates: equations.symbolic('bias') has them" in found.text
    assert "Written out it has" in found.text
    assert len(text) < 1_000_000


def hostile() -> cd.Scene:
    scene = cd.Scene(HOSTILE, gravity=(0, 0, -9.81))
    mass = scene.parameter(f"m{HOSTILE}", 1.0, unit="kg")
    body = scene.body(f"b{HOSTILE}", mass=mass, com=(0, 0, -1.0), inertia=(1.0, 1.0, 1.0))
    scene.joint(f"j{HOSTILE}", cd.Revolute("y"), scene.ground, body)
    scene.input(f"r{HOSTILE}")
    scene.notes.append(HOSTILE)
    return scene


def test_names_stay_names() -> None:
    scene = hostile()
    plain = written(CLASSICAL["spherical"].scene())
    text = written(scene)
    assert "<script" not in text
    assert "<img" not in text
    assert set(read(text).tags) <= set(read(plain).tags) | {"msub", "msubsup"}
    assert HOSTILE in read(text).text
    json.dumps(facts(cd.derive(scene)))


def test_names_stay_names_on_the_screen(capsys: pytest.CaptureFixture[str]) -> None:
    from cardan.cli.inspect import display
    from cardan.cli.terminal import console

    scene = hostile()
    equations = cd.derive(scene)
    display(scene, str(equations), document(equations), console())
    # no markup of the terminal is read from names
    assert "[bold]" in capsys.readouterr().out


def test_unknown_method(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inspect", str(ARM), "--method", "aba"]) == 1
    assert "'aba' is called 'articulated' here" in capsys.readouterr().err
