"""What must not be loaded: SymPy at ``import cardan``, the compiler half with a saved model."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import cardan as cd

LIGHT = ("sympy", "mpmath", "matplotlib", "rich", "scipy")
COMPILER_HALF = tuple(
    f"cardan.{room}"
    for room in ("spatial", "elements", "scene", "topology", "equations", "passes", "codegen")
)


def loaded_by(program: str, *arguments: str) -> set[str]:
    """Names of the modules a fresh process has after running the program."""
    script = program + "\nimport sys; print('loaded:', *sys.modules)"
    command = [sys.executable, "-c", script, *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return set(done.stdout.rpartition("loaded:")[2].split())


def test_import_is_light() -> None:
    loaded = loaded_by("import cardan")
    assert not loaded & {*LIGHT, "numpy"}
    assert not [name for name in COMPILER_HALF if name in loaded]


def test_a_saved_model_runs_without_sympy_and_compiler_half(tmp_path: Path) -> None:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    body = scene.body("bob", mass=1.0, com=(0, 0, -1.0), inertia=(0.1, 0.1, 0.1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, body)
    cd.derive(scene).export(tmp_path / "pendulum")
    program = """
import sys
import cardan
model = cardan.load_model(sys.argv[1])
print(model.forward_dynamics([0.3], [0.0]))
"""
    loaded = loaded_by(program, str(tmp_path / "pendulum"))
    assert "sympy" not in loaded
    assert not [name for name in (*COMPILER_HALF, "cardan.analyses") if name in loaded]


def test_reading_a_urdf_loads_no_sympy(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(
        "<robot name='arm'><link name='base'/><link name='rod'><inertial><mass value='1'/>"
        "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
        "<joint name='hinge' type='continuous'><parent link='base'/><child link='rod'/>"
        "<axis xyz='0 1 0'/></joint></robot>"
    )
    loaded = loaded_by("import sys, cardan as cd; cd.compile(cd.load(sys.argv[1]))", str(path))
    assert "sympy" not in loaded
