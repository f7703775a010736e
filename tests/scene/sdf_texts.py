"""SDF documents of a few lines."""

from __future__ import annotations

import cardan as cd


def sdf(inside: str, version: str = "1.7", name: str = "m") -> str:
    """A file with one model."""
    return f'<sdf version="{version}"><model name="{name}">{inside}</model></sdf>'


def link(name: str, pose: str = "", more: str = "", relative_to: str = "") -> str:
    """A link of 2 kg."""
    frame = f' relative_to="{relative_to}"' if relative_to else ""
    return (
        f'<link name="{name}">' + (f"<pose{frame}>{pose}</pose>" if pose else "") + "<inertial>"
        "<pose>0.1 0.2 -0.3 0 0 0.5</pose><mass>2</mass><inertia><ixx>0.2</ixx><iyy>0.3</iyy>"
        f"<izz>0.4</izz><ixy>0.01</ixy><ixz>-0.02</ixz><iyz>0.03</iyz></inertia></inertial>{more}"
        "</link>"
    )


def joint(
    name: str,
    parent: str,
    child: str,
    kind: str = "revolute",
    axis: str = "<axis><xyz>0 0 1</xyz></axis>",
    pose: str = "",
) -> str:
    """A joint."""
    return (
        f'<joint name="{name}" type="{kind}">{pose}<parent>{parent}</parent>'
        f"<child>{child}</child>{axis}</joint>"
    )


def rod(name: str, place: tuple[float, float, float], length: float) -> str:
    """A box along x as the four-bar of the mechanisms has it, 1 kg per meter."""
    xx, yy, zz = cd.inertia.box(length, length, 0.02, 0.01)
    x, y, angle = place
    return (
        f'<link name="{name}"><pose>{x} {y} 0 0 0 {angle}</pose><inertial><pose>{length / 2} 0 0 0 '
        f"0 0</pose><mass>{length}</mass><inertia><ixx>{xx}</ixx><iyy>{yy}</iyy><izz>{zz}</izz>"
        "</inertia></inertial></link>"
    )


def bars(places: list[tuple[float, float, float]]) -> str:
    """The four-bar of the mechanisms, its crank, coupler and rocker drawn at x, y, angle."""
    lengths = {"crank": 0.1, "coupler": 0.25, "rocker": 0.2}
    rods = [rod(name, at, lengths[name]) for name, at in zip(lengths, places, strict=True)]
    joints = (
        joint("A", "world", "crank")
        + joint("B", "crank", "coupler")
        + joint("D", "world", "rocker")
        + joint("C", "coupler", "rocker", pose="<pose>0.2 0 0 0 0 0</pose>")
    )
    return sdf("".join(rods) + joints, "1.6", "four_bar")
