"""Models drawn by chance under the address and undefined-behavior sanitizers of the compiler."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from functools import partial
from itertools import cycle
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.simulation import run_record
from cardan.codegen.export import companions
from cardan.runtime.build import cache, prebuilt, single_sources
from cardan.schema import kernel_files
from combinations.features import mechanism
from kernels.sanitized import program
from mechanisms import ZOO
from mechanisms.flexible import folding_arm
from mechanisms.random_trees import random_tree
from spread import some

FLAGS = ("-std=c99", "-O0", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
# an order in which scenes meet methods that can run them to 9 digits; what is new follows
KNOWN = ("dop853", "radau", "rosenbrock", "alpha", "rk4", "rk45", "midpoint")
METHODS = (*KNOWN, *sorted({*companions.INTEGRATORS} - {*KNOWN}))
COUNT = 7
SEED = 20
DYNAMICS = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "energy", "power")
MOTION = ("pose", "velocity", "acceleration", "frame_jacobian")


def drawn() -> list[str]:
    """Five of the zoo, of whose many ball joints two are enough, and five trees."""
    rng = np.random.default_rng(SEED)
    balls = sorted(name for name in ZOO if name.startswith("spherical_"))
    pool = [*balls[::20], *sorted(set(ZOO) - set(balls))]
    return [*rng.choice(pool, 5, replace=False).tolist(), *(f"tree {k}" for k in range(5))]


@pytest.fixture(scope="module")
def sanitizers(tmp_path_factory: pytest.TempPathFactory) -> None:
    """A compiler that has them and finds with them a write past the end."""
    place = tmp_path_factory.mktemp("probe")
    (place / "a.c").write_text(
        "#include <stdlib.h>\nint main(int n, char **v) { (void)v; double *p = malloc(8);"
        " p[n] = 1; double x = p[n]; free(p); return x > 2; }\n"
    )
    done = built(place, [place / "a.c"])
    if done is None:
        pytest.skip("this compiler has no sanitizers")
    assert done.returncode
    assert "a.c:2" in done.stderr


def built(place: Path, sources: list[Path], *more: str) -> subprocess.CompletedProcess[str] | None:
    """What a program does under the sanitizers; None where it cannot be linked with them."""
    target = place / "sanitized"
    made = compiled(*more, "-o", str(target), *map(str, sources), "-lm")
    if made.returncode:
        assert "san" in made.stderr, made.stderr
        return None
    # leaks are none of C that allocates nothing; a traced process cannot look for them
    options = os.environ | {"ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1"}
    return subprocess.run([str(target)], capture_output=True, text=True, timeout=300, env=options)


def unset() -> tuple[str, ...]:
    """Flag that fills what C leaves unset with a pattern, where the compiler has it."""
    flag = "-ftrivial-auto-var-init=pattern"
    command = [*cache.compiler().command, flag, "-fsyntax-only", "-xc", os.devnull]
    known = subprocess.run(command, capture_output=True, check=False).returncode == 0
    return (flag,) if known else ()


def compiled(*words: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    command = [
        *cache.compiler().command,
        *FLAGS,
        *words,
        *(f"-I{folder}" for folder in kernel_files.includes()),
    ]
    return subprocess.run(command, capture_output=True, text=True, timeout=600, cwd=cwd)


def rubbing() -> cd.Scene:
    """A beam, and friction by a reaction: matrices that are not symmetric."""
    return mechanism(("friction from reaction", "beam")).scene


CLEAN = [(rubbing, "radau"), (partial(folding_arm, 2), "alpha"), (rubbing, "alpha")]


@pytest.mark.parametrize(("scene", "method"), some(CLEAN, 3))
def test_exported_elements_are_clean(
    scene: Callable[[], cd.Scene], method: str, tmp_path: Path, sanitizers: None
) -> None:
    """Tables, plan and run of a beam and bodies, on a stack without a zero."""
    folder = cd.derive(scene()).export(tmp_path / "c", integrators=(method,))
    sources = sorted(folder.glob("*.c"))
    done = built(tmp_path, sources, f"-I{folder}", "-DCARDAN_EXAMPLE", "-DSTEP=1e-3", *unset())
    assert done is not None
    assert done.stderr == ""
    assert done.returncode == 0
    assert "x[0]" in done.stdout


DRAWN = enumerate(zip(drawn(), cycle(METHODS), strict=False))
CASES = some(((name, k % 2 == 1, method) for k, (name, method) in DRAWN), 5)


@pytest.mark.parametrize(("name", "loops", "method"), CASES)
def test_clean_and_the_same_numbers(
    name: str, loops: bool, method: str, tmp_path: Path, sanitizers: None
) -> None:
    """A simulation by an integrator, then every function at some states."""
    scene = ZOO[name].build() if name in ZOO else random_tree(int(name.split()[1]))
    equations = cd.derive(scene)
    model = cd.compile(equations, loops=loops)
    functions = [f for f in DYNAMICS if f in model.manifest["available"]]
    body, joint = model.bodies[-1], model.joints[0]
    asked = [*functions, *((f, body) for f in MOTION), ("reaction", joint)]
    folder = equations.export(
        tmp_path / "model", asked, language="c", integrators=[method], loops=loops
    )
    # once for both programs
    sources = [path.name for path in sorted(folder.glob("*.c")) if path.name != "example.c"]
    made = compiled("-c", f"-I{folder}", *sources, cwd=folder)
    assert made.returncode == 0, made.stderr
    objects = sorted(folder.glob("*.o"))
    example = [folder / "example.c", *objects]
    done = built(tmp_path, example, f"-I{folder}", "-DCARDAN_EXAMPLE")
    assert done is not None
    assert done.stderr == ""
    assert done.returncode == 0

    exported = cd.load_model(folder)
    rng = np.random.default_rng(SEED)
    q, u = model.split(model.random_state(rng, (COUNT,)))
    parts = 6 * len(model.bodies)
    given = {
        "t": np.full((COUNT, 1), 0.3),
        "q": q,
        "u": u,
        "r": np.zeros((COUNT, model.nr)),
        "udot": rng.uniform(-1, 1, u.shape),
        "tau": rng.uniform(-1, 1, u.shape),
        "du": rng.uniform(-1, 1, u.shape),
        "q0": q[::-1].copy(),
        "lam": np.zeros((COUNT, 0)),
        "wrench": np.zeros((COUNT, parts)),
        "z": np.zeros((COUNT, 0)),
        "s": np.zeros((COUNT, 0)),
    }
    names = list(exported.manifest["functions"])
    main = tmp_path / "main.c"
    main.write_text(program(exported.manifest, names, given, model.parameters.vector))
    done = built(tmp_path, [main, kernel_files.file("map.c"), *objects], f"-I{folder}")
    assert done is not None
    assert done.stderr == ""
    assert done.returncode == 0
    found = np.array(done.stdout.split(), dtype=float)
    sizes = [COUNT * exported.manifest["functions"][n]["output_size"] for n in names]
    assert found.size == sum(sizes)
    results = dict(zip(names, np.split(found, np.cumsum(sizes)[:-1]), strict=True))
    # other flags round differently: by the condition of M where a system is solved
    M = model.mass_matrix(q)
    loose = 1e-12 * max(1.0, float(np.linalg.cond(M).max()))
    expected = {
        "mass_matrix": (M, 1e-12),
        "energy": (np.stack(model.energy(q, u, t=0.3), axis=-1), 1e-12),
        "forward_dynamics": (model.forward_dynamics(q, u, tau=given["tau"], t=0.3), loose),
        "inverse_dynamics": (model.inverse_dynamics(q, u, given["udot"], t=0.3), 1e-12),
    }
    for function, (known, bound) in expected.items():
        scale = np.abs(known).max()
        error = np.abs(results[function] - known.reshape(-1)).max()
        assert error <= bound * scale, function


# rows and columns of every size and number, in arrays without a number to spare; a state without a
# result, which is done again alone
BATCH = """
#include "batch.h"
#include <stdio.h>
#include <stdlib.h>

