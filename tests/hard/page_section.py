"""Sections of docs/hard_cases.md that stand before another one and are written anew alone."""

from __future__ import annotations


def with_section(page: str, title: str, section: str, following: str) -> str:
    """The page with a section anew.

    Args:
        page: The page.
        title: Of the section.
        section: Its text.
        following: Title of the section behind it.
    """
    own, other = f"\n## {title}\n", f"\n## {following}\n"
    before, _, behind = page.partition(own if own in page else other)
    if own in page:
        behind = behind.partition(other)[2]
    return f"{before.rstrip()}\n{own}{section}\n{other}{behind}"
