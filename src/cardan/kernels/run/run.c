/* Drive an integrator to the end of its run and write the rows that are wanted.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "events.h"
#include "run.h"
#include <math.h>
#include <stdint.h>

enum { FINAL = -1000 }; /* within this file: the end of the run */

/* For bindings: the size they must agree with. */
/* y (n) inside a step from its dense output; theta in 0 ... 1.
 *
 * y_old + theta (F0 + (1 - theta) (F1 + theta (F2 + ...))): F0 alone is the chord, every further
 * row vanishes at both ends.
 */
void cardan_interpolate(ptrdiff_t rows, ptrdiff_t n, real theta, const real *y_old,
                        const real *interpolant, real *y)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        real sum = 0;
        for (ptrdiff_t j = rows - 1; j >= 0; j--)
            sum = (sum + interpolant[j * n + i]) * (j % 2 == 0 ? theta : 1 - theta);
        y[i] = y_old[i] + sum;
    }
}

/* y (n) at a time inside the last step. */
int cardan_run_at(cardan_run *run, real t, real *y)
{
    real h = run->t - run->t_old;
    int status = 0;

    if (t == run->t) {
        for (ptrdiff_t i = 0; i < run->n; i++)
            y[i] = run->y[i];
        return 0;
    }
    if (!run->is_dense)
        status = run->dense(run);
    if (status != 0)
        return status;
    cardan_interpolate(run->dense_rows, run->n, (t - run->t_old) / h, run->y_old, run->interpolant, y);
    cardan_leave_inside(run, (t - run->t_old) / h, y);
    cardan_normalize(run, y);
    /* where branches meet, or that does not close, the polynomial is as good as anything */
    if (run->pass_length != 0 && fabs(run->t - run->pass_start) <= fabs(run->pass_length)
        && cardan_near_singular(run, t, y, 0))
        return 0;
    status = cardan_close(run, t, y, 0);
    return status == CARDAN_CONSTRAINT_OPEN ? 0 : status;
}

static void copy(real *to, const real *from, ptrdiff_t count)
{
    for (ptrdiff_t i = 0; i < count; i++)
        to[i] = from[i];
}

/* What the dense output of the last step is made of: derivatives, the last one that at its end. */
static void note_sources(const cardan_run *run, real *out)
{
    const cardan_method *method = run->later;

    for (ptrdiff_t j = 0; j < method->source_rows; j++)
        copy(out + j * run->n, run->k + method->sources[j] * run->n, run->n);
    copy(out + method->source_rows * run->n, run->f, run->n);
}

/* Numbers of a row: t, y, r, s, multipliers. */
ptrdiff_t cardan_row_width(const cardan_run *run)
{
    return 1 + run->n + run->nr + run->ns + run->nlam;
}

/* Write a row for time t. */
static int put(cardan_run *run, real t)
{
    real *row = run->rows + run->count * cardan_row_width(run);
    real theta = run->t == run->t_old ? 1 : (t - run->t_old) / (run->t - run->t_old);
    int status = cardan_run_at(run, t, row + 1);

    if (status != 0)
        return status;
    row[0] = t;
    (void)cardan_inputs_at(run, t, row + 1);
    for (ptrdiff_t i = 0; i < run->nr; i++)
        row[1 + run->n + i] = run->r[i];
    for (ptrdiff_t i = 0; i < run->ns; i++)
        row[1 + run->n + run->nr + i] = run->s[i];
    /* at the start of `own`; of the second order between the steps too */
    for (ptrdiff_t i = 0; i < run->nlam; i++)
        row[1 + run->n + run->nr + run->ns + i] =
            run->method_memory[i] + theta * (run->method_memory[run->nlam + i] - run->method_memory[i]);
    run->count++;
    return 0;
}

/* Whether a wanted time has come; at an event it is what comes after that counts. */
static int is_due(const cardan_run *run)
{
    real ahead = run->times[run->next_time] - run->t;

    if (ahead == 0)
        return !run->event_pending && !cardan_events_due(run);
    return ahead * (run->stops[run->stop_count - 1] - run->t_start) < 0;
}

/* Rows of the present step that are still to be written. */
int cardan_write_rows(cardan_run *run)
{
    int status = 0;

    if (run->times) {
        while (run->next_time < run->time_count && is_due(run)) {
            if (run->count == run->capacity)
                return CARDAN_FULL;
            status = put(run, run->times[run->next_time]);
            if (status != 0)
                return status;
            run->next_time++;
        }
    } else if (run->row_open) {
        if (run->count == run->capacity)
            return CARDAN_FULL;
        /* the first row belongs to no step */
        if (run->spreads && run->steps > 0) {
            ptrdiff_t size = run->dense_rows * run->n;
            const int jump = run->row_open == 2;
            if (run->later) {
                note_sources(run, run->spreads + run->count * (run->later->source_rows + 1) * run->n);
            } else {
                status = run->is_dense || jump ? 0 : run->dense(run);
                for (ptrdiff_t i = 0; i < size && status == 0; i++)
                    run->spreads[run->count * size + i] = jump ? 0 : run->interpolant[i];
            }
        }
        if (status == 0)
            status = put(run, run->t);
        run->row_open = status != 0;
    }
    return status;
}