static size_t size;

static int f(const cardan_in *in, real *out, real *work)
{
    int status = 0;
    (void)work;
    for (size_t k = 0; k < size; ++k) out[k] = in->q[k] + in->u[k] * in->udot[k];
    for (int j = 0; j < CARDAN_LANES; ++j) status |= in->q[0][j] < 0;
    return status;
}

static int single(const CARDAN_WIDE *const *in, CARDAN_WIDE *out, CARDAN_WIDE *work)
{
    (void)work;
    for (size_t k = 0; k < size; ++k) out[k] = in[1][k] + in[2][k] * in[8][k];
    return in[1][0] < 0;
}

/* numbers of n states of `size` entries */
static double *filled(size_t n, size_t entries, size_t period)
{
    double *x = malloc(n * entries * sizeof(double));
    for (size_t i = 0; i < n * entries; ++i) x[i] = (double)(i % period);
    return x;
}

static int tried(size_t n, int order, int fails)
{
    const size_t whole = (size + CARDAN_LANES - 1) / CARDAN_LANES * CARDAN_LANES;
    /* by bits: whether x, v and the result lie entry by entry */
    const size_t x_stride = order & 1 ? 1 : 2 * size, x_spacing = order & 1 ? n : 1;
    const size_t v_stride = order & 2 ? 1 : size, v_spacing = order & 2 ? n : 1;
    const size_t stride = order & 4 ? 1 : size, spacing = order & 4 ? n : 1, bad = n / 2;
    double *x = filled(n, 2 * size, 97), *v = filled(n, size, 89), *out = filled(n, size, 7);
    double *memory = NULL;
    if (posix_memalign((void **)&memory, 64, 13 * whole * sizeof(real) + 4 * size * 8)) return 1;
    if (fails) x[bad * x_stride] = -1;
    const double *blocks[17] = {NULL, x, x + size * x_spacing, [8] = v};
    const size_t strides[18] = {0, x_stride, x_stride, [8] = v_stride, [17] = stride};
    const size_t spacings[18] = {0, x_spacing, x_spacing, [8] = v_spacing, [17] = spacing};
    const size_t sizes[18] = {0, size, size, [8] = size, [17] = size};
    ptrdiff_t failed;
    int finite = 0;
    const int status = cardan_batch(f, single, blocks, strides, spacings, sizes, n, out, 0, memory,
                                    &failed, &finite);
    int wrong = status != fails || finite == fails || failed != (fails ? (ptrdiff_t)bad : -1);
    for (size_t i = 0; i < n; ++i)
        for (size_t k = 0; k < size; ++k) {
            const double *q = x + i * x_stride + k * x_spacing, *u = q + size * x_spacing;
            const double value = out[i * stride + k * spacing];
            const double expected = *q + *u * v[i * v_stride + k * v_spacing];
            wrong += fails && i == bad ? value == value : value != expected;
        }
    free(x);
    free(v);
    free(out);
    free(memory);
    return wrong;
}

