"""The pictures that programs of docs pages draw, beside their pages: ``docs/branches_*.svg``.

``python tests/examples/page_pictures.py`` writes them; the test of a page compares their labels.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

DOCS = Path(__file__).parents[2] / "docs"
DRAWING = ("branches",)


def programs(text: str) -> str:
    """The Python of a page."""
    return "\n".join(re.findall(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE))


def labels(picture: str) -> set[str]:
    """Texts of a picture by Matplotlib, which stand above their outlines as comments."""
    return set(re.findall(r"<!-- (.*?) -->", picture))


def write(page: Path) -> None:
    """Run a page and keep its pictures, without dates."""
    with TemporaryDirectory() as folder:
        Path(folder, "matplotlibrc").write_text("svg.hashsalt: cardan\n", "utf-8")
        text = programs(page.read_text("utf-8"))
        environment = {**os.environ, "MPLBACKEND": "svg"}
        subprocess.run([sys.executable, "-c", text], cwd=folder, check=True, env=environment)
        for file in sorted(Path(folder).glob("*.svg")):
            before, _, dated = file.read_text("utf-8").partition(" <metadata>")
            after = dated.partition("</metadata>\n")[2]
            DOCS.joinpath(file.name).write_text(before + after, "utf-8")


if __name__ == "__main__":
    for name in DRAWING:
        write(DOCS / f"{name}.md")
