/* DOP853, the Runge-Kutta method of Dormand and Prince: order 8, adaptive step size, dense output
 * of order 7.
 *
 * Part of cardan. Caller owns all memory. k stores 16 derivatives: k[0..11] are the 12 stages of a
 * step, k[12] is the derivative at its end (k[0] of the next step), and k[13..15] are the three
 * extra stages of the dense output.
 *
 * Algorithm of one step (the loop is cardan_explicit_step in explicit.c, the controller control.h):
 *   1. evaluate the 12 stages and form the 8th-order solution;
 *   2. combine a 5th-order and a 3rd-order error estimate into one error norm;
 *   3. accept if the norm is at most 1: normalize quaternions, project onto the constraints and
 *      evaluate the derivative at the new state; otherwise retry with the h of 4, without growth;
 *   4. new step size: h times 0.93 (sqrt(error before) / error)^(3/32), a PI controller, factor in [1/3, 6].
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

/* Evaluate the 12 stages of a step of size h and write the 8th-order solution to `trial`. */
static int stages(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n;
    const real t = run->t;
    real *k = run->k, *trial = run->trial;
    const real *y = cardan_enter(run, run->y, run->f, k);
    int status;

    /* k[0] is the derivative at t, already in place; stages k[1..11] follow in order */
    DOP853_STAGES(STAGE)
    /* the weights b of the 8th-order solution are row 12 of A */
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h * DOP853_SOLUTION;
    return 0;
}

/* Error norm of the trial step in units of the tolerance; the step is accepted up to 1.
 *
 * Fifth- and third-order error estimates combined as in Hairer, Norsett & Wanner, section II.10:
 * err = |h| |e5|^2 / sqrt(nx (|e5|^2 + 0.01 |e3|^2)), each entry divided by its tolerance. The
 * result behaves like h^8. Only the nx states count; the energies are quadratures.
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

/* Entry i of e5 for a step of length 1, from which the caller finds the entry with the largest error. */
static real part(const cardan_run *run, const real *against, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;

    return DOP853_DIFFERENCE(E5) / cardan_scale(run, against, i);
}

/* Entry i of the state at which stage 11 was evaluated.
 *
 * Stage 11 lies at t + h, as does the solution. The distance between the two states and between their
 * derivatives estimates the largest |lambda| for the stiffness test.
 */
static real state(const cardan_run *run, real h, ptrdiff_t i)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k;
    real sum = A[11][0] * K(0);

    for (int j = 3; j < 11; j++)
        sum += A[11][j] * K(j);
    return run->y_old[i] + h * sum;
}

/* Take one accepted step from t, y. The argument -1 says that no stage is the solution at the end.
 *
 * Stiffness test: the method is stable for real negative h lambda up to 6.1 in magnitude. The test
 * counts steps near that bound; see Hairer & Wanner II, section IV.2.
 */
static int step(cardan_run *run)
{
    static const cardan_explicit method = {ORDER, -1, stages, error_of, part, 11, 6.1, state};

    return cardan_explicit_step(run, &method);
}

/* Dense output over the last step: the 7th-order interpolant, which needs three more stages.
 *
 * The step starts from `y_old` or, in a charted run, from the coordinates of that state in the
 * chart of the step.
 */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, t = run->t_old;
    real *k = run->k, *trial = run->trial, *interpolant = run->interpolant;
    const real *y = run->charted ? run->chart + 2 * n : run->y_old;
    int status;

    /* rise y - y_old, and the derivative at the end of the step as k[12] */
    cardan_arrive(run, interpolant, k + 12 * n);
    /* extra stages k[13..15] at c = 0.1, 0.2 and 7/9 */
    DOP853_DENSE_STAGES(STAGE)
    /* rows: rise, the two Hermite rows from the end slopes, four rows from all stages */
    for (ptrdiff_t i = 0; i < n; i++) {
        real rise = interpolant[i];
        DOP853_INTERPOLANT(real)
    }
    run->is_dense = 1;
    return 0;
}

/* stages 1 to 4 have no weight in the dense output */
static const ptrdiff_t SOURCES[] = {0, 5, 6, 7, 8, 9, 10, 11};

const cardan_method cardan_dop853_method
    = {init, step, dense, cardan_no_memory, NULL, 16, 7, SOURCES, sizeof SOURCES / sizeof *SOURCES};
