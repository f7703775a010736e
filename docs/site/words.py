"""Words of others: the table of ``words.md`` as entries of the index and of the search."""

from __future__ import annotations

import re
from pathlib import Path

DOCS = Path(__file__).parents[1]
ROW = re.compile(r"^\| ([^|]+) \| [^|]+ \| \[[^\]]+\]\(([^)#]+)\.md[^)]*\) \|$", re.MULTILINE)


def table() -> list[tuple[list[str], str]]:
    """Words that mean the same, and the page that answers them."""
    text = (DOCS / "words.md").read_text(encoding="utf-8")
    return [
        ([word.strip() for word in words.split(",")], page) for words, page in ROW.findall(text)
    ]


def add_entries(source: Path) -> None:
    """Give every page the entries of the words that it answers, below its title."""
    entries: dict[str, list[str]] = {}
    for words, page in table():
        place = re.sub(r"\bREADME$", "index", re.sub(r"^\.\./", "", page))
        entries.setdefault(place, []).extend(words)
    for page, words in entries.items():
        path = source / f"{page}.md"
        text = path.read_text(encoding="utf-8")
        lines = "".join(f"   ! single: {word}\n" for word in words)
        before, heading, after = re.split(r"^(# .*\n)", text, maxsplit=1, flags=re.MULTILINE)
        block = f"\n```{{eval-rst}}\n.. index::\n{lines}```\n"
        path.write_text(before + heading + block + after, encoding="utf-8")
