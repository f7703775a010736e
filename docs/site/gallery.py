"""The gallery: every example is run, and shown with its text, what it prints, page and pictures.

``python docs/site/gallery.py EXAMPLE`` runs one in the folder where it is called.
"""

from __future__ import annotations

import ast
import hashlib
import html
import json
import re
import runpy
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
TIME = "picture_time.txt"
MADE = "cardan_page.html"
PHOTO = "page.png"
CHROMIUM = ("chromium", "chromium-browser", "google-chrome", "chrome")
SHOT = (
    *("--headless", "--no-sandbox", "--hide-scrollbars", "--use-angle=swiftshader"),
    *("--enable-unsafe-swiftshader", "--force-prefers-reduced-motion", "--window-size=720,450"),
)


def examples() -> list[Path]:
    """Scripts and notebooks, in the order of reading."""
    return sorted([*EXAMPLES.glob("*.py"), *EXAMPLES.glob("*.ipynb")])


def browser() -> str | None:
    """Chromium where there is one."""
    return next(filter(None, map(shutil.which, CHROMIUM)), None)


@dataclass(frozen=True)
class Result:
    """One example that was run.

    Attributes:
        script: Its file.
        folder: What it wrote is here.
        printed: What it printed.
    """

    script: Path
    folder: Path
    printed: str

    @property
    def text(self) -> str:
        return self.script.read_text(encoding="utf-8")

    @property
    def documentation(self) -> list[str]:
        """Paragraphs of its docstring; the first is its title."""
        return (ast.get_docstring(ast.parse(self.text)) or "").split("\n\n")

    @property
    def title(self) -> str:
        return " ".join(self.documentation[0].split()).rstrip(".")

    def files(self, ending: str) -> list[Path]:
        return sorted(self.folder.rglob(f"*.{ending}"))


def run(script: Path, cache: Path) -> Result:
    """Run an example in an empty folder, unless the same one ran with the same cardan."""
    folder = cache / script.stem
    stamp = folder / "stamp"
    key = hashlib.sha256(script.read_bytes() + sources().encode()).hexdigest()
    if not stamp.exists() or stamp.read_text() != key:
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "files").mkdir(parents=True)
        command = [sys.executable, __file__, str(script)]
        done = subprocess.run(
            command, cwd=folder / "files", capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise RuntimeError(f"{script.name} failed:\n{done.stderr}")
        (folder / "printed.txt").write_text(done.stdout, encoding="utf-8")
        stamp.write_text(key)
    return Result(script, folder / "files", (folder / "printed.txt").read_text(encoding="utf-8"))


def sources() -> str:
    """Hash of everything that an example runs on."""
    digest = hashlib.sha256()
    for path in sorted((ROOT / "src" / "cardan").rglob("*")):
        if path.suffix in {".py", ".c", ".h", ".pyx", ".html", ".js"} and path.is_file():
            digest.update(path.read_bytes())
    return digest.hexdigest()


def _run_here(script: str) -> None:
    """Run an example; a motion without a page gets one, and a drawing stands in for pictures."""
    sys.argv = [script]  # some take a folder
    names = runpy.run_path(script, run_name="__main__")
    import cardan as cd

    motions = [x for x in names.values() if isinstance(x, cd.Trajectory)]
    if motions and not list(Path().rglob("*.html")):
        with suppress(cd.ModelError):  # equations of a user's own have no bodies to show
            motions[-1].animate(MADE)
    if motions:
        Path(TIME).write_text(f"{motions[-1].t[0] + 0.3 * (motions[-1].t[-1] - motions[-1].t[0])}")
        motions[-1].plot("drawn.svg")
    elif (scene := next((x for x in names.values() if isinstance(x, cd.Scene)), None)) is not None:
        Path("drawn.svg").write_text(scene.graph._repr_svg_(), encoding="utf-8")


def photograph(result: Result) -> Path | None:
    """Picture of the page of an example at one time; None without a page or without Chromium."""
    pages, program = result.files("html"), browser()
    if not pages or program is None:
        return None
    picture = result.folder.parent / PHOTO
    if not picture.exists():
        time = result.folder / TIME
        mark = f"#t={time.read_text() if time.exists() else 1}&bare"
        command = [program, *SHOT, f"--screenshot={picture}", pages[0].as_uri() + mark]
        for _ in range(2):  # a browser may hang, which the drawing stands in for
            with suppress(subprocess.SubprocessError):
                subprocess.run(command, capture_output=True, timeout=90, check=True)
                break
    return picture if picture.exists() else None


def pictures(result: Result) -> list[Path]:
    """Pictures, best first: that of the page, those that the example draws, a drawing."""
    photo = photograph(result)
    drawn = [path for ending in ("png", "svg") for path in result.files(ending)]
    made = [path for path in drawn if path.name != "drawn.svg"]
    return [photo] if photo else made[:1] or drawn[:1]


def write(folder: Path, static: Path, cache: Path) -> None:
    """Pages of all examples, and the page of cards; pages and pictures go to ``static``."""
    folder.mkdir(parents=True)
    static.mkdir(parents=True)
    cards = []
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda script: _result(script, cache), examples()))
    for script, result in zip(examples(), results, strict=True):
        if result is None:
            shutil.copy(script, folder)
            title, image = "A notebook: equations and a motion, cell by cell", f"{script.stem}.svg"
            (static / image).write_text(_stored_picture(script), encoding="utf-8")
        else:
            title, image = result.title, _show(result, folder, static)
        picture = f":img-top: ../_static/gallery/{image}\n:img-alt: {title}\n" if image else ""
        cards.append(
            f":::{{grid-item-card}} {title}\n:link: {script.stem}\n:link-type: doc\n{picture}:::\n"
        )
    listed = "\n".join(script.stem for script in examples())
    (folder / "index.md").write_text(
        f"# Gallery\n\n{LEAD}\n\n::::{{grid}} 1 2 3 3\n:gutter: 3\n\n{chr(10).join(cards)}::::\n\n"
        f"```{{toctree}}\n:hidden:\n\n{listed}\n```\n",
        encoding="utf-8",
    )


