/* Runge-Kutta method of Dormand and Prince: order 8, dense output of order 7, adaptive step.
 *
 * Part of cardan. Caller owns all memory; k holds 16 derivatives: 12 of a step, the one at its end
 * (the first of the next step), 3 for the dense output.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * sections II.5, II.6 and II.10.
 */
#include "dop853_tables.h"
#include "explicit.h"
#include <math.h>

enum { ORDER = 8 };

static int init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

/* The 12 derivatives of a step of size h, and the solution at its end in `trial`. */
static int stages(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n;
    const real t = run->t;
    real *k = run->k, *trial = run->trial;
    const real *y = cardan_enter(run, run->y, run->f, k);
    int status;

    DOP853_STAGES(STAGE)
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h * DOP853_SOLUTION;
    return 0;
}

/* Error of the trial in units of the tolerance: good up to 1.
 *
 * The difference to order 5, damped where the one to order 3 is large: behaves like h^8.
 */
static real error_of(cardan_run *run, real h, const real *against)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    real sum5 = 0, sum3 = 0;

    for (ptrdiff_t i = 0; i < nx; i++) {
        DOP853_ERROR(real, cardan_scale(run, against, i))
    }
    return DOP853_NORM(h, (real)nx, sum5, sum3);
}

/* Its entry i, for a step of length 1. */
static real part(const cardan_run *run, const real *against, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;

    return DOP853_DIFFERENCE(E5) / cardan_scale(run, against, i);
}

/* Entry i of the state at which derivative 11 was taken; the step is over. */
static real state(const cardan_run *run, real h, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;
    real sum = A[11][0] * K(0);

    for (int j = 3; j < 11; j++)
        sum += A[11][j] * K(j);
    return run->y_old[i] + h * sum;
}

/* One accepted step from t, y. */
static int step(cardan_run *run)
{
    static const cardan_explicit method = {ORDER, -1, stages, error_of, part, 11, 6.1, state};

    return cardan_explicit_step(run, &method);
}

/* Polynomial of degree 7 over the last step; takes three more derivatives. */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, t = run->t_old;
    real *k = run->k, *trial = run->trial, *spread = run->spread;
    const real *y = run->charted ? run->chart + 2 * n : run->y_old;
    int status;

    cardan_arrive(run, spread, k + 12 * n);
    DOP853_DENSE_STAGES(STAGE)
    for (ptrdiff_t i = 0; i < n; i++) {
        real rise = spread[i];
        DOP853_SPREAD(real)
    }
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_dop853_method
    = {init, step, dense, cardan_no_memory, NULL, 16, 7};
