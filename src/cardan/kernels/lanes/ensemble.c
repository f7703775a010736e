/* Many runs by one thread: one after the other, or each lane its own with its own steps.
 *
 * Part of cardan. Caller owns all memory. How a run begins, passes a stop, writes rows and ends is
 * done by the functions of single runs on the record of its lane; trial steps and their control
 * are those of single runs in lanes, of the same text. So a run does not know whether it was alone.
 */
#include "ensemble.h"
#include <string.h>

enum { SLICE = 1000 /* steps between two looks at `stop` */ };

/* Begin the next run of the queue in a lane. */
static int begin(cardan_ensemble *e, cardan_lane *lane)
{
    cardan_run *run = lane->run;
    const ptrdiff_t i = e->next++, nx = lane->fresh->nx, nr = lane->fresh->nr;

    *run = *lane->fresh;
    memcpy(lane->memory, lane->fresh_memory, (size_t)e->memory_length * sizeof(double));
    memcpy(run->y, e->x0 + i * nx, (size_t)nx * sizeof(double));
    memcpy(run->r, e->r + i * nr, (size_t)nr * sizeof(double));
    for (ptrdiff_t k = 0; k < e->pointer_count; k++) {
        const double *pointers = e->pointers[k].base + i * e->pointers[k].stride;
        memcpy((char *)run + e->pointers[k].offset, &pointers, sizeof pointers);
    }
    if (e->rows)
        run->rows = e->rows + i * run->capacity * cardan_row_width(run);
    run->budget = SLICE;
    lane->number = i;
    return cardan_run_start(run);
}

/* Keep what became of a run. */
static void finish(cardan_ensemble *e, cardan_lane *lane, int answer)
{
    const cardan_run *run = lane->run;
    const ptrdiff_t i = lane->number;

    double *numbers = e->numbers + 4 * i;

    memcpy(e->x + i * run->nx, run->y, (size_t)run->nx * sizeof(double));
    numbers[0] = run->t;
    numbers[1] = (double)run->steps;
    numbers[2] = (double)run->rejections;
    numbers[3] = (double)run->evaluations;
    if (answer != CARDAN_DONE)
        e->ends[i] = *run;
    e->answers[i] = answer;
    e->finished++;
    e->vacant = 1;
    lane->number = -1;
}

static void one_by_one(cardan_ensemble *e)
{
    cardan_run *run = e->lanes->run;

    while (e->next < e->count && !e->stop) {
        int answer = begin(e, e->lanes);

        if (answer == 0)
            answer = CARDAN_MORE;
        while (answer == CARDAN_MORE) {
            answer = e->stop ? CARDAN_STOPPED : cardan_run_drive(run);
            /* rows have room; nobody reads the log of events */
            if (answer == CARDAN_FULL) {
                run->log_count = 0;
                answer = CARDAN_MORE;
            }
        }
        finish(e, e->lanes, answer);
    }
}

/* Lanes as vectors: column j of an array of `size` entries, there and back. */
static void put(const cardan_ensemble *e, ptrdiff_t j, const double *from, ptrdiff_t size,
                double *to)
{
    for (ptrdiff_t i = 0; i < size; i++)
        to[i * e->lane_count + j] = from[i];
}

static void get(const cardan_ensemble *e, ptrdiff_t j, const double *from, ptrdiff_t size,
                double *to)
{
    for (ptrdiff_t i = 0; i < size; i++)
        to[i] = from[i * e->lane_count + j];
}

/* The present state of a run, its derivative and its control into its lane. */
static void enter(cardan_ensemble *e, ptrdiff_t j)
{
    const cardan_run *run = e->lanes[j].run;
    cardan_simd *a = e->simd;

    put(e, j, run->y, run->n, a->y);
    put(e, j, run->f, run->n, a->k);
    put(e, j, run->r, run->nr, a->r);
    put(e, j, run->s, run->ns, a->s);
    a->t[j] = run->t;
    a->size[j] = run->h;
    a->until[j] = run->until;
    a->error_before[j] = run->error_before;
    a->span[j] = cardan_least_span(run);
    a->rejected[j] = run->rejected;
    a->steps[j] = run->steps;
    a->rejections[j] = run->rejections;
    a->evaluations[j] = run->evaluations;
    a->idle[j] = 0;
}

