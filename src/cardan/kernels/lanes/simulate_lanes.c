/* Runs of an exported model from several states: see simulate_lanes.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "simulate_lanes.h"
#include "ensemble.h"
#include "jumps.h"
#include <math.h>

enum { ALIGNED = 64, NUMBERS = 4 };

/* What the runs work on, in the memory of the caller. */
typedef struct shares {
    cardan_ensemble *driver;
    cardan_simd *simd;
    cardan_lane *lanes;
    cardan_run *runs, *fresh, *ends;
    real *numbers, *r, *columns;
    char *work;    /* (lanes, work_size) of single runs */
    real *copies;  /* (lanes, work_size) of what a run leaves behind */
    size_t work_size;
} shares;

static const cardan_lane_choice *choice_of(const cardan_export *model, const cardan_lane_build *build,
                                           const cardan_simulation *common)
{
    const char *name = common->method ? common->method : model->methods->name;

    /* lanes look at no events, project nothing and count no steps; their counters are as long as a
     * mask */
    if (!build || model->event_count || model->positions + model->rates || model->mesh
        || cardan_jumps_capacity(model) || common->step > 0 || common->budget > 0
        || sizeof(ptrdiff_t) != sizeof(double))
        return NULL;
    for (ptrdiff_t k = 0; k < build->method_count; k++)
        if (strcmp(name, build->methods[k].name) == 0)
            return build->methods + k;
    return NULL;
}

/* Reserve the next part of a memory, aligned for vectors; where that is NULL it is only measured. */
static void *reserve(char *memory, size_t *used, size_t count, size_t size)
{
    void *start = memory ? memory + *used : NULL;

    *used += (count * size + ALIGNED - 1) / ALIGNED * ALIGNED;
    return start;
}

/* Point every array per lane into a block; returns how many entries of it that takes. */
static size_t lay_lanes(const cardan_export *model, const cardan_run *run, cardan_simd *a, real *block,
                        ptrdiff_t width)
{
    const ptrdiff_t n = run->n, work = (ptrdiff_t)cardan_work_length(model);
    ptrdiff_t used = 0;
    double **const numbers[] = {&a->t, &a->size, &a->until, &a->error_before, &a->span, &a->h, &a->t_new, &a->at,
                                &a->error, &a->culprit};
    ptrdiff_t **const counts[] = {&a->idle, &a->rejected, &a->steps, &a->rejections, &a->evaluations,
                                  &a->taken, &a->failed, &a->ended};

    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        *numbers[k] = cardan_reserve(block, &used, width);
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        *counts[k] = (ptrdiff_t *)(void *)cardan_reserve(block, &used, width);
    a->y = cardan_reserve(block, &used, n * width);
    a->trial = cardan_reserve(block, &used, n * width);
    a->next = cardan_reserve(block, &used, n * width);
    a->k = cardan_reserve(block, &used, run->stages * n * width);
    a->interpolant = cardan_reserve(block, &used, run->dense_rows * n * width);
    a->r = cardan_reserve(block, &used, run->nr * width);
    a->s = cardan_reserve(block, &used, run->ns * width);
    a->zeros = cardan_reserve(block, &used, model->zeros * width);
    a->work = cardan_reserve(block, &used, work * width);
    return (size_t)used;
}

/* Lay everything out; returns how many bytes that takes. */
static size_t lay(const cardan_export *model, const cardan_lane_build *build,
                  const cardan_simulations *settings, char *memory, shares *at)
{
    const size_t lanes = (size_t)build->lanes, count = (size_t)settings->count;
    size_t used = 0;
    cardan_run run = {0};
    cardan_simd simd = {0};

    (void)cardan_simulation_open(model, &settings->common, &run, NULL);
    at->work_size = (cardan_simulation_size(model, &settings->common) + ALIGNED - 1) / ALIGNED * ALIGNED;
    at->driver = reserve(memory, &used, 1, sizeof(cardan_ensemble));
    at->simd = reserve(memory, &used, 1, sizeof(cardan_simd));
    at->lanes = reserve(memory, &used, lanes, sizeof(cardan_lane));
    at->runs = reserve(memory, &used, lanes, sizeof(cardan_run));
    at->fresh = reserve(memory, &used, lanes, sizeof(cardan_run));
    at->ends = reserve(memory, &used, count, sizeof(cardan_run));
    at->numbers = reserve(memory, &used, NUMBERS * count, sizeof(real));
    at->r = reserve(memory, &used, count * (size_t)model->nr, sizeof(real));
    at->columns = reserve(memory, &used, lay_lanes(model, &run, &simd, NULL, build->lanes), sizeof(real));
    at->work = reserve(memory, &used, lanes, at->work_size);
    at->copies = reserve(memory, &used, lanes, at->work_size);
    return used;
}

