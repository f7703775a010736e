"""The scenes of the examples, taken out of their scripts without running what follows."""

from __future__ import annotations

import io
import os
import re
from collections.abc import Callable
from contextlib import redirect_stdout
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

import cardan as cd

# files of the package whose C and pages are looked at; the others are like a script
FILES = [cd.examples.path(n) for n in ("bicycle", "bucket", "double_pendulum", "trolley")]
EXAMPLES = sorted(
    path
    for path in (*(Path(__file__).parents[2] / "examples").iterdir(), *FILES)
    if path.suffix in (".py", ".yaml", ".urdf")
)
# pages that take a second or more, and scenes that another example has already
LONG = {
    "07_andrews",
    "08_stewart_platform",
    "09_bicycle",
    "11_solar_array",
    "18_latching_array",
    "20_linear_bicycle",
    "22_orbit",
    "25_identify_arm",
    "26_lqr",
    "28_flexible_robot",
    "29_rotor_on_a_shaft",
    "30_flexible_link",
    "31_deployable_antenna",
    "32_truss_retraction",
    "33_change_points",
    "bicycle",
}
TWICE = {"02_robot_arm", "04_scene_file", "14_bend"}


class _Enough(Exception):
    """A script has its scene."""


def short(paths: list[Path]) -> list[Any]:
    """The examples, with long and repeated ones marked slow."""
    return [
        pytest.param(path, id=path.name, marks=[pytest.mark.slow] * (path.stem in LONG | TWICE))
        for path in paths
    ]


@cache
def scene_of(example: Path) -> cd.Scene:
    """What an example derives or compiles first; where it has a ``scene``, that one."""
    if example.suffix != ".py":
        return cd.load(example)
    names: dict[str, Any] = {"__name__": "example", "__file__": str(example)}
    text, found = example.read_text("utf-8"), []
    named = re.search(r"^(\w+, )*scene\b.* = ", text, re.MULTILINE)

    def until_named(real: Callable[..., Any]) -> Callable[..., Any]:
        def handed(scene: cd.Scene, *rest: Any, **options: Any) -> Any:
            if not named or names.get("scene") is scene:
                found.append(scene)
                raise _Enough
            return real(scene, *rest, **options)

        return handed

    before = Path.cwd()
    with pytest.MonkeyPatch.context() as patch, TemporaryDirectory() as folder:
        patch.setattr(cd, "derive", until_named(cd.derive))
        patch.setattr(cd, "compile", until_named(cd.compile))
        os.chdir(folder)
        try:
            with redirect_stdout(io.StringIO()):
                exec(compile(text, str(example), "exec"), names)
        except _Enough:
            pass
        finally:
            os.chdir(before)
    return found[0]


@cache
def equations_of(example: Path) -> Any:
    return cd.derive(scene_of(example))
