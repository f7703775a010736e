/* Fixed-step grid, trial loop of the adaptive explicit methods, cubic dense output.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "explicit.h"
#include <math.h>

enum { LOOKS = 4 /* the stiffness test runs every fourth step */ };
/* parts of a step that are the rounding of times: of one behind a grid point, of one before a stop */
static const real PASSED = CARDAN_ROUNDING(1e-6, 1e-2), LEFT = CARDAN_ROUNDING(1e-9, 1e-2);

/* Start a fixed-step run; the sign of h follows the direction of the run. */
int cardan_fixed_init(cardan_run *run)
{
    run->h = copysign(run->h, run->stops[run->stop_count - 1] - run->t);
    return cardan_refresh(run);
}

/* End of the next fixed step: the next grid point of the segment, or the stop if it is nearer. */
real cardan_grid(const cardan_run *run)
{
    real stop = run->until;
    /* t may lie between grid points after a shortened step */
    real done = floor((run->t - run->segment) / run->h + PASSED);
    real t = run->segment + (done + 1) * run->h;

    return (stop - t) / run->h < LEFT ? stop : t;
}

/* Stiffness test: count the accepted step as `limited` if stability, not accuracy, limits it.
 *
 * Two derivatives at the end time, taken at two nearby states, estimate the dominant eigenvalue:
 * |lambda| = |f1 - f2| / |y1 - y2|. The step is limited if h |lambda| > 0.8 bound.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2.
 */
static void look(cardan_run *run, const cardan_explicit *method, real h)
{
    const real *other = run->k + method->other * run->n;
    real slopes = 0, states = 0;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        const real slope = run->f[i] - other[i], state = run->y[i] - method->state(run, h, i);
        slopes += slope * slope;
        states += state * state;
    }
    run->looked++;
    run->limited += h * h * slopes > 0.8 * 0.8 * method->bound * method->bound * states;
}

/* Index of the entry with the largest error, or of the last NaN if there is one. The last one is
 * reported because NaN speeds also make the coordinates NaN, and coordinates come first. */
static ptrdiff_t worst_of(const cardan_run *run, const cardan_explicit *method, const real *against)
{
    real worst = -1;
    ptrdiff_t culprit = -1;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        const real each = fabs(method->part(run, against, i));
        if (cardan_exceeds(each, worst)) {
            worst = each;
            culprit = i;
        }
    }
    return culprit;
}

/* Take one accepted step from t, y: try step sizes until the error norm is at most 1. */
int cardan_explicit_step(cardan_run *run, const cardan_explicit *method)
{
    int status = cardan_refresh(run);

    while (status == 0 && !run->stop) {
        real h, t_new, error = 0;
        int failed;

        /* requested step, shortened or stretched to end exactly at a stop */
        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = method->stages(run, h);
        if (failed == 0) {
            error = method->error(run, h, cardan_against(run, run->trial));
            /* small enough: leave the chart, project onto the constraints, evaluate f there */
            if (error <= 1) {
                cardan_leave(run, run->trial);
                failed = cardan_commit_derivative(run, t_new, run->trial, method->ends);
            }
            /* a NaN or infinite error is a failure, not a large error */
            failed = error - error == 0 ? failed : CARDAN_NOT_FINITE;
        }
        if (failed == 0 && error <= 1) {
            /* in a chart the stage states are no states of the run, so the test is skipped */
            if (run->steps % LOOKS == 0 && !run->charted)
                look(run, method, h);
            /* the change made by the projection counts as an error of the step */
            cardan_accept_explicit_step(run, h, fmax(error, run->correction), method->order);
            return 0;
        }
        /* rejected: retry with a smaller h; status 0 unless h fell below its minimum */
        status = cardan_reject_step(run, h, error, method->order, failed);
        if (status != 0 && !(error <= 1))
            run->culprit = worst_of(run, method, cardan_against(run, run->trial));
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* First three rows of the dense output: the cubic Hermite interpolant of the last step.
 *
 * `first` (n) is the derivative at the start of the step. The derivative at its end is written to
 * `last` (n), in chart coordinates if the run is charted. Row 0 is the chord; cardan_interpolate
 * in run.c says how the rows enter.
 */
void cardan_hermite(cardan_run *run, const real *first, real *last)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old;
    real *interpolant = run->interpolant;

    cardan_arrive(run, interpolant, last);
    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = interpolant[i];
        interpolant[n + i] = h * first[i] - rise;
        interpolant[2 * n + i] = 2 * rise - h * (last[i] + first[i]);
    }
}

static void copy(real *to, const real *from, ptrdiff_t count)
{
    for (ptrdiff_t i = 0; i < count; i++)
        to[i] = from[i];
}

/* Dense outputs (count, dense_rows, n) of steps from t and y (count + 1, n), their ends, and from what
 * was kept of them: as the run would have made them, if inputs and discrete states are constant. */
int cardan_dense_later(cardan_run *run, ptrdiff_t count, const real *t, const real *y,
                       const real *sources, real *spreads)
{
    const cardan_method *method = run->later;
    const ptrdiff_t n = run->n, rows = method->source_rows, size = run->dense_rows * n;
    int status = 0;

    for (ptrdiff_t i = 0; i < count && status == 0; i++, sources += (rows + 1) * n) {
        run->t_old = t[i], run->t = t[i + 1];
        copy(run->y_old, y + i * n, n);
        copy(run->y, y + (i + 1) * n, n);
        copy(run->f, sources + rows * n, n);
        (void)cardan_enter(run, run->y_old, run->f, run->k);
        for (ptrdiff_t j = 0; j < rows; j++)
            copy(run->k + method->sources[j] * n, sources + j * n, n);
        status = run->dense(run);
        copy(spreads + i * size, run->interpolant, size);
    }
    return status;
}