/* What the lane of a run knows of it into its record. */
static void settle(cardan_ensemble *e, ptrdiff_t j)
{
    const cardan_simd *a = e->simd;
    cardan_run *run = e->lanes[j].run;

    run->t = a->t[j];
    run->h = a->size[j];
    run->error_before = a->error_before[j];
    run->steps = a->steps[j];
    run->rejections = a->rejections[j];
    run->evaluations = a->evaluations[j];
    run->culprit = (ptrdiff_t)a->culprit[j];
    get(e, j, a->y, run->n, run->y);
}

/* The run of a lane is over. */
static void end(cardan_ensemble *e, ptrdiff_t j, int answer)
{
    finish(e, e->lanes + j, answer);
    e->simd->idle[j] = -1;
    e->simd->taken[j] = 0;
}

/* The run of a lane is over where the lane is now. */
static void leave(cardan_ensemble *e, ptrdiff_t j, int answer)
{
    settle(e, j);
    end(e, j, answer);
}

/* Runs of the queue into a lane until one is under way. */
static void fill(cardan_ensemble *e, ptrdiff_t j)
{
    cardan_lane *lane = e->lanes + j;

    while (lane->number < 0 && e->next < e->count) {
        int answer = begin(e, lane);

        if (answer == 0)
            answer = cardan_refresh(lane->run);
        if (answer != 0) {
            finish(e, lane, answer);
            continue;
        }
        if (e->w)
            put(e, j, e->w + lane->number * e->w_size, e->w_size, e->simd->w);
        enter(e, j);
        lane->parked = 0;
    }
}

/* An idle lane does what another one does now, with steps of length 0. */
static void park(cardan_ensemble *e, ptrdiff_t j, ptrdiff_t other)
{
    cardan_simd *a = e->simd;
    const cardan_run *run = e->lanes[other].run;
    double *const columns[] = {a->y, a->k, a->r, a->s, e->w ? a->w : NULL, a->t, a->size,
                               a->error_before, a->until};
    const ptrdiff_t sizes[] = {run->n, run->n, run->nr, run->ns, e->w ? e->w_size : 0, 1, 1, 1, 1};

    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
        for (ptrdiff_t i = 0; i < sizes[k]; i++)
            columns[k][i * e->lane_count + j] = columns[k][i * e->lane_count + other];
    e->lanes[j].parked = 1;
}

/* Inputs of all lanes at the times of the present call. */
static void inputs(void *owner)
{
    cardan_ensemble *e = owner;

    for (ptrdiff_t j = 0; j < e->lane_count; j++) {
        cardan_run *run = e->lanes[j].run;
        cardan_inputs_at(run, e->simd->at[j], run->y);
        put(e, j, run->r, run->nr, e->simd->r);
    }
}

/* Derivatives lane by lane, after one or more of them failed. */
static void alone(void *owner, const double *y, double *f)
{
    cardan_ensemble *e = owner;

    for (ptrdiff_t j = 0; j < e->lane_count; j++) {
        cardan_run *run = e->lanes[j].run;
        const ptrdiff_t evaluations = run->evaluations;

        if (e->simd->failed[j] != 0)
            continue;
        get(e, j, y, run->n, run->trial);
        e->simd->failed[j] = cardan_derivative(run, e->simd->at[j], run->trial, run->k);
        run->evaluations = evaluations;
        put(e, j, run->k, run->n, f);
    }
}

/* Whether rows are wanted inside the step that a lane takes. */
static int is_due(const cardan_run *run, double t_new)
{
    const double direction = run->stops[run->stop_count - 1] - run->t_start;

    return run->times && run->next_time < run->time_count
           && (run->times[run->next_time] - t_new) * direction <= 0;
}

