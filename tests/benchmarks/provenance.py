"""Pages of measurements name the machine and the source, and say when the code has changed since.

``python tests/benchmarks/provenance.py`` adds that sentence, below the title, to the pages that are
older.
"""

from __future__ import annotations

import hashlib
import platform
import re
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src" / "cardan"
DOCS = ROOT / "docs"
# what the figures do not depend on
APART = ("cli", "view", "explain")
KINDS = (".py", ".pyx", ".pxi", ".pxd", ".c", ".h")
MEASURED = re.compile(r"\nMeasured .*with the source of fingerprint `([0-9a-f]{12})`\.\n")
# whose versions are named where they are installed
PACKAGES = (
    "numpy", "scipy", "sympy", "brax", "casadi", "drake", "exudyn", "jax", "mujoco", "mujoco-mjx",
    "pin", "pydy", "scikit-sundae",
)  # fmt: skip
OLDER = (
    "**Measured with an earlier version of the code: steps, errors and times may differ now. "
    "`make hard` (this takes a quarter of an hour) and `make bench` measure them anew.**"
)


def pages() -> list[Path]:
    """Pages whose figures are measured."""
    return [*sorted((DOCS / "performance").glob("*.md")), *DOCS.glob("hard_cases.md")]


def fingerprint() -> str:
    """Hash of the C and Python of the package whose speed and error the pages show."""
    digest = hashlib.sha256()
    for path in sorted(SOURCE.rglob("*")):
        place = path.relative_to(SOURCE)
        if path.suffix in KINDS and place.parts[0] not in APART:
            # the compiled wrapper as Cython writes it
            if path.name == "_abi.c":
                continue
            digest.update(f"{place.as_posix()}\0".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


def signed(text: str) -> str:
    """A page that was measured now."""
    source = f"with the source of fingerprint `{fingerprint()}`"
    return f"{text.rstrip()}\n\nMeasured on {machine()}, {source}.\n"


def machine() -> str:
    """Processor, compiler, and versions of what takes part."""
    from cardan.peers.processor import name
    from cardan.runtime.build import cache

    found = [name(), platform.system(), f"Python {platform.python_version()}"]
    found.append(cache.compiler().identity.splitlines()[0])
    for package in PACKAGES:
        with suppress(PackageNotFoundError):
            found.append(f"{package} {version(package)}")
    return ", ".join(found)


def current(text: str) -> bool:
    """The page shows the source as it is, or says that it does not."""
    found = MEASURED.search(text)
    return OLDER in text or (found is not None and found[1] == fingerprint())


def mark() -> list[str]:
    """Say of pages that are older than the source that they are; their names."""
    older = []
    for page in pages():
        text = page.read_text("utf-8")
        if not current(text):
            title, _, rest = text.partition("\n")
            page.write_text(f"{title}\n\n{OLDER}\n{rest}", "utf-8")
            older.append(page.name)
    return older


if __name__ == "__main__":
    print(*(mark() or ["every page is current, or says that it is older"]), sep="\n")