int main(void)
{
    int wrong = 0;
    for (size = 1; size < 20; ++size)
        for (size_t n = 1; n < 6 * CARDAN_LANES; n += n < 40 ? 1 : 5)
            for (int order = 0; order < 8; ++order)
                wrong += tried(n, order, 0) + tried(n, order, 1);
    printf("%d", wrong);
    return 0;
}
"""


@pytest.mark.parametrize(
    ("lanes", "single"), some([(2, False), (8, False), (16, True), (4, False), (8, True)], 5, 3)
)
def test_batches_stay_inside_their_arrays(
    lanes: int, single: bool, tmp_path: Path, sanitizers: None
) -> None:
    main, includes = tmp_path / "main.c", kernel_files.includes()
    main.write_text("#define _POSIX_C_SOURCE 200112L\n" + BATCH)
    sources = [main, kernel_files.file("batch.c")]
    flags = (f"-DCARDAN_LANES={lanes}", "-march=native")
    if single:
        with single_sources.written(sources, includes) as (floats, (folder,)):
            done = built(tmp_path, floats, f"-I{folder}", *flags, *prebuilt.FLOATS)
    else:
        done = built(tmp_path, sources, *flags)
    assert done is not None
    assert (done.returncode, done.stderr, done.stdout) == (0, "", "0")


# a ball that bounces until its bounces cannot be told apart, and a mark that dips between samples
BALL = """
#include "run.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int rhs(const cardan_in *in, real *out, real *work)
{
    (void)work;
    out[0] = in->u[0];
    out[1] = -9.81;
    out[2] = in->s[0] - in->z[0];
    return 0;
}

