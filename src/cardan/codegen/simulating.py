"""The part of an exported example that simulates: a run in C, over events where there are any."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..schema.integrators import KERNELS

# what a run of a closed system calls beside rhs
CLOSING = ("close_position", "close_velocity", "constraint_jacobian")
# what a run of a system with events must call, and when
HAPPENING = ("events", "transition")
# rows of the log of events, and more per event
LOG, ROOM = 256, 32


def simulation(method: str, manifest: dict[str, Any]) -> str:
    """A function that runs one second from the start, prints events, and the state at the end."""
    called = _called(method, manifest)
    closed = called[: len(called) - len(KERNELS[method].needs)]
    work = "rhs_work_size" + "".join(f" + {name}_work_size" for name in called)
    rooms = "".join(f", w_{name}[{name}_w_size + 1]" for name in called)
    lines = [f"    prepare_{name}(cardan_default_p, w_{name});" for name in called]
    lines += [f"    run.{name}.function = {name}, run.{name}.w = w_{name};" for name in called]
    if any(name in CLOSING for name in closed):
        rows = [row["level"] for row in manifest["multipliers"]]
        lines.append(f"    run.positions = {rows.count('position')}, run.rates = {len(rows)};")
        lines.append("    run.size = 1.0;")
    events = manifest["events"] if "events" in called else []
    if events:
        lines.append("    run.ne = EVENTS, run.kinds = kinds, run.ticks = ticks;")
        lines.append(f"    run.tick_count = {len(manifest['ticks'])};")
        lines.append("    run.log = log, run.log_capacity = LOG;")
    connected = "".join(f"{line}\n" for line in lines)
    z, modes = len(manifest["z"]), len(manifest["s"])
    more = (f" + {z}, run.nz = {z}" if z else "") + (f", run.ns = {modes}" if modes else "")
    starts = "".join(_starts(manifest))
    return f"""\
{_happening(manifest) if events else ""}\
/* One second of motion from the start, printed at its end. */
static int simulate(void)
{{
    static real memory[100000], w[rhs_w_size + 1]{rooms};
{_tables(manifest) if events else ""}\
    const size_t rest = cardan_nu + 6 * cardan_nparts, work = {work};
    const real end = 1.0;
    cardan_run run = {{0}};

    prepare_rhs(cardan_default_p, w);
    CARDAN_METHOD(&run, {method});
    run.rhs.function = rhs, run.rhs.w = w, run.nr = cardan_nr;
    run.nq = cardan_nq, run.nu = cardan_nu, run.nx = run.n = cardan_nq + cardan_nu{more};
    run.rtol = 1e-9, run.atol = 1e-12, run.max_step = end, run.h = 1e-3, run.budget = 1000000;
    run.stops = &end, run.stop_count = 1;
{connected}\
    if (cardan_run_length(&run, rest, work) > sizeof memory / sizeof *memory) {{
        fprintf(stderr, "simulate: make the array memory larger\\n");
        return 1;
    }}
    cardan_run_lay(&run, memory, rest, work);
    for (int k = 0; k < cardan_nq; k++)
        run.y[k] = cardan_default_q[k];
    for (int k = 0; k < cardan_nr; k++)
        run.r[k] = cardan_default_r[k];
{starts}\
    int status = cardan_run_start(&run);
{DRIVE_OVER_EVENTS if events else DRIVE}\
    for (int k = 0; k < run.nx; k++)
        printf("x[%d] = %.17g\\n", k, run.y[k]);
{MODES if modes else ""}\
    return status{" == CARDAN_EVENT ? 0 : status" if events else ""};
}}
"""


DRIVE = """\
    if (status == CARDAN_DONE)
        status = cardan_run_drive(&run);
"""
DRIVE_OVER_EVENTS = """\
    while (status == CARDAN_DONE || status == CARDAN_MORE || status == CARDAN_FULL) {
        status = cardan_run_drive(&run);
        tell(&run);
        if (status == CARDAN_DONE)
            break;
    }
"""
MODES = """\
    for (int k = 0; k < run.ns; k++)
        printf("s[%d] = %.17g\\n", k, run.s[k]);
