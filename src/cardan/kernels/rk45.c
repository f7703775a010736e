/* Runge-Kutta method of Dormand and Prince: order 5, dense output of order 4, adaptive step.
 *
 * Part of cardan. Caller owns all memory; k holds 7 derivatives, of which the last one is the first
 * of the next step.
 * Source: J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl.
 * Math. 6 (1980) 19-26; E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential
 * Equations I, 2nd ed., sections II.5 and II.6 (dense output).
 */
#include "explicit.h"
#include <math.h>

enum { ORDER = 5 };

static const real C[7] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};

#define FIFTH                                                                                      \
    (9017.0 / 3168 * K(0) - 355.0 / 33 * K(1) + 46732.0 / 5247 * K(2) + 49.0 / 176 * K(3)          \
     - 5103.0 / 18656 * K(4))

int cardan_rk45_init(cardan_run *run)
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

    STAGE(1, 1.0 / 5 * K(0))
    STAGE(2, 3.0 / 40 * K(0) + 9.0 / 40 * K(1))
    STAGE(3, 44.0 / 45 * K(0) - 56.0 / 15 * K(1) + 32.0 / 9 * K(2))
    STAGE(4, 19372.0 / 6561 * K(0) - 25360.0 / 2187 * K(1) + 64448.0 / 6561 * K(2)
                 - 212.0 / 729 * K(3))
    STAGE(5, FIFTH)
    STAGE(6, 35.0 / 384 * K(0) + 500.0 / 1113 * K(2) + 125.0 / 192 * K(3) - 2187.0 / 6784 * K(4)
                 + 11.0 / 84 * K(5))
    return 0;
}

/* Error of the trial in units of the tolerance: its difference to order 4. */
static real error_of(cardan_run *run, real h, const real *against)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    real sum = 0, worst = -1;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real e = (71.0 / 57600 * K(0) - 71.0 / 16695 * K(2) + 71.0 / 1920 * K(3)
                  - 17253.0 / 339200 * K(4) + 22.0 / 525 * K(5) - 1.0 / 40 * K(6))
                 / cardan_scale(run, against, i);
        if (!(e * e <= worst)) {
            worst = e * e;
            run->culprit = i;
        }
        sum += e * e;
    }
    return fabs(h) * sqrt(sum / (real)(nx > 0 ? nx : 1));
}

ptrdiff_t cardan_rk45_length(const cardan_run *run)
{
    (void)run;
    return 0;
}

/* Entry i of the state at which derivative 5 was taken; the step is over. */
static real state(const cardan_run *run, real h, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;

    return run->y_old[i] + h * FIFTH;
}

/* One accepted step from t, y. */
int cardan_rk45_step(cardan_run *run)
{
    static const cardan_explicit method = {ORDER, 6, stages, error_of, 5, 3.3, state};

    return cardan_explicit_step(run, &method);
}

/* Polynomial of degree 4 over the last step; takes no more derivatives. */
int cardan_rk45_dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old;
    real *k = run->k;

    cardan_hermite(run, k, k + 6 * n);
    for (ptrdiff_t i = 0; i < n; i++)
        run->spread[3 * n + i] =
            h * (-12715105075.0 / 11282082432.0 * K(0) + 87487479700.0 / 32700410799.0 * K(2)
                 - 10690763975.0 / 1880347072.0 * K(3) + 701980252875.0 / 199316789632.0 * K(4)
                 - 1453857185.0 / 822651844.0 * K(5) + 69997945.0 / 29380423.0 * K(6));
    run->is_dense = 1;
    return 0;
}
