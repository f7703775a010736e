"""The page of the parts from their docstrings and scenes: ``python tests/parts/page.py``.

What stands above the first part is written by hand and stays.
"""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import numpy as np

from cardan.parts import PARTS

PAGE = Path(__file__).parents[2] / "docs" / "parts.md"
BEGIN = "<!-- from here on by tests/parts/page.py -->\n"
UNIT = re.compile(r" ?\[[^\]]*\]\.?$")


def written() -> str:
    """The page as it should be."""
    head = PAGE.read_text("utf-8").partition(BEGIN)[0]
    return head + BEGIN + "".join(map(section, PARTS))


def section(name: str) -> str:
    """Picture, description and parameters of a part."""
    text = inspect.getdoc(PARTS[name]) or ""
    said, _, below = text.partition("\n\nArgs:\n")
    summary, _, body = said.partition("\n\n")
    source = " ".join(below.partition("Source: ")[2].split())
    returned = " ".join(re.findall(r"Returns:\n(.*?)\n\n", below, re.DOTALL)[0].split())
    lines = [
        f"\n## {name}\n",
        f"![{name}](parts_{name}.png)\n",
        f"{plain(summary)}\n",
        f"{plain(body)}\n",
        f"Returns: {plain(returned[0].lower() + returned[1:])}\n",
        "| argument | default | unit | |",
        "|---|---|---|---|",
        *rows(name, below),
        f"\nSource: {source}\n",
    ]
    return "\n".join(lines)


def plain(text: str) -> str:
    """A docstring as Markdown, each paragraph on its lines."""
    return text.replace("``", "`")


def rows(name: str, below: str) -> list[str]:
    """A row for every argument."""
    scene = PARTS[name]()
    listed = below.partition("\n\n")[0]
    pattern = r"^    ([\w, ]+): (.*?)(?=^    \w|\Z)"
    found = []
    texts = {
        word.strip(): UNIT.sub("", " ".join(said.split()).rstrip(".")).rstrip(".")
        for words, said in re.findall(pattern, listed, re.DOTALL | re.MULTILINE)
        for word in words.split(",")
    }
    for argument in inspect.signature(PARTS[name]).parameters.values():
        default = argument.default
        many = np.size(default) > 1
        label = f"{argument.name}.x" if many else argument.name
        unit = scene.parameters[label].unit if label in scene.parameters else ""
        shown = ", ".join(f"{x:g}" for x in default) if many else f"{default}"
        if isinstance(default, float):
            shown = f"{default:g}"
        said = plain(texts[argument.name])
        found.append(f"| `{argument.name}` | {shown} | {unit} | {said} |")
    return found


if __name__ == "__main__":
    PAGE.write_text(written(), "utf-8")