size_t cardan_simulations_size(const cardan_export *model, const cardan_lane_build *build,
                               const cardan_simulations *settings)
{
    const size_t single = cardan_simulation_size(model, &settings->common);
    shares at;

    if (single == 0 || !choice_of(model, build, &settings->common))
        return single;
    return lay(model, build, settings, NULL, &at) + ALIGNED;
}

/* One run after the other, each as if it were alone. */
static int one_by_one(const cardan_export *model, cardan_simulations *settings, void *memory)
{
    const ptrdiff_t nx = model->nq + model->nu + model->nz;
    const ptrdiff_t width = settings->common.time_count * (1 + nx + model->nr + model->ns);

    settings->side_by_side = 1;
    for (ptrdiff_t i = 0; i < settings->count; i++) {
        cardan_simulation run = settings->common;
        int answer;

        run.x = settings->x + i * nx;
        run.r = settings->r ? settings->r + i * model->nr : run.r;
        run.rows = settings->rows ? settings->rows + i * width : NULL;
        run.times = settings->rows ? run.times : NULL;
        run.time_count = settings->rows ? run.time_count : 0;
        answer = cardan_simulate(model, &run, memory);
        if (answer == CARDAN_SIZE)
            return answer;
        settings->answers[i] = answer;
        settings->steps += run.steps;
        memcpy(settings->x_end + i * nx, run.x_end, (size_t)nx * sizeof(double));
    }
    return CARDAN_DONE;
}

/* Every lane with a run that is ready to start, and a copy of it. Returns a status. */
static int fill(const cardan_export *model, const cardan_lane_build *build,
                const cardan_simulations *settings, const shares *at)
{
    int status = 0;

    for (ptrdiff_t j = 0; j < build->lanes && status == 0; j++) {
        char *memory = at->work + (size_t)j * at->work_size;
        real *copy = at->copies + (size_t)j * at->work_size / sizeof(real);
        cardan_lane *lane = at->lanes + j;
        cardan_run *run = at->runs + j;

        status = cardan_simulation_open(model, &settings->common, run, memory);
        if (!settings->rows)
            run->times = run->stops, run->time_count = run->capacity = 0;
        at->fresh[j] = *run;
        /* all that follows the stages of the method */
        lane->memory = run->r;
        at->driver->memory_length = (real *)(void *)(memory + at->work_size) - run->r;
        memcpy(copy, run->r, (size_t)at->driver->memory_length * sizeof(real));
        lane->run = run, lane->fresh = at->fresh + j, lane->fresh_memory = copy;
    }
    return status;
}

/* The record of the lanes, as that of the first run has it. */
static void describe(const cardan_export *model, const cardan_lane_build *build,
                     const cardan_lane_choice *choice, const shares *at)
{
    const cardan_run *run = at->runs;
    cardan_simd *a = at->simd;
    const size_t length = lay_lanes(model, run, a, at->columns, build->lanes);

    memset(at->columns, 0, length * sizeof(real));
    a->rhs = build->rhs;
    memcpy(&a->w, &run->rhs.w, sizeof a->w);
    a->quaternions = run->quaternions, a->quaternion_count = run->quaternion_count;
    a->n = run->n, a->nq = run->nq, a->nu = run->nu, a->nr = run->nr;
    a->trial_step = choice->method->trial_step, a->dense = choice->method->dense;
    a->worst = choice->method->worst, a->order = choice->order;
    a->rtol = run->rtol, a->atol = run->atol, a->max_step = run->max_step;
}

int cardan_simulate_lanes(const cardan_export *model, const cardan_lane_build *build,
                          cardan_simulations *settings, void *memory)
{
    const cardan_lane_choice *choice = choice_of(model, build, &settings->common);
    cardan_ensemble *e;
    int status;
    shares at;

    settings->steps = 0;
    if (!choice)
        return one_by_one(model, settings, memory);
    (void)lay(model, build, settings, (char *)memory + (ALIGNED - (uintptr_t)memory % ALIGNED), &at);
    e = at.driver;
    *e = (cardan_ensemble){.lanes = at.lanes, .simd = at.simd, .attempt = build->attempt,
                           .move = build->move, .lane_count = build->lanes, .x0 = settings->x,
                           .count = settings->count, .rows = settings->rows, .x = settings->x_end,
                           .numbers = at.numbers, .ends = at.ends, .answers = settings->answers};
    *at.simd = (cardan_simd){0};
    status = fill(model, build, settings, &at);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < settings->count * model->nr; i++)
        at.r[i] = settings->r ? settings->r[i] : at.runs->r[i % model->nr];
    e->r = at.r;
    describe(model, build, choice, &at);
    cardan_ensemble_drive(e);
    for (ptrdiff_t i = 0; i < settings->count; i++)
        settings->steps += (ptrdiff_t)at.numbers[NUMBERS * i + 1];
    settings->side_by_side = build->lanes;
    return CARDAN_DONE;
}
