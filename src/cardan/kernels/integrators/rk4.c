/* The classical Runge-Kutta method: 4 stages, order 4, fixed step.
 *
 * Part of cardan. Caller owns all memory; k holds 4 derivatives.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * sections II.1 and II.6.
 */
#include "explicit.h"

static int init(cardan_run *run)
{
    run->on_grid = 1;
    return cardan_fixed_init(run);
}

/* One step from t, y. */
static int step(cardan_run *run)
{
    static const real c[4] = {0, 0.5, 0.5, 1};
    ptrdiff_t n = run->n;
    real *k = run->k, *trial = run->trial;
    real t_new = cardan_grid(run), h = t_new - run->t;
    int status = cardan_refresh(run);
    const real *y = cardan_enter(run, run->y, run->f, k);

    run->culprit = -1;
    for (int s = 1; s < 4 && status == 0; s++) {
        for (ptrdiff_t i = 0; i < n; i++)
            trial[i] = y[i] + h * c[s] * k[(s - 1) * n + i];
        status = cardan_slope(run, s < 3 ? run->t + c[s] * h : t_new, trial, k + s * n);
    }
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h / 6 * (k[i] + 2 * (k[n + i] + k[2 * n + i]) + k[3 * n + i]);
    cardan_leave(run, trial);
    return cardan_commit(run, t_new, trial);
}

/* Cubic through values and derivatives at both ends of the last step. */
static int dense(cardan_run *run)
{
    /* the second derivative of the step is needed no more */
    cardan_hermite(run, run->k, run->k + run->n);
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_rk4_method
    = {init, step, dense, cardan_no_memory, NULL, 4, 3, NULL, 0};
