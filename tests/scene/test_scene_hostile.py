"""Files that no scene can be: every one is refused with its place, its culprit and its cure."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import cardan as cd
from table import each

FILES = sorted((Path(__file__).parent / "hostile").glob("*.yaml"))


@each("path", FILES)
def test_refused(path: Path) -> None:
    """The first line of the file says the words of the error."""
    first = path.read_text(encoding="utf-8").splitlines()[0]
    words = first.removeprefix("# refused: ")
    assert words != first
    with pytest.raises((cd.ModelError, cd.TopologyError)) as caught:
        cd.load(path)
    message = str(caught.value)
    assert words in message
    # file, line and column in front; some texts are refused before lines are known
    assert re.match(rf"{path.name}:\d+:\d+: |file '{path.name}' is not YAML", message)
    assert len(message) < 700


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "file 'scene.yaml' is empty; a scene begins with 'cardan: 2'"),
        (b"# nothing\n", "is empty"),
        (b"\xef\xbb\xbf  \n", "is empty"),
        (b"cardan: 2\nname: \xff\xfe\n", "scene.yaml:2: byte 16 is not UTF-8"),
        (bytes(range(256)) * 8, "scene.yaml"),
        ("cardan: 2\n".encode("utf-16"), "not UTF-8"),
        (b"\x7fELF\x02\x01\x01\x00", "scene.yaml"),
        (b"#" + b" " * (9 * 2**20), "has 9 MiB; a scene has at most 8 MiB"),
        (b"cardan: 2\n" + b"- " * 2**20, "scene.yaml:2"),
    ],
    ids=lambda value: repr(value[:12]),
)
def test_bytes_that_are_no_scene(content: bytes, words: str, tmp_path: Path) -> None:
    path = tmp_path / "scene.yaml"
    path.write_bytes(content)
    with pytest.raises(cd.ModelError, match=re.escape(words)):
        cd.load(path)


def test_a_folder_and_a_missing_file_are_no_scenes(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").mkdir()
    for name in ("a.yaml", "b.yaml"):
        with pytest.raises(cd.ModelError, match=rf"'{name}' cannot be read"):
            cd.load(tmp_path / name)


def test_a_link_does_not_lead_out(tmp_path: Path) -> None:
    secret = tmp_path / "secret.yaml"
    secret.write_text("cardan: 2\n")
    inside = tmp_path / "inside"
    inside.mkdir()
    (inside / "link.yaml").symlink_to(secret)
    scene = inside / "scene.yaml"
    scene.write_text("cardan: 2\ninclude: {a: {file: link.yaml}}\n")
    with pytest.raises(cd.ModelError, match="there is no file 'link"):
        cd.load(scene)


@pytest.mark.parametrize("option", [{"base": "free"}, {"mimic": "free"}])
def test_options_of_robots_are_refused(option: dict[str, str], tmp_path: Path) -> None:
    path = tmp_path / "scene.yaml"
    path.write_text("cardan: 2\n")
    with pytest.raises(cd.ModelError, match="are for robots"):
        cd.load(path, **option)
