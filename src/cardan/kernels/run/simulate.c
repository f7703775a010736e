/* A run of an exported model, in joint coordinates or of elements in tables.
 *
 * Part of cardan. Caller owns all memory; see simulate.h.
 */
#include "simulate.h"
#include "jumps.h"
#include <math.h>

/* rows of the log of events, and more per event; steps between two looks at it */
enum { LOG = 256, ROOM = 32, BUDGET = 1000000, OPTIONS = 7 };
static const real USUAL_RHO_INF = 0.8; /* RHO_INF alone is what example.c lets compilers define */

/* Reserve the next part of a memory; where that is NULL it is only measured. */
static void *reserve(char *memory, size_t *used, size_t size)
{
    void *start = memory ? memory + *used : NULL;

    *used += (size + sizeof(real) - 1) / sizeof(real) * sizeof(real);
    return start;
}

static const cardan_exported_method *method_of(const cardan_export *model, const char *name)
{
    for (ptrdiff_t k = 0; k < model->method_count; k++)
        if (!name || strcmp(name, model->methods[k].name) == 0)
            return &model->methods[k];
    return NULL;
}

/* Connect the functions of the model that a run calls. */
static void connect(const cardan_export *model, const void *prepared, cardan_run *run)
{
    const struct { const char *name; cardan_call *call; ptrdiff_t wanted; } calls[] = {
        {"rhs", &run->rhs, 1},
        {"energy", &run->energy, 1},
        {"rhs_jacobian", &run->rhs_jacobian, 1},
        {"balance", &run->balance, 1},
        {"balance_tangent", &run->balance_tangent, 1},
        {"internal_rates", &run->internal_rates, model->nz},
        {"move", &run->move, 1},
        {"qdot", &run->qdot, 1},
        {"close_position", &run->close_position, model->positions},
        {"close_velocity", &run->close_velocity, model->rates},
        {"constraint_jacobian", &run->constraint_jacobian, model->rates},
        {"events", &run->events, model->event_count},
        {"transition", &run->transition, model->event_count},
    };

    for (ptrdiff_t k = 0; k < model->function_count; k++)
        for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
            if (calls[i].wanted > 0 && strcmp(model->functions[k].name, calls[i].name) == 0) {
                calls[i].call->function = model->functions[k].function;
                calls[i].call->w = cardan_prepared_w(model, prepared, k);
            }
}

/* Fill in what a run takes from the model. */
static void describe(const cardan_export *model, cardan_run *run)
{
    run->nq = model->nq, run->nu = model->nu, run->nz = model->nz;
    run->nx = run->n = model->nq + model->nu + model->nz;
    run->nr = model->nr, run->ns = model->ns, run->ne = model->event_count;
    run->quaternions = model->quaternions, run->quaternion_count = model->quaternion_count;
    run->mesh = model->mesh;
    run->positions = model->positions, run->rates = model->rates;
    run->size = model->size, run->columns = model->columns;
    run->kinds = model->kinds, run->tick_count = model->tick_count;
    run->log_capacity = model->event_count > 0 ? LOG + ROOM * model->event_count : 0;
}

/* Fill in how to step. */
static void choose(const cardan_exported_method *method, const cardan_simulation *settings, cardan_run *run)
{
    const double step = settings->step > 0 ? settings->step : method->step;

    cardan_take_method(run, method->method);
    run->charted = method->charted && run->quaternion_count > 0;
    run->on_grid = step > 0, run->h = step;
    run->rtol = step > 0 ? 0 : settings->rtol > 0 ? settings->rtol : method->rtol;
    run->atol = step > 0 ? 1 : settings->atol > 0 ? settings->atol : method->atol;
    run->max_step = INFINITY, run->budget = BUDGET, run->culprit = -1;
    run->inputs = settings->inputs, run->input_context = settings->context;
    run->t = settings->start;
}

/* The method of Chung and Hulbert, of those that read options: two levels of constraints, a tangent
 * that serves while it can. */
static void set_options(const cardan_run *run, real rho, real *options)
{
    const real am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1), settings = 1 - am + af;

    options[0] = am, options[1] = af;
    options[2] = settings * settings / 4, options[3] = settings - 0.5;
    options[4] = 2, options[5] = 0, options[6] = !run->on_grid;
}

