/* Runs over one and the same time, from state after state: what a step of a batch is.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "short_runs.h"
#include <math.h>

/* Begin a run as if it were the first: nothing of those before it is left. */
static int begin(cardan_short_runs *runs, const real *x)
{
    cardan_run *run = runs->run;
    const real last = runs->stops[runs->stop_count - 1];
    int status;

    *run = *runs->begun;
    for (ptrdiff_t i = 0; i < runs->length; i++)
        run->y[i] = 0;
    for (ptrdiff_t i = 0; i < run->nx; i++)
        run->y[i] = x[i];
    for (ptrdiff_t i = 0; i < run->nr; i++)
        run->r[i] = runs->r[i];
    for (ptrdiff_t i = 0; i < run->ns; i++)
        run->s[i] = runs->s[i];

    /* the start knows the direction of time alone, as where a caller says later how far to go */
    run->t = runs->t;
    run->stops = &runs->far, run->stop_count = 1, run->next_stop = 0;
    status = cardan_run_start(run);
    if (status < 0)
        return status;
    run->h = copysign(run->h, last - run->t);
    run->stops = runs->stops, run->stop_count = runs->stop_count, run->next_stop = 0;
    run->t_start = run->t;
    status = cardan_segment(run);
    return status == 0 ? CARDAN_MORE : status;
}

/* All runs, until one does not come to its end; what was said of that one, or CARDAN_DONE.
 * CARDAN_MORE: a run has spent its budget of steps, or its room for rows. Called again, it goes on.
 */
int cardan_short_runs_go(cardan_short_runs *runs)
{
    const ptrdiff_t nx = runs->begun->nx;
    const real last = runs->stops[runs->stop_count - 1];

    if (!runs->going)
        runs->done = 0;
    for (; runs->done < runs->count; runs->done++) {
        int status = runs->going ? CARDAN_MORE : begin(runs, runs->x + runs->done * nx);
        if (status == CARDAN_MORE) {
            /* nobody reads the rows: to have no room for more is no end */
            runs->run->count = 0;
            status = cardan_run_drive(runs->run);
            if (status == CARDAN_FULL)
                status = CARDAN_MORE;
        }
        runs->going = status == CARDAN_MORE;
        if (status == CARDAN_DONE && runs->run->t != last)
            status = CARDAN_STOPPED;
        if (status != CARDAN_DONE)
            return status;
        for (ptrdiff_t i = 0; i < nx; i++)
            runs->ends[runs->done * nx + i] = runs->run->y[i];
    }
    return CARDAN_DONE;
}
