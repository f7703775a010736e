/* Steps of a run, computed again: see steps.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "steps.h"
#include <math.h>

/* Prepare inputs and discrete states for the step between two rows. */
void cardan_enter_step(cardan_run *run, const real *row, const real *next)
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

/* The change of a stage, or a gradient by it, behind the scaling of its quaternions. */
void cardan_stage_lengths(const cardan_steps *steps, ptrdiff_t stage, real *change)
{
    const cardan_run *run = steps->run;
    const real *lengths = steps->lengths + stage * run->quaternion_count;

    if (steps->kind != CARDAN_COUPLED)
        return;
    for (ptrdiff_t k = 0; k < run->quaternion_count; k++)
        cardan_unit_change(steps->states + stage * run->nx + run->quaternions[k], lengths[k],
                           change + run->quaternions[k]);
}

/* Right-hand side (nx) at t, x. Returns 0 or CARDAN_MODEL. */
int cardan_rates_at(const cardan_steps *steps, real t, const real *x, real *rates)
{
    cardan_in in = cardan_step_in(steps, &t, x);

    in.w = steps->run->rhs.w;
    return steps->run->rhs.function(&in, rates, steps->work) == 0 ? 0 : CARDAN_MODEL;
}

/* Stages of an explicit method from state y at t. */
static int explicit_stages(const cardan_steps *steps, real t, real h, const real *y)
{
    const ptrdiff_t nx = steps->run->nx;
    int status = 0;

    for (ptrdiff_t s = 0; s < steps->stages && status == 0; s++) {
        const real *a = steps->matrix + s * steps->stages;
        real *x = steps->states + s * nx;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = 0;
            for (ptrdiff_t j = 0; j < s; j++)
                sum += a[j] * steps->slopes[j * nx + i];
            x[i] = y[i] + h * sum;
        }
        status = cardan_rates_at(steps, t + steps->nodes[s] * h, x, steps->slopes + s * nx);
    }
    return status;
}

/* End of a step from y before its projections; `behind`: the state behind them. */
void cardan_end_step(const cardan_steps *steps, const real *y, real h, const real *behind)
{
    const ptrdiff_t nx = steps->run->nx;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real sum = 0;
        for (ptrdiff_t j = 0; j < steps->stages; j++)
            sum += steps->weights[j] * steps->slopes[j * nx + i];
        steps->end[i] = y[i] + h * sum;
    }
    /* positions are those behind the projection where speeds are projected */
    for (ptrdiff_t i = 0; i < nx; i++)
        steps->place[i] = i < steps->run->nq ? behind[i] : steps->end[i];
}

/* Stages and end of the step from row k, before any projection. Returns 0 or a status. */
int cardan_step_again(cardan_steps *steps, ptrdiff_t k)
{
    const ptrdiff_t width = cardan_row_width(steps->run);
    const real *row = steps->rows + k * width, *y = row + 1, h = row[width] - row[0];
    int status;

    cardan_enter_step(steps->run, row, row + width);
    status = steps->kind == CARDAN_COUPLED ? steps->coupled->solve(steps, k)
                                           : explicit_stages(steps, row[0], h, y);
    if (status == 0)
        cardan_end_step(steps, y, h, row + width + 1);
    return status;
}
