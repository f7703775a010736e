"""Files of scenes as users read them, and the example scenes that come with cardan.

::

    print(cd.examples)                        names, with a line on each
    scene = cd.examples["four_bar"]
    motion = cd.compile(scene).simulate(**scene.settings)

Examples are scene files: ``cd.examples.path("four_bar")`` is one to read or to copy, and commands
such as ``cardan simulate four_bar`` take their names in place of a file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from ..arguments import checked
from ..errors import ModelError, near
from ..scene import read
from ..scene.files.options import Options
from .faces import face
from .scene import Scene

if TYPE_CHECKING:
    from ..superelements.record import SuperelementRecord

FOLDER = Path(__file__).parents[1] / "scenes"


@checked
def load(
    path: str | Path,
    base: str = "fixed",
    mimic: str = "couple",
    snap: bool = True,
    packages: str | Path | Sequence[str | Path] = (),
    parameters: Mapping[str, float] | None = None,
    limits: str = "note",
    friction: bool = False,
) -> Scene:
    """Read a scene from a file.

    Args:
        path: A scene (``.yaml``), a robot (``.urdf``, ``.sdf``) or a model of MuJoCo (``.xml``,
            ``.mjcf``); the root element tells these apart.
        base: For URDF and SDF robots: ``"fixed"``: the root is fixed to the ground; ``"free"``: it
            floats.
        mimic: For URDF and SDF robots: ``"couple"``: a joint that mimics another follows it;
            ``"free"``: it moves freely.
        snap: Replace rounded multiples of a quarter turn by exact ones, within half a unit of the
            last printed digit; all are listed in ``Model.snaps``. With False numbers stay as they
            are printed.
        packages: Folder or folders below which ``package://`` and ``model://`` paths and absolute
            paths must lie.
        parameters: Values by dotted name that replace those of the file.
        limits: ``"stop"``: limits of position act as a :class:`cardan.Stop`, ``<joint>.stop``, on
            joints of one coordinate that are neither coupled nor prescribed; where 0 is outside,
            the joint starts in the middle of its range. ``"note"``: limits are only listed.
        friction: Dry friction of the file acts as a :class:`cardan.Friction`,
            ``<joint>.friction``; otherwise it is only listed.

    Returns:
        The model. What the file says and the model does not act on is listed in ``Model.notes``;
        ``print(model)`` shows these, and joints whose limits or friction no force acts for.

    Raises:
        ModelError: the file cannot be read or is at fault.
        TopologyError: links form a loop or nothing joins them.
    """
    folders = [packages] if isinstance(packages, str | Path) else packages
    roots = tuple(Path(root) for root in folders)
    options = Options(base, mimic, snap, roots, mesh_reduction=_mesh_reduction)
    scene: Scene = face(read(path, options, parameters, limits, friction))
    for superelement in scene.superelements.values():
        face(superelement.record)
    return scene


def _mesh_reduction() -> Callable[..., SuperelementRecord]:
    from ..solids.reduced import from_mesh

    return from_mesh


@cache
def example_files() -> dict[str, Path]:
    """Name -> file, in the order of the alphabet."""
    return {path.stem: path for path in sorted(FOLDER.iterdir()) if path.is_file()}


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
