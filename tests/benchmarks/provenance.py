"""Pages of measurements name the source that was measured and say when the code has changed since.

``python tests/benchmarks/provenance.py`` adds that sentence to the pages that are older.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src" / "cardan"
PAGES = ROOT / "docs" / "performance"
# what the figures do not depend on
APART = ("cli", "view", "explain")
MEASURED = re.compile(r"\nMeasured with the source of fingerprint `([0-9a-f]{12})`\.\n")
OLDER = "The code has changed since these figures were measured."


def fingerprint() -> str:
    """Hash of the C and Python of the package whose speed and error the pages show."""
    digest = hashlib.sha256()
    for path in sorted(SOURCE.rglob("*")):
        place = path.relative_to(SOURCE)
        if path.suffix in (".py", ".pyx", ".c", ".h") and place.parts[0] not in APART:
            if path.name == "_abi.c":
                continue
            digest.update(f"{place.as_posix()}\0".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


def signed(text: str) -> str:
    """A page that was measured now."""
    return f"{text.rstrip()}\n\nMeasured with the source of fingerprint `{fingerprint()}`.\n"


def current(text: str) -> bool:
    """The page shows the source as it is, or says that it does not."""
    found = MEASURED.search(text)
    return OLDER in text or (found is not None and found[1] == fingerprint())


def mark() -> list[str]:
    """Say of pages that are older than the source that they are; their names."""
    older = []
    for page in sorted(PAGES.glob("*.md")):
        text = page.read_text("utf-8")
        if not current(text):
            page.write_text(f"{text.rstrip()}\n\n{OLDER}\n", "utf-8")
            older.append(page.name)
    return older


if __name__ == "__main__":
    print(*(mark() or ["every page is current, or says that it is older"]), sep="\n")
