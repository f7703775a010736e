"""Exported models: plain C that compiles alone, nobody's files touched."""

import json
import subprocess
from pathlib import Path

import pytest

import cardan as cd
from cardan.codegen.export import export
from cardan.errors import CodegenError, DerivationError
from codegen.models import arm
from codegen.running import SPEED, STRICT, compilers

MAIN = """
#include "functions.h"
#include <stdio.h>

int main(void)
{
    static real p[64], q[16], u[16], tau[16], t[1];
    static wreal w[forward_dynamics_w_size + 1];
    static real out[forward_dynamics_out_size], work[forward_dynamics_work_size + 1];
    static const double values[] = {PARAMETERS};
    for (int i = 0; i < cardan_np; ++i) p[i] = values[i];
    q[q_float_w] = 1.0;
    q[q_elbow] = 0.4;
    prepare_forward_dynamics(p, w);
    cardan_in in = {0};
    in.t = t;
    in.q = q;
    in.u = u;
    in.tau = tau;
    in.w = w;
    const int status = forward_dynamics(&in, out, work);
    for (int i = 0; i < forward_dynamics_out_size; ++i) printf("%.17g\\n", out[i]);
    return status;
}
"""


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_exported_files_compile_alone_and_compute(compiler: str, tmp_path: Path) -> None:
    equations = cd.derive(arm())
    folder = export(equations, tmp_path / "arm")
    values = [p.value for p in equations.system.parameters]
    main = MAIN.replace("PARAMETERS", ", ".join(map(repr, values)))
    (tmp_path / "main.c").write_text(main)
    program = tmp_path / "main"
    sources = sorted(map(str, folder.glob("*.c")))
    command = [*compilers()[compiler], *STRICT, *SPEED, f"-I{folder}", str(tmp_path / "main.c")]
    answer = subprocess.run(
        [*command, *sources, "-o", str(program), "-lm"], capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    run = subprocess.run([str(program)], capture_output=True, text=True, check=True)
    exported = [float(line) for line in run.stdout.split()]
    model = cd.compile(equations, functions=("forward_dynamics",))
    state = model.split(model.initial(q={"elbow": 0.4, "shoulder": 0.0}))
    assert exported == pytest.approx(model.forward_dynamics(*state).tolist(), rel=1e-11, abs=1e-11)


def test_files_are_those_of_the_manifest(tmp_path: Path) -> None:
    folder = export(cd.derive(arm()), tmp_path / "arm", ["bias", ("pose", "tool")])
    data = json.loads((folder / "manifest.json").read_text("utf-8"))
    assert {p.name for p in folder.iterdir()} == {"manifest.json", *data["sha256"]}
    assert set(data["functions"]) == {"bias", "pose__tool"}
    assert data["functions"]["pose__tool"]["of"] == "tool"


def test_an_earlier_export_is_replaced(tmp_path: Path) -> None:
    export(cd.derive(arm()), tmp_path / "arm", ["bias"])
    export(cd.derive(arm()), tmp_path / "arm", ["energy"])
    assert (tmp_path / "arm" / "energy.c").exists()
    assert not (tmp_path / "arm" / "bias.c").exists()
    assert [p.name for p in tmp_path.iterdir()] == ["arm"]


@pytest.mark.parametrize("name", ["notes.txt", "energy.h"])
def test_other_peoples_files_are_left_alone(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "arm"
    export(cd.derive(arm()), folder, ["bias"])
    before = (folder / "manifest.json").read_bytes()
    (folder / name).write_text("mine")
    with pytest.raises(CodegenError, match=name):
        export(cd.derive(arm()), folder, ["energy"])
    assert (folder / name).read_text() == "mine"
    assert (folder / "manifest.json").read_bytes() == before


def test_a_failure_leaves_nothing_behind(tmp_path: Path) -> None:
    with pytest.raises(DerivationError, match="Did you mean 'energy'"):
        export(cd.derive(arm()), tmp_path / "arm", ["enrgy"])
    with pytest.raises(DerivationError):
        export(cd.derive(arm()), tmp_path / "arm", ["bias", ("pose", "nowhere")])
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "file").write_text("x")
    with pytest.raises(CodegenError, match="is a file"):
        export(cd.derive(arm()), tmp_path / "file")
