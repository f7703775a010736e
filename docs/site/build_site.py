"""Builds the documentation site: collects pages, writes the generated ones, and runs Sphinx.

``python docs/site/build_site.py [FOLDER]``, or ``make site``, writes ``out/site``; nothing is
fetched. The pages of ``docs`` stay as a repository host shows them: links to what has another
place in the site are changed in the copies.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
DOCS = ROOT / "docs"
sys.path[:0] = [str(HERE), str(ROOT / "tests")]

# chapters of the guide: every page of ``docs`` stands in one of them
GUIDE: dict[str, tuple[str, ...]] = {
    "Scenes": (
        *("scene_files", "robot_files", "forces", "space", "flexible", "superelements"),
        *("parts", "sympy", "cassie"),
    ),
    "Equations": (
        *("conventions", "reading_equations", "formalisms", "closed_loops", "coordinates"),
        *("linear_models", "derivatives", "gradients"),
    ),
    "Models and runs": (
        *("functions", "integrators", "events", "ensembles", "pictures", "live"),
        *("exchange", "exports", "fmu"),
    ),
    "Analyses": ("statics_and_modes", "branches", "cycles", "identification"),
    "Trust": ("verification", "hard_cases", "what_goes_with_what", "security"),
    "Books": ("companions/index", "problems/index"),
    "The project": ("building", "architecture", "contributing", "performance/index"),
}
FOLDER = "\n```{toctree}\n:hidden:\n:glob:\n\n*\n```\n"
LINK = re.compile(r"(?P<image>!?)\[(?P<text>[^\]]*)\]\((?P<target>[^)\s]+)\)")


def pages() -> Iterator[tuple[Path, str]]:
    """Written pages: file, and place in the site without its ending."""
    for path in sorted(DOCS.rglob("*.md")):
        place = path.relative_to(DOCS).with_suffix("").as_posix()
        if place == "README" or place.startswith("site/"):
            continue
        yield path, place.removesuffix("README") + "index" * place.endswith("README")
    for path in sorted(HERE.glob("*.md")):
        yield path, path.stem
    yield ROOT / "CONTRIBUTING.md", "contributing"


def mended(text: str, path: Path, place: str) -> str:
    """A page whose links lead to where things are in the site."""
    places = {file.resolve(): there for file, there in pages()}
    places[DOCS / "README.md"] = "index"

    def changed(match: re.Match[str]) -> str:
        link, mark, anchor = match["target"].partition("#")
        if match["image"] or not link or "://" in link:
            return match[0]
        target = Path(os.path.normpath(path.parent / link))
        if target.is_dir() and (target / "README.md").exists():
            target /= "README.md"
        if target in places:
            there = f"{places[target]}.md"
        elif target == ROOT / "examples":
            there = "gallery/index.md"
        elif target.parent == ROOT / "examples" and target.suffix in {".py", ".ipynb"}:
            there = f"gallery/{target.stem}.md".replace("05_notebook.md", "05_notebook.ipynb")
        elif DOCS not in target.parents and target.exists():
            return match["text"]  # programs and tests of the repository
        else:
            return match[0]
        leads = os.path.relpath(there, Path(place).parent.as_posix()) + mark + anchor
        return f"[{match['text']}]({leads})"

    return LINK.sub(changed, text)


def collect(source: Path) -> None:
    """Copy written pages and what they show."""
    for path, place in pages():
        target = source / f"{place}.md"
        target.parent.mkdir(parents=True, exist_ok=True)
        text = mended(path.read_text(encoding="utf-8"), path, place)
        # the first page of a folder leads to the others
        if place.endswith("/index"):
            below = "\n*/*" if any(path.parent.glob("*/*.md")) else ""
            text += FOLDER.replace("*", f"*{below}")
        target.write_text(text, encoding="utf-8")
    for path in DOCS.rglob("*"):
        if path.suffix in {".svg", ".png", ".json", ".yaml"} and HERE not in path.parents:
            target = source / path.relative_to(DOCS)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)
    shutil.copytree(HERE / "static", source / "_static")
    for path in DOCS.glob("companions/**/*.ipynb"):
        shutil.copy(path, source / path.relative_to(DOCS))


def write_guide(source: Path) -> None:
    """The page of the guide with its chapters, and of folders that have no first page."""
    books = source / "companions" / "index.md"
    if not books.exists():
        listed = FOLDER.replace(":hidden:\n", "").replace("*\n", "*\n*/*\n")
        books.write_text(f"# Companions to two books\n{listed}", encoding="utf-8")
    chapters = [
        f"## {title}\n\n```{{toctree}}\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n"
        for title, names in GUIDE.items()
    ]
    (source / "guide.md").write_text("# User guide\n\n" + "\n".join(chapters), encoding="utf-8")


def generate(source: Path, cache: Path) -> None:
    """Write the pages that come from the code and from runs."""
    import cheat_sheet
    import gallery
    import reference
    import theory
    import words

    write_guide(source)
    reference.write(source / "reference")
    theory.write(source / "theory")
    cheat_sheet.write(source / "_static" / "cheat_sheet.html")
    gallery.write(source / "gallery", source / "_static" / "gallery", cache)
    words.add_entries(source)


def build(target: Path, *options: str) -> int:
    """Build the site; warnings are errors.

    Args:
        target: Folder of the site. Beside it stand its sources and what examples left.
        options: Further arguments of ``sphinx-build``.
    """
    source, cache = target.with_name(f"{target.name}_source"), target.with_name("gallery")
    for folder in (source, target):
        shutil.rmtree(folder, ignore_errors=True)
    source.mkdir(parents=True)
    collect(source)
    generate(source, cache)
    from sphinx.cmd.build import main

    trees = target.with_name(f"{target.name}_trees")
    static = f"-Dhtml_static_path={source / '_static'}"
    checked = ("-W", "--keep-going", "-q", "-E")
    folders = ("-c", str(HERE), "-d", str(trees), str(source), str(target))
    return main([*checked, static, *options, *folders])


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "out" / "site"
    sys.exit(build(folder.resolve()))
