"""The version of cardan, and the versions of the files that it writes.

Every kind of file says which version of its format it has and which cardan wrote it. ``FORMATS`` is
the one place that says which versions are read and what its names were called before.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import NamedTuple

VERSION = "0.1.0"
SOURCES = (".py", ".h")


@lru_cache(maxsize=1)
def source_state() -> list[tuple[str, int, int]]:
    """Size and time of change of every file of this package: an edited compiler starts anew."""
    return sorted(_states(os.path.dirname(__file__)))


def _states(folder: str) -> Iterator[tuple[str, int, int]]:
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir():
                yield from _states(entry.path)
            elif entry.name.endswith(SOURCES):
                status = entry.stat()
                yield entry.name, status.st_size, status.st_mtime_ns


class Format(NamedTuple):
    """A kind of file.

    Attributes:
        kind: In messages, such as ``"run"``.
        word: In files of this kind.
        version: That is written.
        oldest: The first that is read.
        cure: What helps where a version is not read.
        renamed: Version -> place of a name -> the name it has in the next version. Places are
            dotted; ``*`` stands for any one name or number of an entry, as in ``"bodies.*.mass"``.
        reworded: Version -> place of a text -> the texts it may have -> those of the next version.
    """

    kind: str
    word: str
    version: int
    oldest: int
    cure: str
    renamed: Mapping[int, Mapping[str, str]] = {}
    reworded: Mapping[int, Mapping[str, Mapping[str, str]]] = {}

    def reads(self, version: object) -> bool:
        """True when files of a version can be read."""
        return version in range(self.oldest, self.version + 1)

    def refusal(self, where: object, version: object, writer: object) -> str:
        """Why a file is not read, and the cure.

        Args:
            where: The file.
            version: Of its format.
            writer: The cardan that wrote it, as the file says.
        """
        versions = " to ".join(str(k) for k in dict.fromkeys((self.oldest, self.version)))
        return (
            f"{where} was written by {written_by(writer)}, {self.kind} format {version}; this is "
            f"cardan {VERSION}, which reads {self.kind} format {versions}. Take the cardan that "
            f"wrote it, or {self.cure}"
        )

    def today(self, place: tuple[str, ...], version: int) -> str:
        """The name that the last part of a place of an older file has today."""
        for older in range(version, self.version):
            for old, new in self.renamed.get(older, {}).items():
                if _is_at(old.split("."), place):
                    place = (*place[:-1], new)
                    break
        return place[-1]

    def text_today(self, text: str, place: tuple[str, ...], version: int) -> str:
        """The text that stands today at a place of an older file, under its name there."""
        for older in range(version, self.version):
            for pattern, texts in self.reworded.get(older, {}).items():
                if _is_at(pattern.split("."), place):
                    text = texts.get(text, text)
        return text

    def translated(self, data: object, place: tuple[str, ...], version: int) -> object:
        """Plain data of an older file under the names of today."""
        if isinstance(data, list):
            rows = enumerate(data)
            return [self.translated(row, (*place, str(k)), version) for k, row in rows]
        if isinstance(data, str):
            return self.text_today(data, place, version)
        if not isinstance(data, dict):
            return data
        return {
            self.today((*place, name), version): self.translated(one, (*place, name), version)
            for name, one in data.items()
        }


def _is_at(pattern: list[str], place: tuple[str, ...]) -> bool:
    return len(pattern) == len(place) and all(
        a in ("*", b) for a, b in zip(pattern, place, strict=True)
    )


def written_by(writer: object) -> str:
    """The cardan that a file names, or that none is named."""
    return f"cardan {writer}" if isinstance(writer, str) and writer else "another cardan"


RESTART = "start the run anew"
# scenes, runs and ensembles are read for ever
SCENE = Format(
    "scene",
    "cardan",
    2,
    1,
    "write the scene for this one",
    {
        1: {
            "forces.*.length": "rest_length",
            "forces.*.slip": "transition_velocity",
            "forces.*.then": "terminal",
            "joints.*.motion": "prescribed",
        }
    },
    {
        1: {
            "forces.*.then": {"mark": "false", "end": "true"},
            "forces.*.type": {
                "damping": "joint_damper",
                "torsion_spring": "joint_spring",
                "watch": "event",
            },
        }
    },
)
RUN = Format(
    "run",
    "run",
    4,
    1,
    "save the run again",
    {
        2: {
            "manifest.cuts.*.circuit": "loop",
            "manifest.joints.*.solved.circuit": "loop",
            "manifest.limits.*.told": "message",
            "manifest.limits.*.who": "element",
        },
        3: {
            "manifest.functions.applied": "applied_forces",
            "manifest.functions.facing": "assembly_signs",
        },
    },
    {3: {"manifest.available.*": {"applied": "applied_forces", "facing": "assembly_signs"}}},
)
ENSEMBLE = Format("ensemble", "ensemble", 1, 0, "save the ensemble again")
CONTINUATION = Format("path", "path", 1, 1, "follow the path again")
LINEAR = Format("linear model", "linear", 1, 1, "linearize again")
# these are read by the version that wrote them, and refused by others
STEPPER = Format("stepper checkpoint", "cardan_checkpoint", 5, 5, RESTART)
RUN_FILE = Format("run checkpoint", "run", 4, 4, RESTART)
ENSEMBLE_FILE = Format("ensemble checkpoint", "ensemble", 2, 2, "start the ensemble anew")
MANIFEST = Format("manifest", "schema", 3, 3, "compile the model again")
ABI = Format("C interface", "abi", 2, 2, "compile the model again")
PICKLE = Format("pickle", "pickle", 3, 3, "pickle again what it was made of")
SUPERELEMENT = Format("superelement", "superelement", 3, 1, "reduce its matrices again")
FORMATS = (
    *(SCENE, RUN, ENSEMBLE, CONTINUATION, LINEAR, SUPERELEMENT, STEPPER, RUN_FILE, ENSEMBLE_FILE),
    *(MANIFEST, ABI, PICKLE),
)
