/* What the implicit methods share: the Jacobian of the run.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Stages are evaluated at states whose quaternions have unit length, as rhs_jacobian takes them.
 */
#include "shift.h"
#include <float.h>
#include <math.h>

static const real WEIGHT[3] = {-1.5, 2, -0.5}; /* of values at 0, 1 and 2 in a derivative at 0 */

/* Numbers that cardan_jacobian writes: J (nx, nx), df/dt (nx), then what it works with. */
ptrdiff_t cardan_jacobian_length(const cardan_run *run)
{
    return run->nx * (run->nx + 4 + run->nr) + run->nr;
}

/* Add column `to` of the Jacobian by an input that changes at rate `change`. */
static void add_column(const cardan_run *run, const real *by_r, ptrdiff_t input, real change,
                       real *to, ptrdiff_t stride)
{
    for (ptrdiff_t i = 0; i < run->nx; i++)
        to[i * stride] += by_r[i * run->nr + input] * change;
}

/* What signals add to df/dt: their pieces are known. */
static void add_signals(const cardan_run *run, real t, const real *by_r, real *by_t)
{
    for (ptrdiff_t i = 0; i < run->signal_count; i++) {
        const cardan_signal *s = run->signals + i;
        const real *c = s->coefficients + 4 * s->where;
        const real d = t - s->breaks[s->where];
        add_column(run, by_r, s->input, (3 * c[3] * d + 2 * c[2]) * d + c[1], by_t, 1);
    }
}

/* What functions of t and x add to df/dt and J, by differences ahead of t, inside the segment. */
static int add_functions(cardan_run *run, real t, const real *x, real h, const real *by_r,
                         real *by_x, real *by_t, real *moved, real *before)
{
    const real step = pow(DBL_EPSILON, 1.0 / 3) * h;
    const ptrdiff_t nx = run->nx, nr = run->nr;

    for (ptrdiff_t k = 0; k < nr; k++)
        before[k] = run->r[k];
    for (ptrdiff_t i = 0; i < nx; i++)
        moved[i] = x[i];
    for (int j = 1; j < 3; j++) {
        if (run->inputs(run->input_context, t + j * step, x, run->r) != 0)
            return CARDAN_INPUT;
        for (ptrdiff_t k = 0; k < nr; k++)
            add_column(run, by_r, k, WEIGHT[j] * (run->r[k] - before[k]) / step, by_t, 1);
    }
    for (ptrdiff_t j = 0; j < nx; j++) {
        real by = sqrt(DBL_EPSILON) * fmax(fabs(x[j]), fabs(h * run->f[j]));
        moved[j] = x[j] + (by > 0 ? by : sqrt(DBL_EPSILON));
        by = moved[j] - x[j];
        if (run->inputs(run->input_context, t, moved, run->r) != 0)
            return CARDAN_INPUT;
        for (ptrdiff_t k = 0; k < nr; k++)
            if (run->r[k] != before[k])
                add_column(run, by_r, k, (run->r[k] - before[k]) / by, by_x + j, nx);
        moved[j] = x[j];
    }
    for (ptrdiff_t k = 0; k < nr; k++)
        run->r[k] = before[k];
    return 0;
}

/* By how much entry i of a state is moved to see what that does: of its size, of what a step h
 * changes, or where both are 0 of the size at which tolerances end to be relative. */
static real nudge(const cardan_run *run, ptrdiff_t i, real h)
{
    const real least = run->rtol > 0 ? run->atol / run->rtol : 0;
    const real size = fmax(fmax(fabs(run->y[i]), fabs(h * run->f[i])), least);

    return pow(DBL_EPSILON, 1.0 / 3) * (size > 0 ? size : 1);
}

/* J and df/dt by differences of the right-hand side itself, inputs included. */
static int differences(cardan_run *run, real h, real *by_x, real *by_t, real *moved)
{
    const ptrdiff_t nx = run->nx;
    const real step = pow(DBL_EPSILON, 1.0 / 3) * h;
    real *up = moved + nx, *down = up + nx;
    int status = 0;

    for (ptrdiff_t j = 0; j < nx && status == 0; j++) {
        const real by = nudge(run, j, h), above = run->y[j] + by, below = run->y[j] - by;
        for (int side = 1; side >= -1 && status == 0; side -= 2) {
            for (ptrdiff_t i = 0; i < nx; i++)
                moved[i] = run->y[i];
            moved[j] = side > 0 ? above : below;
            cardan_normalize(run, moved);
            status = cardan_evaluate(run, run->t, moved, side > 0 ? up : down, NULL);
        }
        for (ptrdiff_t i = 0; i < nx; i++)
            by_x[i * nx + j] = (up[i] - down[i]) / (above - below);
    }
    for (ptrdiff_t i = 0; i < nx; i++)
        by_t[i] = 0;
    for (int j = 0; j < 3 && status == 0; j++) {
        status = cardan_evaluate(run, run->t + j * step, run->y, up, NULL);
        for (ptrdiff_t i = 0; i < nx; i++)
            by_t[i] += WEIGHT[j] * up[i] / step;
    }
    return status != 0 ? status : cardan_inputs_at(run, run->t, run->y);
}

/* J = df/dx (nx, nx) and df/dt (nx) at the present state, with what inputs do: as the model derives
 * them, or where it does not by differences.
 *
 * h is the step ahead: over a small part of it functions of the user are differenced.
 */
int cardan_jacobian(cardan_run *run, real h, real *jacobian)
{
    const ptrdiff_t nx = run->nx;
    real *by_t = jacobian + nx * nx, *by_r = by_t + nx, *remainder = by_r + nx * run->nr;
    cardan_in in = cardan_at(run, &run->t, run->y);
    int status;

    run->jacobians++;
    cardan_inputs_at(run, run->t, run->y);
    if (run->rhs_jacobian.function) {
        status = cardan_call_model(run, &run->rhs_jacobian, &in, jacobian);
        if (status != 0)
            return status;
        add_signals(run, run->t, by_r, by_t);
        if (run->inputs && !run->sampled)
            status = add_functions(run, run->t, run->y, h, by_r, jacobian, by_t, remainder, remainder + nx);
    } else
        status = differences(run, h, jacobian, by_t, by_t + nx);
    run->culprit = cardan_not_finite(jacobian, nx * nx + nx);
    if (status == 0 && run->culprit >= 0) {
        /* entry of y whose derivative it is */
        run->culprit = run->culprit < nx * nx ? run->culprit / nx : run->culprit - nx * nx;
        status = CARDAN_NOT_FINITE;
    }
    return status;
}