"""


def _called(method: str, manifest: dict[str, Any]) -> list[str]:
    """Functions that the run calls beside rhs: those that close, those of events, the method's."""
    there = manifest["functions"]
    closed = [name for name in CLOSING if name in there and manifest["multipliers"]]
    if not any(row["level"] == "position" for row in manifest["multipliers"]):
        # modes alone hold velocities
        closed = [name for name in closed if name != "close_position"]
    happening = HAPPENING if manifest.get("events") and set(HAPPENING) <= set(there) else ()
    return [*closed, *happening, *KERNELS[method].needs]


def _happening(manifest: dict[str, Any]) -> str:
    """What tells of events: their names, and a function that prints and empties the log."""
    names = "".join(f"    {_literal(row['name'])},\n" for row in manifest["events"])
    count, modes = len(manifest["events"]), [row["name"] for row in manifest["s"]]
    rows = []
    for row in manifest["events"]:
        mode, value = next(iter(row.get("decides", {}).items()), ("", 0.0))
        rows.append(f"{{{modes.index(mode) if mode else -1}, {float(value)!r}}}")
    decides = ", ".join(rows)
    return f"""\
enum {{ EVENTS = {count}, LOG = {LOG + ROOM * count} }};
static const char *const names[EVENTS] = {{
{names}}};
/* the mode and its value from which it is no event but the first decision; -1: always one */
static const struct {{ ptrdiff_t mode; real value; }} decides[EVENTS] = {{{decides}}};

/* Print what happened, and empty the log: rows of t, 1 for every event, [x, s] before, behind. */
static void tell(cardan_run *run)
{{
    const ptrdiff_t half = run->nx + run->ns;

    for (ptrdiff_t k = 0; k < run->log_count; k++) {{
        const real *row = run->log + k * (1 + EVENTS + 2 * half), *s = row + 1 + EVENTS + run->nx;
        for (ptrdiff_t i = 0; i < EVENTS; i++) {{
            const ptrdiff_t mode = decides[i].mode;
            const int first = mode >= 0 && s[mode] == decides[i].value;
            if (row[1 + i] != 0 && run->kinds[i] != CARDAN_TICK && !first)
                printf("event at %.17g: %s\\n", row[0], names[i]);
        }}
    }}
    run->log_count = 0;
}}

"""


def _tables(manifest: dict[str, Any]) -> str:
    """Kinds, ticks and room for the log."""
    kinds = ", ".join(f"CARDAN_{row['kind'].upper()}" for row in manifest["events"])
    ticks = ", ".join(
        f"{{.event = {tick['event']}, .period = {float(tick['period'])!r}, "
        f".phase = {float(tick['phase'])!r}}}"
        for tick in manifest["ticks"]
    )
    width = len(manifest["coordinates"]) + len(manifest["speeds"]) + len(manifest["z"])
    width = 1 + len(manifest["events"]) + 2 * (width + len(manifest["s"]))
    return f"""\
    static const ptrdiff_t kinds[EVENTS] = {{{kinds}}};
    static cardan_tick ticks[] = {{{ticks or "{0}"}}};
    static real log[LOG * {width}];
"""


def _literal(text: str) -> str:
    """A string of C."""
    plain = "".join(c if c.isascii() and c.isprintable() else "?" for c in text)
    return '"' + plain.replace("\\", "\\\\").replace('"', '\\"').replace("?", "\\?") + '"'


def _starts(manifest: dict[str, Any]) -> Iterator[str]:
    """Assignments of speeds that the scene gives, and of what elements keep."""
    for joint in manifest["joints"]:
        for place, value in zip(joint["u"] or (), joint["u0"] or (), strict=False):
            yield f"    run.y[cardan_nq + {place}] = {float(value)!r};\n"
    for k, row in enumerate(manifest["z"]):
        yield f"    run.y[cardan_nq + cardan_nu + {k}] = {float(row['default'])!r};\n"
    for k, row in enumerate(manifest["s"]):
        yield f"    run.s[{k}] = {float(row['default'])!r};\n"