size_t cardan_lay_run(const cardan_export *model, const cardan_simulation *settings, void *block,
                      cardan_laid_run *at)
{
    const cardan_exported_method *method = method_of(model, settings->method);
    const size_t tail = (size_t)model->zeros, work = cardan_work_length(model);
    cardan_run *run = &at->run;
    ptrdiff_t width;
    char *memory = block;
    size_t used = 0;

    *at = (cardan_laid_run){0};
    if (!method)
        return 0;
    describe(model, run);
    choose(method, settings, run);
    width = 1 + run->ne + 2 * (run->nx + run->ns);
    /* what is connected decides how much the run takes */
    at->prepared = reserve(memory, &used, cardan_prepared_size(model));
    connect(model, at->prepared, run);
    run->log = reserve(memory, &used, (size_t)(run->log_capacity * width) * sizeof(real));
    at->jumps_work = reserve(memory, &used, cardan_jumps_work_length(model) * sizeof(real));
    at->options = reserve(memory, &used, OPTIONS * sizeof(real));
    at->state_offset = used;
    run->ticks = reserve(memory, &used, (size_t)run->tick_count * sizeof(cardan_tick));
    at->stops = reserve(memory, &used, (cardan_jumps_capacity(model) + 1) * sizeof(real));
    at->memory = reserve(memory, &used, cardan_run_length(run, tail, work) * sizeof(real));
    if (!block)
        return used;
    set_options(run, settings->rho_inf > 0 ? settings->rho_inf : USUAL_RHO_INF, at->options);
    for (ptrdiff_t k = 0; k < run->tick_count; k++)
        run->ticks[k] = (cardan_tick){.event = model->ticks[k].event, .period = model->ticks[k].period,
                                      .phase = model->ticks[k].phase};
    run->stops = at->stops, run->options = at->options;
    cardan_run_lay(run, at->memory, tail, work);
    if (model->mesh)
        run->mesh = at->prepared;
    return used;
}

size_t cardan_simulation_size(const cardan_export *model, const cardan_simulation *settings)
{
    cardan_laid_run at;

    return cardan_lay_run(model, settings, NULL, &at);
}

/* Prepare the model at the parameters, and find where its steps must end. */
static int prepare(const cardan_export *model, const cardan_simulation *settings, cardan_laid_run *at)
{
    cardan_run *run = &at->run;
    int status = cardan_prepare(model, settings->p ? settings->p : model->p, at->prepared);

    if (status == 0)
        status = cardan_time_jumps(model, at->prepared, settings->start, settings->end, at->stops,
                                   &run->stop_count, at->jumps_work);
    run->jumps = run->stop_count > 0;
    at->stops[run->stop_count++] = settings->end;
    return status;
}

/* Put the state in its place, where the run starts. */
static int enter(const cardan_export *model, const cardan_simulation *settings, const void *prepared,
                 cardan_run *run)
{
    const double *const s = settings->s ? settings->s : model->s, *const r = settings->r ? settings->r : model->r;

    for (ptrdiff_t i = 0; i < run->ns; i++)
        run->s[i] = s[i];
    for (ptrdiff_t i = 0; i < run->nr; i++)
        run->r[i] = r[i];
    if (!settings->x)
        return cardan_start_state(model, prepared, run->t, run->r, run->y, run->work);
    for (ptrdiff_t i = 0; i < run->nx; i++)
        run->y[i] = settings->x[i];
    return 0;
}

/* Tell of what happened, and empty the log: rows of t, 1 for every event, [x, s] before, behind. */
static void report_event(const cardan_export *model, const cardan_simulation *settings, cardan_run *run)
{
    const ptrdiff_t width = 1 + run->ne + 2 * (run->nx + run->ns);

    for (ptrdiff_t k = 0; k < run->log_count && settings->on_event; k++) {
        const real *row = run->log + k * width, *s = row + 1 + run->ne + run->nx;

        for (ptrdiff_t i = 0; i < run->ne; i++) {
            const cardan_exported_event *event = &model->events[i];
            const int first = event->mode >= 0 && s[event->mode] == event->first;

            if (row[1 + i] != 0 && run->kinds[i] != CARDAN_TICK && !first)
                settings->on_event(settings->context, row[0], event->name);
        }
    }
    run->log_count = 0;
}

/* From the start to the end. */
static int drive(const cardan_export *model, const cardan_simulation *settings, cardan_run *run)
{
    int status = cardan_run_start(run);

    for (int more = status == 0; more;) {
        const ptrdiff_t left = settings->budget - run->steps;
        run->budget = settings->budget > 0 && left < BUDGET ? left : BUDGET;
        status = cardan_run_drive(run);
        /* a full log is emptied; rows have room for all times */
        more = (status == CARDAN_MORE && (settings->budget <= 0 || run->steps < settings->budget))
               || (status == CARDAN_FULL && run->log_count > 0);
        report_event(model, settings, run);
    }
    return status;
}

int cardan_simulation_open(const cardan_export *model, const cardan_simulation *settings,
                           cardan_run *run, void *memory)
{
    cardan_laid_run at;
    int status = cardan_lay_run(model, settings, memory, &at) == 0 ? CARDAN_SIZE : 0;

    at.run.rows = settings->rows, at.run.capacity = settings->time_count;
    if (settings->times)
        at.run.times = settings->times, at.run.time_count = settings->time_count;
    if (status == 0 && memory)
        status = prepare(model, settings, &at);
    if (status == 0 && memory)
        status = enter(model, settings, at.prepared, &at.run);
    *run = at.run;
    return status;
}

int cardan_simulate(const cardan_export *model, cardan_simulation *settings, void *memory)
{
    cardan_run run;
    int status = cardan_simulation_open(model, settings, &run, memory);

    if (status == 0)
        status = drive(model, settings, &run);
    settings->row_count = run.count, settings->steps = run.steps, settings->t = run.t;
    settings->x_end = run.y, settings->s_end = run.s;
    return status;
}
