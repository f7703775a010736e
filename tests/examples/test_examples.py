"""Every script in examples/ runs as a reader would run it, in an empty folder."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = sorted(EXAMPLES.glob("*.py"))
LEAVES = {
    "01_double_pendulum": ("motion.html", "motion.nc"),
    "02_robot_arm": ("arm.html", "arm.png"),
    "03_derive_and_export": ("forward_dynamics.c", "manifest.json"),
    "04_scene_file": ("mistake.yaml", "arm.yaml"),
    "06_four_bar": ("four_bar.html",),
    "07_andrews": ("andrews.html",),
    "08_stewart_platform": ("stewart.html",),
    "09_bicycle": ("bicycle.html",),
    "10_rolling_disk": ("rolling_disk.html",),
    "11_solar_array": ("solar_array.html",),
    "12_ensemble": ("runs.nc",),
    "13_roll_up": ("roll_up.png",),
    "14_bend": ("bend.png",),
    "15_flexible_slider_crank": ("slider_crank.html",),
    "16_spin_up_blade": ("spin_up.html",),
    "17_flexible_pendulum": ("pendulum.html", "example.c", "tables.h"),
    "18_latching_array": ("latching.html",),
    "25_identify_arm": ("motion.csv", "fit.png"),
    "19_bring_your_own_equations": ("forward_dynamics.c", "manifest.json"),
    "20_linear_bicycle": ("matrices.txt",),
    "21_campbell": ("campbell.png", "locus.png"),
    "22_orbit": ("orbit.nc",),
    "23_dual_spin": ("dual_spin.html",),
    "24_computed_torque": ("arm.html",),
    "26_lqr": ("drone.html",),
    "27_sliding_door": ("door.html",),
    "28_flexible_robot": ("robot.html",),
    "29_rotor_on_a_shaft": ("rotor.html",),
    "30_flexible_link": ("link.html", "link.png"),
    "31_deployable_antenna": ("antenna.html",),
    "32_truss_retraction": ("folding.html", "snap.html", "retraction.png"),
    "33_change_points": ("branches.png", "crossed.html"),
    "34_snap_through": ("branches.png", "imperfect.png"),
    "35_buckling_frame": ("lee.png", "pulled.png", "pushed.png"),
    "36_rotor_limit_cycle": ("whirl.png", "whirl.html"),
    "37_files_others_open": ("arm.csv", "arm.mat", "arm.glb", "arm.urdf", "arm_linear.npz"),
    "43_live_pages": ("pendulum.html", "four_bar.html", "ball.html"),
    "38_v_twin": ("v_twin.html",),
    "40_fmu": ("arm.fmu", "door.fmu"),
    "41_swing_up": ("casadi.c", "swing_up.png", "swing_up.html"),
    "42_fit_through_a_rollout": ("jax.c", "fit.png"),
    "44_swing_up_by_shooting": ("swing_up.png", "swing_up.html"),
    "45_four_bar_synthesis": ("foot.png", "foot.html"),
    "46_fit_from_csv": ("motion.csv", "fit.png"),
    "47_friction_from_an_impact": ("fit.png", "block.html"),
    "48_walker": ("walker.png", "walker.html"),
    "49_train_a_policy": ("policy.png", "arm.html"),
    "50_gymnasium": ("search.png", "cart.html"),
}
# packages without which an example says what to install
OPTIONAL = {"50_gymnasium": "gymnasium"}


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_example(script: Path, tmp_path: Path) -> None:
    if script.stem in OPTIONAL:
        pytest.importorskip(OPTIONAL[script.stem])
    command = [sys.executable, str(script)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()
    left = {path.name for path in tmp_path.rglob("*") if path.is_file()}
    assert set(LEAVES[script.stem]) <= left


def test_all_examples_are_known() -> None:
    assert {script.stem for script in SCRIPTS} == set(LEAVES)
