"""C files and their headers in single precision, rewritten for one build."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from ...errors import BuildError
from ...schema.single_precision import single
from . import cache


@contextmanager
def written(
    sources: Sequence[Path], include: Sequence[Path]
) -> Iterator[tuple[list[Path], list[Path]]]:
    """C files and the folder of all that they include, in single precision, while it is needed.

    Raises:
        BuildError: a file cannot be read, or there is no room.
    """
    try:
        headers = cache.headers(sources, include)
        texts = {path.name: single(path.read_text("utf-8")) for path in (*headers, *sources)}
        with tempfile.TemporaryDirectory(prefix="cardan-float-") as folder:
            for name, text in texts.items():
                (Path(folder) / name).write_text(text, "utf-8")
            yield [Path(folder) / path.name for path in sources], [Path(folder)]
    except OSError as error:
        raise BuildError(f"{error.filename} cannot be read: {error.strerror}") from error