LEAD = (
    "Every example of the repository. Each was run when this site was built; its page plays what "
    "came out, and turns with the mouse."
)


def _result(script: Path, cache: Path) -> Result | None:
    """What a script left; of a notebook, whose outputs are stored, nothing."""
    if script.suffix != ".py":
        return None
    result = run(script, cache)
    photograph(result)
    return result


def _stored_picture(notebook: Path) -> str:
    """The first drawing among the stored outputs of a notebook."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    data = [output.get("data", {}) for cell in cells for output in cell.get("outputs", ())]
    texts = ("".join(lines) for one in data for lines in one.values())
    drawings = (re.search(r"<svg.*?</svg>", text, re.DOTALL) for text in texts)
    return next(filter(None, drawings))[0]


def _show(result: Result, folder: Path, static: Path) -> str | None:
    """Write the page of an example and copy what it shows; the name of its picture."""
    name = result.script.stem
    chosen = pictures(result)
    kept = [*chosen, *(path for path in result.files("png") if path not in chosen)]
    copies = {}
    for number, path in enumerate([*kept, *result.files("html")]):
        copies[path] = f"{name}-{number}{path.suffix}"
        shutil.copy(path, static / copies[path])
    lines = [f"# {result.title}", *result.documentation[1:], ""]
    for page in result.files("html"):
        lines += [
            "```{raw} html",
            f'<iframe class="motion" src="../_static/gallery/{copies[page]}" loading="lazy" '
            f'title="{html.escape(result.title)}"></iframe>',
            "```",
            "",
        ]
    lines += [
        f"![{result.title}](../_static/gallery/{copies[path]})\n"
        for path in kept
        if path.name != PHOTO
    ]
    lines += [
        "## Program",
        "",
        f"`examples/{result.script.name}`",
        "",
        "```python",
        result.text,
        "```",
        "",
    ]
    if result.printed.strip():
        lines += ["## Output", "", "```text", result.printed.rstrip(), "```", ""]
    (folder / f"{name}.md").write_text("\n".join(lines), encoding="utf-8")
    return copies[chosen[0]] if chosen else None


if __name__ == "__main__":
    _run_here(sys.argv[1])
