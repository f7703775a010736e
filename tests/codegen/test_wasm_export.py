"""Exports as WebAssembly: node computes the bits of a native build; errors; names of any kind."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.codegen.languages import binding
from cardan.codegen.wasm import javascript
from cardan.codegen.writing import generate
from cardan.errors import CodegenError
from cardan.schema.functions import FUNCTIONS
from cardan.schema.manifest import from_file
from codegen.bindings import pushed, unit, wrist
from codegen.running import EXACT, call

NODE = shutil.which("node")
needs_node = pytest.mark.skipif(NODE is None, reason="node is not installed")
WORDS = "const words = (x) => [...new Uint32Array(Float64Array.from(x).buffer)];\n"


def told(folder: Path, program: str) -> Any:
    """What a program that has loaded an export prints, as JSON."""
    name = next(path.stem for path in folder.glob("*.mjs") if path.stem != "example")
    script = folder.parent / f"{folder.name}.mjs"
    head = f'import * as all from "./{folder.name}/{name}.mjs";\nconst model = await all.load();\n'
    script.write_text(head + WORDS + program, "utf-8")
    answer = subprocess.run(
        [str(NODE), str(script)], capture_output=True, text=True, check=False, encoding="utf-8"
    )
    assert answer.returncode == 0, answer.stderr
    return json.loads(answer.stdout)


def complaint(folder: Path, call: str) -> str:
    """Kind and message of the error of a call."""
    return str(
        told(
            folder,
            f"try {{ {call}; console.log('null'); }} catch (error) {{"
            "console.log(JSON.stringify(`${error.name}: ${error.message}`)); }",
        )
    )


def example(name: str) -> cd.Scene:
    return cd.load(cd.examples.path(name))


def chain() -> cd.Scene:
    """Balls and hinges, whose functions are loops over tables."""
    scene = cd.Scene("chain", gravity=(0, 0, -9.81))
    end = scene.ground
    for k in range(12):
        body = scene.body(f"b{k}", mass=1.0, com=(0, 0, -0.1), inertia=(0.1, 0.2, 0.15))
        joint = cd.Spherical() if k % 3 == 0 else cd.Revolute("y")
        scene.joint(f"j{k}", joint, end.at(0, 0, -0.2) if k else end, body)
        end = body
    return scene


DYNAMICS = ["forward_dynamics", "inverse_dynamics", "rhs", "mass_matrix", "bias", "energy"]
CLOSING = ["constraints", "constraint_rates", "constraint_jacobian", "close_velocity", "integrate"]
FRAME = [("pose", "hand"), ("velocity", "hand"), ("frame_jacobian", "hand")]
LINEAR = ("derivative", "forward_dynamics: q u p")
SCENES: dict[str, tuple[Any, list[Any]]] = {
    "double_pendulum": (example, [*DYNAMICS, ("pose", "lower"), ("reaction", "elbow"), LINEAR]),
    "four_bar": (example, [*DYNAMICS, *CLOSING]),
    "wrist": (lambda _: wrist(), [*DYNAMICS, "qdot", *FRAME, LINEAR]),
    "pushed": (lambda _: pushed(), ["rhs", "forward_dynamics", "energy"]),
    "quadrotor": (example, ["rhs", "mass_matrix", "outputs"]),
    "chain": (lambda _: chain(), [*DYNAMICS, ("pose", "b11")]),
    "bouncing_ball": (example, ["rhs", "events", "transition"]),
}


def bits(values: Any) -> list[int]:
    """Words of doubles."""
    return [int(word) for word in np.ravel(values).astype("<f8").view("<u4")]


@needs_node
@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
@pytest.mark.parametrize("name", SCENES)
def test_functions_have_the_bits_of_a_native_build(name: str, tmp_path: Path) -> None:
    build, functions = SCENES[name]
    equations = cd.derive(build(name))
    loops = True if name == "chain" else None
    folder = equations.export(tmp_path / "here", functions, language="wasm", loops=loops)
    manifest = from_file((folder / "manifest.json").read_bytes(), "manifest")
    sizes, rng = javascript._sizes(manifest), np.random.default_rng(7)
    given = {block: rng.uniform(-1, 1, size).tolist() for block, size in sizes.items()}
    given |= {block: unit(given[block], manifest.quaternions).tolist() for block in ("q", "q0")}
    given |= {"p": [float(row.default) for row in manifest.parameters], "e": [1.0] * sizes["e"]}
    given |= {"s": [float(row.default) for row in manifest.s]}
    given |= {"x": [*given["q"], *given["u"], *given["z"]], "zdot": []}
    calls, expected = [], []
    for one in functions:
        function, of = (one, None) if isinstance(one, str) else one
        written = generate(equations.form(function, of, loops), of=of)
        taken = binding.arguments(written.name, written.entry)
        calls.append([written.name, {x: given[x][0] if x == "t" else given[x] for x in taken}])
        answer = call(written, given, flags=EXACT)
        assert answer.status == 0
        assert np.isfinite(answer.out).all()
        expected.append(bits(answer.out))
    found = told(
        folder,
        f"const calls = {json.dumps(calls)};"
        "const flat = (x) => x instanceof Float64Array ? [...x]"
        " : typeof x === 'number' ? [x] : Object.values(x).flatMap(flat);"
        "console.log(JSON.stringify(calls.map(([f, blocks]) => words(flat(model[f](blocks))))));",
    )
    for (symbol, _), ours, theirs in zip(calls, found, expected, strict=True):
        assert ours == theirs, symbol
        assert len(ours) > 0


@needs_node
def test_several_results_are_an_object_by_name(tmp_path: Path) -> None:
    derivative = ("derivative", "forward_dynamics: q u p")
    folder = cd.derive(wrist()).export(tmp_path / "wrist", [derivative], language="wasm")
    model = cd.compile(wrist(), reproducible=True)
    q, u, tau = unit(np.array([0.9, 0.1, -0.2, 0.3, 0.4]), (0,)), np.full(4, 0.3), np.full(4, 1.5)
    expected = model.derivative("forward_dynamics", wrt=("q", "u", "p"))(q, u, tau=tau)
    blocks = json.dumps({"q": q.tolist(), "u": u.tolist(), "tau": tau.tolist()})
    found = told(
        folder,
        "const f = Object.getOwnPropertyNames(Object.getPrototypeOf(model))"
        ".find((name) => name.startsWith('derivative'));"
        f"const d = model[f]({blocks}), all_words = Object.values(d).map(words);"
        "console.log(JSON.stringify({ keys: Object.keys(d), words: all_words }));",
    )
    assert found["keys"] == ["d_q", "d_u", "d_p"]
    assert found["words"] == [bits(one) for one in expected]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    where = tmp_path_factory.mktemp("wasm") / "wrist"
    return cd.derive(wrist()).export(where, ["forward_dynamics", "rhs", "energy"], language="wasm")


@needs_node
def test_parameters_are_prepared_by_name_or_as_an_array(folder: Path) -> None:
    model = cd.compile(wrist(), reproducible=True)
    q, u = unit(np.array([0.9, 0.1, -0.2, 0.3, 0.4]), (0,)), np.full(4, 0.3)
    at = json.dumps({"q": q.tolist(), "u": u.tolist()})
    found = told(
        folder,
        f"const run = () => words(model.forward_dynamics({at})), before = run();"
        "const changed = [...all.START.p]; changed[all.PARAMETERS.indexOf('m')] = 3;"
        "const named = (model.prepare({ m: 3 }), run()), listed = (model.prepare(changed), run());"
        "const mapped = (model.prepare(new Map([['m', 3]])), run());"
        "const after = (model.prepare(), run());"
        "const other = await all.load(); other.prepare({ m: 5 });"
        "console.log(JSON.stringify({ before, named, listed, mapped, after, alone: run() }));",
    )
    usual = bits(model.forward_dynamics(q, u))
    heavy = bits(model.forward_dynamics(q, u, parameters={"m": 3.0}))
    assert usual != heavy
    assert found["before"] == found["after"] == found["alone"] == usual
    assert found["named"] == found["listed"] == found["mapped"] == heavy


@needs_node
def test_results_are_arrays_numbers_or_objects_of_their_own(folder: Path) -> None:
    found = told(
        folder,
        "const at = { q: {}, u: { 'elbow.u': 2 } }, energy = model.energy(at);"
        "const a = model.forward_dynamics(at), b = [...a];"
        "model.forward_dynamics({ ...at, u: [1, 2, 3, 4] });"
        "const x = [...all.START.q, ...all.START.u];"
        "const typed = { q: Float64Array.from(all.START.q), u: Float32Array.from([0, 0, 0, 2]) };"
        "const again = model.forward_dynamics(typed);"
        "console.log(JSON.stringify({ energy, same: b.every((v, k) => v === a[k]),"
        "typed: a instanceof Float64Array, xdot: model.rhs({ x }).length, names: all.SPEEDS,"
        "typed_given: words(again).join() === words(a).join() }));",
    )
    energy = cd.compile(wrist()).energy([1, 0, 0, 0, 0], [0, 0, 0, 2])
    assert found["energy"] == pytest.approx(dict(zip(energy._fields, energy, strict=True)))
    assert found["names"] == ["shoulder.u.x", "shoulder.u.y", "shoulder.u.z", "elbow.u"]
    assert found["same"]
    assert found["typed"]
    assert found["typed_given"]
    assert found["xdot"] == 9


REFUSED = {
    "model.forward_dynamics()": "TypeError: forward_dynamics: give an object { t: ..., q: ...",
    "model.forward_dynamics([1, 2])": "TypeError: forward_dynamics: give an object",
    "model.forward_dynamics({ q: {} })": "TypeError: forward_dynamics needs u",
    "model.forward_dynamics({ q: {}, u: {}, qq: [] })": "forward_dynamics takes no 'qq'. Known: "
    "t, q",
    "model.forward_dynamics({ q: [1, 0], u: {} })": "RangeError: forward_dynamics: q has length 2, "
    "not 5: shoulder.qw, shoulder.qx",
    "model.forward_dynamics({ q: {}, u: [0, 0, NaN, 0] })": "TypeError: forward_dynamics: u[2] "
    "(shoulder.u.z) is NaN. Every number given must be finite",
    "model.forward_dynamics({ q: {}, u: [0, 0, , 0] })": "u[2] (shoulder.u.z) is of type undefined",
    "model.forward_dynamics({ q: {}, u: [0, 0, '1', 0] })": "u[2] (shoulder.u.z) is of type string",
    "model.forward_dynamics({ q: {}, u: { elbow: 1 } })": 'forward_dynamics: u has no "elbow". '
    "Known: shoulder.u.x, ",
    "model.forward_dynamics({ q: {}, u: {}, t: [1] })": "forward_dynamics: t is of type object",
    "model.forward_dynamics({ q: {}, u: 3 })": "TypeError: forward_dynamics: u: give an array of 4 "
    "numbers, or an object with values by name",
    "model.rhs({ x: {} })": "TypeError: rhs: x: give an array of 9 numbers",
    "model.prepare({ mas: 2 })": 'TypeError: prepare: p has no "mas". Known: m, k',
    "model.prepare({ m: Infinity })": "prepare: p[0] (m) is Infinity",
    "model.prepare([1])": "RangeError: prepare: p has length 1",
    "model.prepare({ ['__proto__']: 1 })": 'p has no "__proto__"',
    "model.forward_dynamics({ q: {}, u: {}, ['__proto__']: 1 })": "takes no '__proto__'",
}


@needs_node
def test_wrong_blocks_are_errors_that_name_the_function(folder: Path) -> None:
    for wrong, message in REFUSED.items():
        assert message in complaint(folder, wrong), wrong


@needs_node
def test_what_has_no_solution_is_an_error_and_the_next_call_is_none(tmp_path: Path) -> None:
    scene = cd.Scene("light", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 1.0)
    body = scene.body("body", mass=m)
    scene.joint("slide", cd.Prismatic("z"), scene.ground, body)
    folder = cd.derive(scene).export(tmp_path / "light", ["forward_dynamics"], language="wasm")
    udot = "model.forward_dynamics({ q: {}, u: {} })"
    message = complaint(folder, f"model.prepare({{ m: 0 }}); {udot}")
    assert message.startswith("SolveError: forward_dynamics has no finite result")
    good = f"try {{ model.prepare({{ m: 0 }}); {udot}; }} catch {{ model.prepare(); }}"
    assert told(folder, f"{good} console.log(JSON.stringify([...{udot}]))") == [-9.81]


HOSTILE = (
    '"; throw 1; "',
    "'); throw 1; ('",
    "`${(() => { throw 1; })()}`",
    "</script><script>throw 1</script>",
    "<!--",
    "*/ throw 1; /*",
    "line\u2028throw 1\u2029",
    "new\nthrow 1\r//",
    "back\\",
    "\\u0022; throw 1; //",
    "__proto__",
    "constructor",
    "ünïcode 関節",
)


@needs_node
def test_names_are_data(tmp_path: Path) -> None:
    scene = cd.Scene("".join(HOSTILE[:6]), gravity=(0, 0, -9.81))
    before, accepted = scene.ground, []
    for k, name in enumerate(HOSTILE):
        try:
            mass = scene.parameter(name, 1.0 + k)
        except cd.ModelError:
            # some are no names of parameters; bodies and joints may have them all the same
            mass = 1.0 + k
        else:
            accepted.append(name)
        try:
            body = scene.body(name, mass=mass, inertia=(1, 1, 1))
            scene.joint(f"{name} joint", cd.Revolute("y"), before, body)
        except cd.ModelError:
            continue
        before = body
    equations = cd.derive(scene)
    bodies = [part for body in equations.system.bodies for part in [body.name]]
    assert len(bodies) > 4
    functions = ["forward_dynamics", *(("pose", name) for name in bodies)]
    folder = equations.export(tmp_path / "hostile", functions, language="wasm")
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    found = told(
        folder,
        "const p = Object.fromEntries(all.PARAMETERS.map((name, k) => [name, all.START.p[k]]));"
        "model.prepare(p);"
        "const q = Object.fromEntries(all.COORDINATES.map((name) => [name, 0.1]));"
        "console.log(JSON.stringify({ name: all.NAME, p: all.PARAMETERS, q: all.COORDINATES,"
        "bodies: all.BODIES, udot: [...model.forward_dynamics({ q, u: {} })],"
        "poses: Object.getOwnPropertyNames(Object.getPrototypeOf(model))"
        ".filter((name) => name.startsWith('pose__')).map((f) => model[f]({ q }).length) }));",
    )
    for key, block in {"p": "parameters", "q": "coordinates"}.items():
        assert found[key] == [row["name"] for row in manifest[block]]
    assert found["name"] == scene.name
    assert found["bodies"] == bodies
    assert {*accepted} <= {*found["p"]}
    n = len(found["q"])
    udot = cd.compile(scene, reproducible=True).forward_dynamics(np.full(n, 0.1), np.zeros(n))
    assert bits(found["udot"]) == bits(udot)
    assert found["poses"] == [16] * len(bodies)
    for path in folder.glob("*.mjs"):
        text = path.read_text("utf-8")
        # a script that stands in a page goes on
        assert not re.search(r"</|<!|<script", text, re.IGNORECASE), path.name
        assert "\u2028" not in text


@needs_node
@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
@pytest.mark.parametrize("name", ["double_pendulum", "bouncing_ball"])
def test_the_example_and_that_of_the_readme_run(name: str, tmp_path: Path) -> None:
    folder = cd.derive(example(name)).export(tmp_path / name, language="wasm")
    (folder / "readme.mjs").write_text(
        re.findall(r"```js\n(.*?)```", (folder / "README.md").read_text("utf-8"), re.DOTALL)[0],
        "utf-8",
    )
    outputs = []
    for script in ("example.mjs", "readme.mjs"):
        run = subprocess.run(
            [str(NODE), script], cwd=folder, capture_output=True, text=True, check=False
        )
        assert run.returncode == 0, run.stderr
        outputs.append(run.stdout)
    assert outputs[0].startswith("Float64Array(")
    assert outputs[1].startswith(outputs[0].strip())


def test_files_are_those_of_the_manifest_and_an_export_is_replaced(tmp_path: Path) -> None:
    for functions in (["rhs", "energy"], ["energy"]):
        folder = cd.derive(wrist()).export(tmp_path / "wrist", functions, language="wasm")
        names = {path.name for path in folder.iterdir()} - {"manifest.json"}
        stated = json.loads((folder / "manifest.json").read_text("utf-8"))["sha256"]
        assert names == {*stated}
        assert {"wrist.wasm", "functions.wasm", "wrist.mjs", "example.mjs"} <= names
    assert "rhs.c" not in names


def test_the_same_equations_give_the_same_bytes(tmp_path: Path) -> None:
    folders = [
        cd.derive(wrist()).export(tmp_path / name, ["rhs"], language="wasm") for name in "ab"
    ]
    for name in ("wrist.wasm", "wrist.mjs"):
        first, second = ((folder / name).read_bytes() for folder in folders)
        assert first == second


@pytest.mark.parametrize("name", ["functions", "example"])
def test_names_of_files_do_not_collide(name: str, tmp_path: Path) -> None:
    scene = cd.Scene(name)
    scene.joint("slide", cd.Prismatic("z"), scene.ground, scene.body("body", mass=1.0))
    folder = cd.derive(scene).export(tmp_path / name, ["rhs"], language="wasm")
    assert (folder / f"{name}_model.mjs").exists()
    if NODE:
        assert told(folder, "console.log(JSON.stringify([...model.rhs({ x: [0, 1] })]))")[0] == 1


def test_no_function_is_called_as_what_the_module_has_itself() -> None:
    assert not {"prepare", "constructor", "load"} & {*FUNCTIONS}


@pytest.mark.parametrize(
    ("options", "cure"),
    [
        ({"integrators": ["dop853"]}, "cd.page"),
        ({"prefix": "arm_"}, "language='c'"),
        ({"precision": "single"}, "language='c'"),
    ],
)
def test_options_that_do_not_apply_are_refused_with_a_cure(
    options: dict[str, Any], cure: str, tmp_path: Path
) -> None:
    with pytest.raises(CodegenError, match=re.escape(cure)):
        cd.derive(wrist()).export(tmp_path / "out", language="wasm", **options)
    assert not (tmp_path / "out").exists()


def test_elements_are_refused_with_a_cure(tmp_path: Path) -> None:
    equations = cd.derive(example("flexible_arm"))
    with pytest.raises(CodegenError, match=r"absolute coordinates.*language='c'"):
        equations.export(tmp_path / "out", language="wasm")


def test_no_compiler_is_needed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    node = NODE
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    folder = cd.derive(wrist()).export(tmp_path / "wrist", ["bias"], language="wasm")
    if node:
        at = "{ q: { 'shoulder.qw': 1 }, u: {} }"
        assert len(told(folder, f"console.log(JSON.stringify([...model.bias({at})]))")) == 4
