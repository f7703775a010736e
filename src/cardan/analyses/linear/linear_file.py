"""Linear models as files: for MATLAB, Octave and other programs, and read again."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError
from ...runtime import formats
from ...runtime.formats.contents import Contents, Variable, letters
from ...runtime.formats.csv import CSV
from ...schema.fields import Record, count, field, listed, number, text
from ...version import LINEAR
from .linear_model import LinearModelRecord

# a table of a matrix has no rows along anything
FORMATS = tuple(one for one in formats.FORMATS if one is not CSV)
CURE = "Linearize a smaller model"
NOTES = ("title", "about")
SIGNALS = ("states", "inputs", "outputs")
AXES = tuple(name.removesuffix("s") for name in SIGNALS)
# what files of earlier versions do not hold
ADDED = ("xdot",)
# array -> names of its axes
MATRICES = {
    "A": ("state", "state_again"),
    "B": ("state", "input"),
    "C": ("output", "state"),
    "D": ("output", "input"),
    "mass": ("independent_speed", "independent_speed_again"),
    "increments": ("speed", "state"),
    "speeds": ("speed", "state"),
    "x": ("entry",),
    "xdot": ("state",),
    "units": ("state",),
}


class About(Record):
    """Names and numbers of a linear model in its file."""

    name: str = field(text)
    states: list[str] = field(listed(text))
    inputs: list[str] = field(listed(text))
    outputs: list[str] = field(listed(text))
    state_units: list[str] = field(listed(text))
    input_units: list[str] = field(listed(text))
    output_units: list[str] = field(listed(text))
    along: list[str] = field(listed(text))
    n: int = field(count)
    z: int = field(count)
    acceleration: float = field(number)
    independent_increments: list[int] = field(listed(count))
    independent_speeds: list[int] = field(listed(count))


@checked
def save(linear_model: LinearModelRecord, path: str | Path) -> Path:
    """Write A, B, C, D with names and units; the ending of the name says the format.

    ``.npz`` (NumPy archive) and ``.nc`` (netCDF) are read by :func:`cardan.load_linear`; ``.mat``
    (MATLAB, Octave), ``.json`` and ``.nc4`` are for other programs. Names stand in ``states``,
    ``inputs``, ``outputs``, their units in ``state_units`` and so on; ``mass`` is that of the
    independent speeds, ``x`` the state of the whole model about which it stands. The file appears
    complete or not at all.

    Args:
        linear_model: The linear model.
        path: The file.

    Returns:
        Its path.

    Raises:
        ModelError: the ending of another format, or a file that cannot be written.
        ModuleNotFoundError: a package that the format needs is not installed.
    """
    variables = {
        name: Variable(axes, np.asarray(getattr(linear_model, name), dtype=np.float64))
        for name, axes in MATRICES.items()
    }
    for name in SIGNALS:
        axis, units = name.removesuffix("s"), f"{name.removesuffix('s')}_units"
        variables[name] = letters(getattr(linear_model, name), axis, name)
        variables[units] = letters(getattr(linear_model, units), axis, units)
    increments, speeds = linear_model.choice
    about = {name: getattr(linear_model, name) for name in ("name", "along", "n", "z", *SIGNALS)}
    about |= {f"{name}_units": getattr(linear_model, f"{name}_units") for name in AXES}
    about |= {
        "acceleration": linear_model.acceleration,
        "independent_increments": np.asarray(increments).tolist(),
        "independent_speeds": np.asarray(speeds).tolist(),
    }
    title = f"linear model of {linear_model.name}".encode("ascii", "replace").decode()
    notes = {"title": title, "about": json.dumps(about)}
    return formats.save(Path(path), LINEAR, Contents(variables, notes), CURE, FORMATS)


@checked
def load(path: str | Path) -> LinearModelRecord:
    """Read a linear model that :meth:`.LinearModel.save` wrote.

    Args:
        path: A ``.npz`` or ``.nc`` file.

    Returns:
        The linear model.

    Raises:
        ModelError: not a linear model of cardan, a damaged one, or a newer format.
    """
    path = Path(path)
    contents = formats.load(path, LINEAR, NOTES)
    try:
        about = About.read(json.loads(contents.notes.get("about", "null")), True)
        return _linear_model(about, contents)
    except (ValueError, KeyError, MemoryError, RecursionError) as error:
        raise ModelError(
            f"{path} is not a linear model that cardan can read: {error}. Save it again"
        ) from None


def _linear_model(about: About, contents: Contents) -> LinearModelRecord:
    """The linear model of a file whose parts fit each other.

    Raises:
        ValueError: some do not.
    """
    nx, nr, ny, nu = (len(x) for x in (about.states, about.inputs, about.outputs, about.along))
    choice = about.independent_increments, about.independent_speeds
    nv = nx - about.n - about.z
    entries = contents.variables["x"].values.size if "x" in contents.variables else 0
    sizes = {"state": nx, "input": nr, "output": ny, "speed": nu, "independent_speed": nv}
    sizes["entry"] = entries
    arrays: dict[str, Array] = {}
    for name, axes in MATRICES.items():
        shape = tuple(sizes[axis.removesuffix("_again")] for axis in axes)
        # what has no numbers stands in no file
        empty = 0 in shape and name not in contents.variables
        later = name in ADDED and name not in contents.variables
        values = np.full(shape, np.nan) if empty or later else contents.variables[name].values
        if values.shape != shape:
            raise ValueError(f"'{name}' has shape {values.shape}, not {shape}")
        arrays[name] = values
    places = [*choice[0], *choice[1]]
    if [len(part) for part in choice] != [about.n, nv] or not all(k < nu for k in places):
        raise ValueError("its independent speeds are damaged")
    units = {f"{name}_units": tuple(getattr(about, f"{name}_units")) for name in AXES}
    if [len(part) for part in units.values()] != [nx, nr, ny]:
        raise ValueError("its units are damaged")
    return LinearModelRecord(
        name=about.name,
        states=tuple(about.states),
        inputs=tuple(about.inputs),
        outputs=tuple(about.outputs),
        along=tuple(about.along),
        n=about.n,
        z=about.z,
        acceleration=about.acceleration,
        choice=(np.array(choice[0], np.intp), np.array(choice[1], np.intp)),
        state_units=units["state_units"],
        input_units=units["input_units"],
        output_units=units["output_units"],
        A=arrays["A"],
        B=arrays["B"],
        C=arrays["C"],
        D=arrays["D"],
        mass=arrays["mass"],
        x=arrays["x"],
        xdot=arrays["xdot"],
        units=arrays["units"],
        increments=arrays["increments"],
        speeds=arrays["speeds"],
    )
