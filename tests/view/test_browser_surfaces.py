"""Surfaces of superelements in a browser: their modes, and their motions.

Needs Chromium and the package playwright (``make browser`` installs the latter).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from solids.meshes import block
from view.test_browser import Shown, browser

__all__ = ["browser"]


def test_a_surface_bends_and_is_colored(browser: Any, tmp_path: Path) -> None:
    """Points and colors in the page against those of the component, by displacement and stress."""
    viridis = pytest.importorskip("matplotlib").colormaps["viridis"]
    matrices = cd.superelement.mesh
    points = np.array([[x, y, z] for x in range(4) for y in range(2) for z in range(2)]) * 0.1
    ring = ((0, 0), (1, 0), (1, 1), (0, 1))
    cells = [[4 * (i + a) + 2 * b + k for k in range(2) for a, b in ring] for i in range(3)]
    mesh = matrices.from_arrays(points, {"hex8": cells})
    record = cd.superelement.from_mesh(
        mesh, cd.material(E=70e9, nu=0.3, rho=2700), {"a": [0, 1, 2, 3]}, modes=3, stress=range(16)
    )
    modes = record.modes(["a"])
    exact = record.surface_displacements(modes.shapes[:, 1])
    stress = matrices.von_mises(record.stresses(modes.shapes[:, 1]).reshape(-1, 6))
    quarter = np.pi / 2 / modes.frequencies[1]
    for color, values in (("displacement", np.linalg.norm(exact, axis=1)), ("stress", stress)):
        page = record.animate(2, tmp_path / "mode.html", color=color, scale=0.01)
        with Shown(browser, f"{page.saved().as_uri()}#t=0", bypass_csp=True) as shown:
            shown.tell(f"seek({quarter})")
            for k in (0, 5, 9, 12, 15):
                place, tone = shown.tell(f"point('component', {k})")
                # the picture is within half a step of time of the largest deflection
                np.testing.assert_allclose(
                    place, record.surface_points[k] + 0.01 * exact[k], atol=2e-4
                )
                # colors of the script, in linear light, are those of Matplotlib at nine values
                bright = np.clip(12.92 * np.array(tone), 0, None)
                rgb = np.where(
                    np.array(tone) <= 0.0031308, bright, 1.055 * np.array(tone) ** (1 / 2.4) - 0.055
                )
                stops = np.linspace(0.0, 1.0, 9)
                tones = viridis(stops)[:, :3].T
                right = [np.interp(values[k] / values.max(), stops, one) for one in tones]
                np.testing.assert_allclose(rgb, right, atol=0.02)
            assert not [said for said in shown.complaints if "GPU stall" not in said]


def test_a_superelement_moves_bends_and_is_followed(browser: Any, tmp_path: Path) -> None:
    """Points in the page against those of the motion."""
    mesh = block("hex8", (4, 1, 1), (0.4, 0.1, 0.1))
    x = mesh.points[:, 0]
    ends = {"a": np.flatnonzero(x < 1e-9), "b": np.flatnonzero(x > 0.4 - 1e-9)}
    rubber = cd.material(E=5e6, nu=0.4, rho=1100)
    record = cd.superelement.from_mesh(mesh, rubber, ends, modes=2, stress=range(len(x)))
    scene = cd.Scene("flying")
    bar = scene.superelement("bar", record)
    scene.joint("free", cd.Free(), scene.ground, bar.at("a"))
    speeds = {"free": [0.0, 9.0, 3.0, 0.0, 0.0, 8.0]}
    motion = cd.compile(scene).simulate(np.linspace(0, 1, 41), u=speeds, rtol=1e-4)
    exact = motion.superelement("bar").positions
    page = motion.animate(tmp_path / "bar.html", follow="bar").saved().as_uri()
    with Shown(browser, f"{page}#t=0", bypass_csp=True) as shown:
        for row in (0, 13, 40):
            shown.tell(f"seek({motion.t[row]})")
            for k in (0, 7, 15):
                place, _ = shown.tell(f"point('bar', {k})")
                np.testing.assert_allclose(place, exact[row, k], atol=2e-4)
        # the camera goes with it
        targets = []
        for row in (0, 40):
            shown.tell(f"seek({motion.t[row]})")
            targets.append(shown.tell("target"))
        way = np.diff(motion.pose("bar.axes")[[0, 40], :3, 3], axis=0)[0]
        assert np.linalg.norm(way) > 1.0
        np.testing.assert_allclose(np.diff(targets, axis=0)[0], way, atol=1e-3)
        assert not [said for said in shown.complaints if "GPU stall" not in said]
