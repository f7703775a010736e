"""Files of runs and ensembles: one format is one file here.

What is read may come from anybody: no length in a file is believed before the file is seen to have
so many bytes, and a hash of everything that counts tells whether it is what was written.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TypeVar

from ...atomic_file import replaced
from ...errors import ModelError, likely
from ...regular_file import content
from ...version import VERSION, Format
from .contents import Attributes, Contents, Ending, FileFormat, Variables
from .csv import CSV
from .json_text import JSON
from .matlab import MATLAB
from .netcdf import NETCDF
from .netcdf4 import NETCDF4
from .npz import NPZ

FORMATS: tuple[FileFormat, ...] = (NETCDF, NPZ, CSV, MATLAB, JSON, NETCDF4)
AnyEnding = TypeVar("AnyEnding", bound=Ending)
HASH = "sha256"
SOURCE, WRITER = "source", "cardan "  # the text that names the writer, and what is before it
# what files hold
KINDS = {"run": "a run", "ensemble": "an ensemble", "linear": "a linear model"}
MOST = 1 << 40  # bytes of a file


def save(path: Path, form: Format, contents: Contents, cure: str) -> Path:
    """Write a file; one with its name is replaced in one step.

    Args:
        path: The file.
        form: Of a run or an ensemble.
        contents: What it shall hold; arrays without numbers are left out.
        cure: What to do where a variable is too large.

    Raises:
        ModelError: the ending of another format, a variable too large for the format, or a file
            that cannot be written.
        ModuleNotFoundError: a package that the format needs is not installed.
    """
    chosen = by_ending(path, FORMATS, f"{form.kind}s")
    variables = {name: one for name, one in contents.variables.items() if one.values.size}
    for name, one in variables.items():
        if chosen.limit and one.values.nbytes > chosen.limit:
            raise ModelError(
                f"{path}: '{name}' takes {one.values.nbytes / 1e9:.1f} GB, {chosen.name} holds "
                f"{chosen.limit / 2**30:.0f} GB in one variable. {cure}"
            )
    contents = Contents(variables, contents.notes)
    header = {f"cardan_{form.word}": form.version, SOURCE: f"{WRITER}{VERSION}"}
    with replaced(path) as new:
        chosen.write(Path(new), {**header, HASH: contents.digest(), **contents.notes}, variables)
    return path


def load(path: Path, form: Format, notes: Collection[str]) -> Contents:
    """Read a file that :func:`save` wrote.

    Args:
        path: The file.
        form: As of :func:`save`; files of its oldest version have no hash.
        notes: Names of the texts that count.

    Raises:
        ModelError: no such file, one of another kind or version, or a damaged one.
    """
    what = form.word
    try:
        attributes, variables = _parsed(content(path, MOST))
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except OSError as error:
        raise ModelError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, MemoryError) as error:
        raise ModelError(
            f"{path} is not {KINDS[what]} of cardan, or is damaged: {error or 'it is too large'}. "
            f"Save the {what} again"
        ) from None
    version = attributes.get(f"cardan_{what}", 0)
    if not form.reads(version):
        if f"cardan_{what}" not in attributes:
            raise ModelError(f"{path} is not {KINDS[what]} of cardan")
        writer = str(attributes.get(SOURCE, "")).removeprefix(WRITER)
        raise ModelError(form.refusal(path, version, writer))
    today = {name: form.today((name,), version) for name in attributes}
    counting = {name for name, now in today.items() if now in notes}
    texts = {name: attributes[name] for name in counting if isinstance(attributes[name], str)}
    contents = Contents(variables, texts)
    # damage may have made a file of an early version out of this one
    if (version > form.oldest or HASH in attributes) and attributes.get(HASH) != contents.digest():
        others = [KINDS[k] for k in KINDS if k != what and f"cardan_{k}" in attributes]
        if others and f"cardan_{what}" not in attributes:
            raise ModelError(
                f"{path} is not {KINDS[what]} that cardan can read: it holds {others[0]}"
            )
        raise ModelError(
            f"{path} is not what was saved: its hash differs. Copy it or save the {what} again"
        )
    return _today(contents, form, version)


def by_ending(path: Path, table: Sequence[AnyEnding], what: str, bare: bool = True) -> AnyEnding:
    """The format of a file by the ending of its name, in letters of any case.

    Args:
        path: The file.
        table: Formats to choose from.
        what: Is written, in the plural.
        bare: Whether a name without an ending is one of the first format.

    Raises:
        ModelError: there is no such format.
        ModuleNotFoundError: a package that it needs is not installed.
    """
    ending = path.suffix.lower()
    fitting = [one for one in table if ending in one.endings and (ending or bare)]
    if not fitting:
        names = ", ".join(f"{one.endings[0]} ({one.name})" for one in table)
        close = likely(ending, endings(table))
        hint = f". Did you mean {' or '.join(close)}?" if close else ""
        raise ModelError(f"{path}: {what} are written to files that end in one of {names}{hint}")
    (chosen,) = fitting
    for package in chosen.packages:
        if find_spec(package) is None:
            raise ModuleNotFoundError(
                f"{path}: {chosen.name} files need {package}, which is not installed: "
                f"pip install 'cardan[{chosen.extra}]'"
            )
    return chosen


def endings(table: Iterable[Ending]) -> tuple[str, ...]:
    """Endings of the files of some formats."""
    return tuple(ending for one in table for ending in one.endings if ending)


def writable() -> tuple[str, ...]:
    """Endings of all files that are written."""
    return endings(FORMATS)


def readable() -> tuple[str, ...]:
    """Endings of the files that are read again."""
    return endings(one for one in FORMATS if one.parse is not None)


def _parsed(data: bytes) -> tuple[Attributes, Variables]:
    """Attributes and variables of a file of any format that is read.

    Raises:
        ValueError: it is of none, or damaged.
    """
    for one in FORMATS:
        if data.startswith(one.magic or (b"\0",)):
            if one.parse is None:
                listed = ", ".join(readable())
                raise ValueError(f"{one.name} is written only, and {listed} are read")
            return one.parse(data)
    names = " nor ".join(one.name for one in FORMATS if one.parse is not None)
    raise ValueError(f"its format is neither {names}")


def _today(contents: Contents, form: Format, version: int) -> Contents:
    """Contents of an older file under today's names."""
    if not any(older >= version for older in form.renamed):
        return contents

    def translated(name: str, text: str) -> str:
        try:
            return json.dumps(form.translated(json.loads(text), (name,), version))
        except ValueError:
            # a title, which holds no names
            return text

    notes = {name: translated(name, text) for name, text in contents.notes.items()}
    return Contents(
        {form.today((name,), version): one for name, one in contents.variables.items()},
        {form.today((name,), version): text for name, text in notes.items()},
    )
