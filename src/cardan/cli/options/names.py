"""Names in one option, as several commands take them."""

from __future__ import annotations

import argparse


def names(text: str) -> list[str]:
    """The type of ``m,l,q0``."""
    listed = [name.strip() for name in text.split(",")]
    if not all(listed):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME,NAME")
    return listed
