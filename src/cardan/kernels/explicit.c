/* Steps on a grid, trials of a step by an adaptive explicit method, cubic dense output.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "explicit.h"
#include <math.h>

enum { LOOKS = 4 /* steps between two looks at what limits them */ };

/* Begin with a fixed step h; its sign comes from the direction of the run. */
int cardan_fixed_init(cardan_run *run)
{
    run->h = copysign(run->h, run->stops[run->stop_count - 1] - run->t);
    return cardan_refresh(run);
}

/* End of the next fixed step: on the grid of the segment, or the stop if that is as near. */
real cardan_grid(const cardan_run *run)
{
    real stop = run->until;
    /* steps of a part of h may have led here */
    real done = floor((run->t - run->segment) / run->h + 1e-6);
    real t = run->segment + (done + 1) * run->h;

    return (stop - t) / run->h < 1e-9 ? stop : t;
}

/* Whether the step just accepted was as long as stability lets it be, not as accuracy does.
 *
 * Two derivatives at its end, at states next to each other, show the rate of the fastest decay.
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

/* The entry whose error is largest; the last one that is no number, if some are: speeds infect
 * coordinates, which stand before them. */
static ptrdiff_t worst_of(const cardan_run *run, const cardan_explicit *method, const real *against)
{
    real worst = -1;
    ptrdiff_t culprit = -1;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        const real each = fabs(method->part(run, against, i));
        if (!(each <= worst) && (worst == worst || each != each)) {
            worst = each;
            culprit = i;
        }
    }
    return culprit;
}

/* One accepted step from t, y. */
int cardan_explicit_step(cardan_run *run, const cardan_explicit *method)
{
    int status = cardan_refresh(run);

    while (status == 0 && !run->stop) {
        real h, t_new, error = 0;
        int failed;

        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = method->stages(run, h);
        if (failed == 0) {
            error = method->error(run, h, cardan_against(run, run->trial));
            if (error <= 1) {
                cardan_leave(run, run->trial);
                failed = cardan_commit_known(run, t_new, run->trial, method->ends);
            }
            failed = error - error == 0 ? failed : CARDAN_NOT_FINITE;
        }
        if (failed == 0 && error <= 1) {
            if (run->steps % LOOKS == 0 && !run->charted)
                look(run, method, h);
            cardan_accept_step(run, h, fmax(error, run->correction), method->order);
            return 0;
        }
        status = cardan_reject_step(run, h, error, method->order, failed);
        if (status != 0 && !(error <= 1))
            run->culprit = worst_of(run, method, cardan_against(run, run->trial));
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* First three rows of the dense output of the last step: chord, then values and slopes.
 *
 * `first` (n) is the derivative at its start; at its end it is written to `last` (n), in the chart
 * where there is one.
 */
void cardan_hermite(cardan_run *run, const real *first, real *last)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old;
    real *spread = run->spread;

    cardan_arrive(run, spread, last);
    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = spread[i];
        spread[n + i] = h * first[i] - rise;
        spread[2 * n + i] = 2 * rise - h * (last[i] + first[i]);
    }
}
