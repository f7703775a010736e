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

int cardan_dop853_init(cardan_run *run)
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

    STAGE(1, A[1][0] * K(0));
    STAGE(2, A[2][0] * K(0) + A[2][1] * K(1));
    STAGE(3, A[3][0] * K(0) + A[3][2] * K(2));
    STAGE(4, A[4][0] * K(0) + A[4][2] * K(2) + A[4][3] * K(3));
    STAGE(5, A[5][0] * K(0) + A[5][3] * K(3) + A[5][4] * K(4));
    STAGE(6, A[6][0] * K(0) + A[6][3] * K(3) + A[6][4] * K(4) + A[6][5] * K(5));
    STAGE(7, A[7][0] * K(0) + A[7][3] * K(3) + A[7][4] * K(4) + A[7][5] * K(5) + A[7][6] * K(6));
    STAGE(8, A[8][0] * K(0) + A[8][3] * K(3) + A[8][4] * K(4) + A[8][5] * K(5) + A[8][6] * K(6)
                 + A[8][7] * K(7));
    STAGE(9, A[9][0] * K(0) + A[9][3] * K(3) + A[9][4] * K(4) + A[9][5] * K(5) + A[9][6] * K(6)
                 + A[9][7] * K(7) + A[9][8] * K(8));
    STAGE(10, A[10][0] * K(0) + A[10][3] * K(3) + A[10][4] * K(4) + A[10][5] * K(5)
                  + A[10][6] * K(6) + A[10][7] * K(7) + A[10][8] * K(8) + A[10][9] * K(9));
    STAGE(11, A[11][0] * K(0) + A[11][3] * K(3) + A[11][4] * K(4) + A[11][5] * K(5)
                  + A[11][6] * K(6) + A[11][7] * K(7) + A[11][8] * K(8) + A[11][9] * K(9)
                  + A[11][10] * K(10));
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h * (A[12][0] * K(0) + A[12][5] * K(5) + A[12][6] * K(6)
                               + A[12][7] * K(7) + A[12][8] * K(8) + A[12][9] * K(9)
                               + A[12][10] * K(10) + A[12][11] * K(11));
    return 0;
}

/* Error of the trial in units of the tolerance: good up to 1.
 *
 * The difference to order 5, damped where the one to order 3 is large: behaves like h^8. The
 * worst entry is noted as the culprit.
 */
static real error_of(cardan_run *run, real h, const real *against)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    real sum5 = 0, sum3 = 0, worst = -1;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real scale = cardan_scale(run, against, i);
        real e5 = (E5[0] * K(0) + E5[5] * K(5) + E5[6] * K(6) + E5[7] * K(7) + E5[8] * K(8)
                   + E5[9] * K(9) + E5[10] * K(10) + E5[11] * K(11)) / scale;
        real e3 = (E3[0] * K(0) + E3[5] * K(5) + E3[6] * K(6) + E3[7] * K(7) + E3[8] * K(8)
                   + E3[9] * K(9) + E3[10] * K(10) + E3[11] * K(11)) / scale;
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
    static const cardan_explicit method = {ORDER, -1, stages, error_of};

    return cardan_explicit_step(run, &method);
}

/* Polynomial of degree 7 over the last step; takes three more derivatives. */
int cardan_dop853_dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, t = run->t_old;
    real *k = run->k, *trial = run->trial, *spread = run->spread;
    const real *y = run->charted ? run->chart + 2 * n : run->y_old;
    int status;

    cardan_hermite(run, k, k + 12 * n);
    STAGE(13, A[13][0] * K(0) + A[13][6] * K(6) + A[13][7] * K(7) + A[13][8] * K(8)
                  + A[13][9] * K(9) + A[13][10] * K(10) + A[13][11] * K(11) + A[13][12] * K(12));
    STAGE(14, A[14][0] * K(0) + A[14][5] * K(5) + A[14][6] * K(6) + A[14][7] * K(7)
                  + A[14][10] * K(10) + A[14][11] * K(11) + A[14][12] * K(12)
                  + A[14][13] * K(13));
    STAGE(15, A[15][0] * K(0) + A[15][5] * K(5) + A[15][6] * K(6) + A[15][7] * K(7)
                  + A[15][8] * K(8) + A[15][12] * K(12) + A[15][13] * K(13) + A[15][14] * K(14));
    /* four more rows use all derivatives */
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t row = 0; row < 4; row++) {
            real sum = D[row][0] * K(0);
            for (ptrdiff_t s = 5; s < 16; s++)
                sum += D[row][s] * K(s);
            spread[(3 + row) * n + i] = h * sum;
        }
    run->is_dense = 1;
    return 0;
}
