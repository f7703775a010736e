/* Runge-Kutta method of Dormand and Prince: order 5, dense output of order 4, adaptive step.
 *
 * Part of cardan. Caller owns all memory; k holds 7 derivatives, of which the last one is the first
 * of the next step.
 * Source: J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl.
 * Math. 6 (1980) 19-26; E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential
 * Equations I, 2nd ed., sections II.5 and II.6 (dense output).
 */
#include "explicit.h"
#include "rk45_tables.h"
#include <math.h>

enum { ORDER = 5 };

static int init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

/* The 7 derivatives of a step of size h, and the solution at its end in `trial`. */
static int stages(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n;
    const real t = run->t;
    real *k = run->k, *trial = run->trial;
    const real *y = cardan_enter(run, run->y, run->f, k);
    int status;

    RK45_STAGES(STAGE)
    return 0;
}

/* Error of the trial in units of the tolerance: its difference to order 4. */
static real error_of(cardan_run *run, real h, const real *against)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    real sum = 0;

    for (ptrdiff_t i = 0; i < nx; i++) {
        RK45_ERROR(real, cardan_scale(run, against, i))
    }
    return RK45_NORM(h, (real)(nx > 0 ? nx : 1), sum);
}

/* Its entry i, for a step of length 1. */
static real part(const cardan_run *run, const real *against, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;

    return RK45_DIFFERENCE / cardan_scale(run, against, i);
}

/* Entry i of the state at which derivative 5 was taken; the step is over. */
static real state(const cardan_run *run, real h, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;

    return run->y_old[i] + h * RK45_FIFTH;
}

/* One accepted step from t, y. */
static int step(cardan_run *run)
{
    static const cardan_explicit method = {ORDER, RK45_END, stages, error_of, part, 5, 3.3, state};

    return cardan_explicit_step(run, &method);
}

/* Polynomial of degree 4 over the last step; takes no more derivatives. */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old;
    real *k = run->k;

    cardan_hermite(run, k, k + 6 * n);
    for (ptrdiff_t i = 0; i < n; i++)
        run->interpolant[3 * n + i] = h * RK45_LAST_ROW;
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_rk45_method
    = {init, step, dense, cardan_no_memory, NULL, 7, 4, NULL, 0};
