"""MJCF documents of a few lines."""

from __future__ import annotations

import textwrap

SOLID = '<geom type="box" size="0.1 0.2 0.3"/>'


def mujoco(body: str, more: str = "") -> str:
    """A file whose world has this inside."""
    return f"<mujoco>{more}<worldbody>{textwrap.dedent(body)}</worldbody></mujoco>"


def one(inside: str, more: str = "", place: str = "") -> str:
    return mujoco(f'<body name="a" {place}>{inside}</body>', more)


def linkage(constraint: str, body: str = "") -> str:
    """Two hinged rods side by side, 0.5 m apart."""
    rods = "".join(
        f'<body name="{name}" pos="{x} 0 0"><joint name="j{name}" axis="0 1 0"/>'
        f'<geom type="capsule" size="0.02" fromto="0 0 0 0 0 1"/><site name="s{name}" pos="0 0 1"/>'
        f"</body>"
        for name, x in (("a", 0), ("b", 0.5))
    )
    text = mujoco(rods + body)
    return text.replace("</mujoco>", f"<equality>{constraint}</equality></mujoco>")