static int events(const cardan_in *in, real *out, real *work)
{
    (void)work;
    out[0] = in->q[0];
    out[1] = 1;
    out[2] = 1e-7 + (in->t[0] - 0.1) * (in->t[0] - 0.1) * 40 - 2e-7;
    return 0;
}

static int transition(const cardan_in *in, real *out, real *work)
{
    (void)work;
    out[0] = in->e[0] != 0 ? -0.5 * in->u[0] : in->u[0];
    out[1] = in->z[0];
    out[2] = in->s[0] + (in->e[1] != 0);
    return 0;
}

int main(void)
{
    static const ptrdiff_t kinds[] = {CARDAN_IMPACT, CARDAN_TICK, CARDAN_MARK};
    cardan_tick tick = {.event = 1, .period = 0.25, .phase = 0};
    const real end = 3;
    cardan_run run = {0};
    size_t length;
    int status;

    CARDAN_METHOD(&run, dop853);
    run.rhs.function = rhs, run.events.function = events, run.transition.function = transition;
    run.nq = run.nu = run.nz = run.ns = 1;
    run.nx = run.n = 3;
    run.rtol = 1e-9, run.atol = 1e-12, run.max_step = INFINITY, run.budget = 100;
    run.stops = &end, run.stop_count = 1;
    run.ne = 3, run.kinds = kinds, run.ticks = &tick, run.tick_count = 1;
    run.log_capacity = 200;
    length = cardan_run_length(&run, 1, 0);
    real *memory = malloc(length * sizeof(real)), *log = malloc(200 * 12 * sizeof(real));
    run.log = log;
    cardan_run_lay(&run, memory, 1, 0);
    run.y[0] = 1;
    status = cardan_run_start(&run);
    while (status == 0 || status == CARDAN_MORE || status == CARDAN_FULL) {
        status = cardan_run_drive(&run);
        for (ptrdiff_t k = 0; k < run.log_count; k++)
            printf("%.12f %g %g %g\\n", log[12 * k], log[12 * k + 1], log[12 * k + 2],
                   log[12 * k + 3]);
        run.log_count = 0;
        if (status == CARDAN_DONE)
            break;
    }
    free(memory);
    free(log);
    printf("%d\\n", status);
    return 0;
}
"""


def test_events_stay_inside_their_arrays(tmp_path: Path, sanitizers: None) -> None:
    main = tmp_path / "ball.c"
    main.write_text(BALL)
    kernels = [name for name in companions.kernels(("dop853",), False) if name.endswith(".c")]
    done = built(tmp_path, [main, *(kernel_files.file(name) for name in kernels)])
    assert done is not None
    assert done.stderr == ""
    *lines, status = done.stdout.split("\n")[:-1]
    assert int(status) == run_record.CHATTER
    rows = np.array([[float(word) for word in line.split()] for line in lines])
    fall = np.sqrt(2 / 9.81)
    bounces = fall + np.concatenate([[0.0], np.cumsum(2 * fall * 0.5 ** np.arange(1, 20))])
    np.testing.assert_allclose(rows[rows[:, 1] > 0, 0][:20], bounces, rtol=0, atol=1e-11)
    # samples until the bounces end, which is after 3 times the fall
    np.testing.assert_array_equal(rows[rows[:, 2] > 0, 0], np.arange(0, 3 * fall, 0.25))
    np.testing.assert_allclose(rows[rows[:, 3] > 0, 0], 0.1 - np.sqrt(1e-7 / 40), rtol=1e-9)


# what is asked while a memory is measured
MEASURED = """
#include "export.h"

int main(void)
{
    const cardan_exported_function functions[] = {{.w = 3}, {.w = 2}};
    const cardan_export model = {.functions = functions, .function_count = 2};

    return cardan_prepared_w(&model, NULL, 1) != NULL;
}
"""


def test_nothing_lies_behind_a_memory_that_is_measured(tmp_path: Path, sanitizers: None) -> None:
    main = tmp_path / "main.c"
    main.write_text(MEASURED)
    done = built(tmp_path, [main, kernel_files.file("export.c")])
    assert done is not None
    assert (done.returncode, done.stderr) == (0, "")
