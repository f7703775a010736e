/* Runge-Kutta method of Dormand and Prince: order 8, dense output of order 7, adaptive step.
 *
 * Part of cardan. Caller owns all memory; k holds 16 derivatives: 12 of a step, the one at its end
 * (the first of the next step), 3 for the dense output.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * sections II.5, II.6 and II.10.
 */
#include "dop853_tables.h"
#include "run.h"
#include <math.h>

enum { ORDER = 8 };

/* derivative s at the state that the derivatives before it lead to */
#define STAGE(s, sum)                                                                              \
    do {                                                                                           \
        for (ptrdiff_t i = 0; i < n; i++)                                                          \
            trial[i] = y[i] + h * (sum);                                                           \
        status = cardan_derivative(run, t + C[s] * h, trial, k + (s) * n);                         \
        if (status != 0)                                                                           \
            return status;                                                                         \
    } while (0);

int cardan_dop853_init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

/* The 12 derivatives of a step of size h, and the solution at its end in `trial`. */
static int stages(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n;
    const real *y = run->y, t = run->t;
    real *k = run->k, *trial = run->trial;
    int status;

    for (ptrdiff_t i = 0; i < n; i++)
        k[i] = run->f[i];
    DOP853_STAGES(STAGE)
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h * DOP853_SOLUTION;
    return 0;
}

/* Error of the trial in units of the tolerance: good up to 1.
 *
 * The difference to order 5, damped where the one to order 3 is large: behaves like h^8. The
 * worst entry is noted as the culprit.
 */
static real error_of(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    real sum5 = 0, sum3 = 0, worst = -1;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real scale = cardan_scale(run, run->trial, i);
        real e5 = DOP853_DIFFERENCE(E5) / scale, e3 = DOP853_DIFFERENCE(E3) / scale;
        if (!(e5 * e5 <= worst)) {
            worst = e5 * e5;
            run->culprit = i;
        }
        sum5 += e5 * e5;
        sum3 += e3 * e3;
    }
    if (sum5 == 0)
        return 0;
    return fabs(h) * sum5 / sqrt((real)nx * (sum5 + 0.01 * sum3));
}

ptrdiff_t cardan_dop853_length(const cardan_run *run)
{
    (void)run;
    return 0;
}

/* One accepted step from t, y. */
int cardan_dop853_step(cardan_run *run)
{
    int status = cardan_refresh(run);

    while (status == 0 && !run->stop) {
        real h, t_new, error = 0;
        int failed;

        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = stages(run, h);
        if (failed == 0) {
            error = error_of(run, h);
            failed = error <= run->allowed ? cardan_commit(run, t_new, run->trial) : 0;
            failed = error - error == 0 ? failed : CARDAN_NOT_FINITE;
        }
        if (failed == 0 && error <= run->allowed) {
            cardan_accept_step(run, h, fmax(error, run->correction), ORDER);
            return 0;
        }
        status = cardan_reject_step(run, h, error, ORDER, failed);
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* Polynomial of degree 7 over the last step; takes three more derivatives. */
int cardan_dop853_dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, t = run->t_old, *y = run->y_old;
    real *k = run->k, *trial = run->trial, *spread = run->spread;
    int status;

    for (ptrdiff_t i = 0; i < n; i++)
        K(12) = run->f[i];
    DOP853_DENSE_STAGES(STAGE)
    /* chord, both end slopes, then four rows that use all derivatives */
    for (ptrdiff_t i = 0; i < n; i++) {
        real rise = run->y[i] - y[i];
        spread[i] = rise;
        spread[n + i] = h * K(0) - rise;
        spread[2 * n + i] = 2 * rise - h * (K(12) + K(0));
        for (ptrdiff_t row = 0; row < 4; row++) {
            real sum = D[row][0] * K(0);
            for (ptrdiff_t s = 5; s < 16; s++)
                sum += D[row][s] * K(s);
            spread[(3 + row) * n + i] = h * sum;
        }
    }
    run->is_dense = 1;
    return 0;
}
