/* Steps of a run, computed again: see steps.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "steps.h"
#include <math.h>

/* Prepare inputs and discrete states for the step between two rows. */
static void enter(cardan_run *run, const real *row, const real *next)
{
    const real middle = 0.5 * (row[0] + next[0]);

    for (ptrdiff_t i = 0; i < run->nr; i++)
        run->r[i] = row[1 + run->n + i];
    for (ptrdiff_t i = 0; i < run->ns; i++)
        run->s[i] = row[1 + run->n + run->nr + i];
    for (ptrdiff_t i = 0; i < run->signal_count; i++) {
        cardan_signal *s = run->signals + i;
        while (s->where + 1 < s->pieces && s->breaks[s->where + 1] < middle)
            s->where++;
        while (s->where > 0 && s->breaks[s->where] > middle)
            s->where--;
    }
    /* what jumps at the ends of the step is seen from inside it */
    run->early = nextafter(row[0], next[0]);
    run->late = nextafter(next[0], row[0]);
}

/* What functions read at t, x (nx), but for their parameters. */
cardan_in cardan_step_in(const cardan_steps *steps, const real *t, const real *x)
{
    cardan_signals_at(steps->run, *t);
    return cardan_at(steps->run, t, x);
}

/* Stages and end of the step from row k, before any projection. Returns 0 or CARDAN_MODEL. */
int cardan_step_again(cardan_steps *steps, ptrdiff_t k)
{
    cardan_run *run = steps->run;
    const ptrdiff_t nx = run->nx, width = cardan_row_width(run);
    const real *row = steps->rows + k * width, *y = row + 1, h = row[width] - row[0];

    enter(run, row, row + width);
    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real *a = steps->matrix + s * steps->stages, t = row[0] + steps->nodes[s] * h;
        real *x = steps->states + s * nx;
        cardan_in in;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = 0;
            for (ptrdiff_t j = 0; j < s; j++)
                sum += a[j] * steps->slopes[j * nx + i];
            x[i] = y[i] + h * sum;
        }
        in = cardan_step_in(steps, &t, x);
        in.w = run->rhs.w;
        if (run->rhs.function(&in, steps->slopes + s * nx, steps->work) != 0)
            return CARDAN_MODEL;
    }
    for (ptrdiff_t i = 0; i < nx; i++) {
        real sum = 0;
        for (ptrdiff_t j = 0; j < steps->stages; j++)
            sum += steps->weights[j] * steps->slopes[j * nx + i];
        steps->end[i] = y[i] + h * sum;
    }
    /* positions are those behind the projection where speeds are projected */
    for (ptrdiff_t i = 0; i < nx; i++)
        steps->place[i] = i < run->nq ? row[width + 1 + i] : steps->end[i];
    return 0;
}