/* Whether an array may have so many rows of so many numbers. */
static int fits(ptrdiff_t rows, ptrdiff_t size)
{
    const ptrdiff_t most = PTRDIFF_MAX / (ptrdiff_t)sizeof(real);

    return rows >= 0 && size >= 0 && (size == 0 || rows <= most / size);
}

/* Whether every array of the run may have the size that the record speaks of. */
static int sizes_fit(const cardan_run *run)
{
    /* one by one before their sums */
    if (!fits(run->n, 4) || !fits(run->nr, 4) || !fits(run->nx, 1) || !fits(run->ns, 4)
        || !fits(run->nq, 4) || !fits(run->nu, 4) || !fits(run->nz, 4))
        return 0;
    return run->nq + run->nu + run->nz == run->nx && run->nx <= run->n && run->stop_count > 0
           && fits(run->stages, run->n) && fits(run->charted, 8) && fits(run->dense_rows, run->n)
           && run->dense_rows <= CARDAN_MOST_ROWS && fits(run->ne, 16) && fits(run->watched, 16)
           && fits(run->nlam, 4) && fits(run->capacity, cardan_row_width(run))
           && fits(run->log_capacity, 1 + run->ne + run->watched + 2 * (run->nx + run->ns))
           && fits(run->capacity, run->dense_rows * run->n) && fits(run->time_count, 1)
           && fits(run->signal_count, 1) && fits(run->quaternion_count, 4)
           && fits(run->bounded_count, 1)
           && fits(run->positions, 16) && fits(run->rates, 16);
}

/* Begin at t, y: the first segment, the derivative, the first step size, the first row. */
int cardan_run_start(cardan_run *run)
{
    int status;

    if (!sizes_fit(run))
        return CARDAN_SIZE;
    run->t_start = run->t_old = run->t;
    run->open_row = -1;
    run->pass_count = 0;
    cardan_normalize(run, run->y);
    run->culprit = cardan_not_finite(run->y, run->n);
    if (run->culprit >= 0)
        return CARDAN_NOT_FINITE;
    cardan_events_clock(run);
    status = cardan_segment(run);
    if (status == 0)
        status = cardan_close(run, run->t, run->y, 1);
    if (status == 0)
        status = cardan_refresh(run);
    if (status == 0) {
        run->culprit = cardan_not_finite(run->f, run->n);
        cardan_first_moment(run);
        status = run->culprit >= 0 ? CARDAN_NOT_FINITE : run->init(run);
    }
    if (status == 0 && run->constraint_jacobian.function)
        cardan_first_rank(run);
    if (status == 0)
        status = cardan_events_start(run);
    run->row_open = 1;
    return status == 0 ? cardan_write_rows(run) : status;
}

/* What happens at t: transitions until nothing happens any more. */
static int happen(cardan_run *run)
{
    int status = 0, written = 0;

    while (status == 0 && run->event_pending)
        status = cardan_events_apply(run);
    /* the wanted time may be just here */
    if (status == CARDAN_EVENT)
        written = cardan_write_rows(run);
    return written != 0 ? written : status;
}

/* At the time where a step must end: ticks, then the next segment, or FINAL. */
static int turn(cardan_run *run)
{
    if (cardan_events_tick(run) || run->t != run->stops[run->next_stop])
        return 0;
    if (run->next_stop + 1 == run->stop_count)
        return FINAL;
    run->next_stop++;
    return cardan_segment(run);
}

/* One step, and what happened in it. */
static int advance(cardan_run *run)
{
    int status = cardan_step(run);

    if (status != 0)
        return status;
    run->row_open = 1;
    run->at_once = 0;
    return cardan_events_seek(run);
}

/* Step until the run is over, the budget is spent, or there is no room for a row or an event. */
int cardan_run_drive(cardan_run *run)
{
    int status;

    for (ptrdiff_t i = 0; i < run->budget; i++) {
        status = cardan_write_rows(run);
        if (status != 0)
            return status;
        if (run->stop)
            return CARDAN_STOPPED;
        if (cardan_events_full(run))
            return CARDAN_FULL;
        if (run->event_pending)
            status = happen(run);
        else if (run->t == run->until)
            status = turn(run);
        else
            status = advance(run);
        if (status != 0)
            return status == FINAL ? CARDAN_DONE : status;
    }
    status = cardan_write_rows(run);
    return status != 0 ? status : CARDAN_MORE;
}
