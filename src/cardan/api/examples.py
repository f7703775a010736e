"""The example scenes that come with cardan.

::

    print(cd.examples)                        names, with a line on each
    scene = cd.examples["four_bar"]
    motion = cd.compile(scene).simulate(**scene.settings)

They are scene files: ``cd.examples.path("four_bar")`` is one to read or to copy, and commands such
as ``cardan simulate four_bar`` take their names in place of a file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ..errors import ModelError, near
from ..scene.example_files import example_files
from .scene import Scene
from .scene_file import load


class Examples(Mapping[str, Scene]):
    """Example scenes by name; each is read anew when it is asked for."""

    def __getitem__(self, name: str) -> Scene:
        """A scene.

        Raises:
            ModelError: there is none of that name.
        """
        return load(self.path(name))

    def __contains__(self, name: object) -> bool:
        return name in example_files()

    def __iter__(self) -> Iterator[str]:
        return iter(example_files())

    def __len__(self) -> int:
        return len(example_files())

    def path(self, name: str) -> Path:
        """The file of a scene.

        Raises:
            ModelError: there is none of that name.
        """
        files = example_files()
        if name not in files:
            raise ModelError(f"examples: there is no scene '{name}'.{near(name, files)}")
        return files[name]

    def description(self, name: str) -> str:
        """One line on a scene: the first comment of its file.

        Raises:
            ModelError: there is none of that name.
        """
        text = self.path(name).read_text(encoding="utf-8")
        comment = re.search(r"^# (.*)$|<!-- (.*?) -->", text, re.MULTILINE)
        return (comment[1] or comment[2]) if comment else ""

    def __repr__(self) -> str:
        width = max(map(len, self))
        return "\n".join(f"{name:{width}}  {self.description(name)}" for name in self)


examples = Examples()
