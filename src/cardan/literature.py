"""Sources of formalisms, elements and methods, named in their docstrings."""

from __future__ import annotations

from typing import ClassVar


class HasSource:
    """A class whose docstring says behind ``Source:`` where it is from.

    Attributes:
        source: Author, title, chapter; "" where docstrings are stripped (``python -OO``).
    """

    source: ClassVar[str] = ""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        _, named, text = (cls.__doc__ or "").partition("Source:")
        if named:
            cls.source = " ".join(text.split("\n\n")[0].split()).removesuffix(".")