/* Rows of all lanes inside the steps that are taken. */
static void write(cardan_ensemble *e)
{
    cardan_simd *a = e->simd;
    ptrdiff_t inside = 0;

    for (ptrdiff_t j = 0; j < e->lane_count; j++) {
        const cardan_run *run = e->lanes[j].run;
        const int due = a->taken[j] != 0 && is_due(run, a->t_new[j]);
        /* for those that have no row there nothing is evaluated */
        a->failed[j] = !due || run->times[run->next_time] == a->t_new[j];
        inside += a->failed[j] == 0;
    }
    if (inside)
        a->dense(a);
    for (ptrdiff_t j = 0; j < e->lane_count; j++) {
        cardan_run *run = e->lanes[j].run;
        int status = a->failed[j] < 0 ? (int)a->failed[j] : 0;

        if (a->taken[j] == 0 || !is_due(run, a->t_new[j]))
            continue;
        settle(e, j);
        run->t_old = run->t;
        run->t = a->t_new[j];
        get(e, j, a->y, run->n, run->y_old);
        get(e, j, a->trial, run->n, run->y);
        run->is_dense = a->failed[j] == 0;
        if (run->is_dense)
            get(e, j, a->interpolant, run->dense_rows * run->n, run->interpolant);
        if (status == 0)
            status = cardan_write_rows(run);
        if (status != 0)
            end(e, j, status);
    }
}

/* At a stop the next segment begins, or the run is over. */
static void pass_stop(cardan_ensemble *e, ptrdiff_t j)
{
    cardan_run *run = e->lanes[j].run;
    int status = 0;

    if (run->next_stop + 1 == run->stop_count) {
        leave(e, j, CARDAN_DONE);
        return;
    }
    settle(e, j);
    run->next_stop++;
    status = cardan_segment(run);
    if (status == 0)
        status = cardan_refresh(run);
    if (status != 0)
        end(e, j, status);
    else
        enter(e, j);
}

/* One trial step of every lane. */
static void advance(cardan_ensemble *e)
{
    cardan_simd *a = e->simd;

    if (e->attempt(a))
        for (ptrdiff_t j = 0; j < e->lane_count; j++)
            if (a->ended[j] != 0)
                leave(e, j, (int)a->ended[j]);
    if (e->rows)
        write(e);
    if (e->move(a))
        for (ptrdiff_t j = 0; j < e->lane_count; j++)
            if (a->taken[j] != 0 && a->t[j] == a->until[j])
                pass_stop(e, j);
}

/* Runs for the lanes that have none, as long as there are some. Returns whether any is under way. */
static int occupy(cardan_ensemble *e)
{
    ptrdiff_t busy = -1;

    for (ptrdiff_t j = 0; j < e->lane_count; j++) {
        if (!e->stop)
            fill(e, j);
        else if (e->lanes[j].number >= 0)
            leave(e, j, CARDAN_STOPPED);
        if (e->lanes[j].number >= 0)
            busy = j;
    }
    for (ptrdiff_t j = 0; j < e->lane_count && busy >= 0; j++)
        if (e->lanes[j].number < 0 && !e->lanes[j].parked)
            park(e, j, busy);
    e->vacant = 0;
    return busy >= 0;
}

static void side_by_side(cardan_ensemble *e)
{
    for (ptrdiff_t j = 0; j < e->lane_count; j++) {
        e->lanes[j].number = e->simd->idle[j] = -1;
        e->lanes[j].parked = 0;
    }
    while (occupy(e))
        do
            advance(e);
        while (!e->vacant && !e->stop);
}

void cardan_ensemble_drive(cardan_ensemble *e)
{
    e->next = e->finished = 0;
    if (e->simd) {
        e->simd->owner = e;
        e->simd->inputs = e->timed ? inputs : NULL;
        e->simd->alone = alone;
        side_by_side(e);
    } else {
        one_by_one(e);
    }
}
