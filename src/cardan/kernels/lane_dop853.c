/* DOP853 for several runs side by side: the text of dop853.c, each lane with its own t and h.
 *
 * Part of cardan, built with -DCARDAN_LANES like the function it calls. Caller owns all memory.
 * Source: as in dop853.c.
 */
#include "abreast.h"
#include "lanes.h"

#if CARDAN_LANES > 1
#include "dop853_tables.h"

enum { L = CARDAN_LANES };

/* derivative s at the states that the derivatives before it lead to */
#define STAGE(s, sum)                                                                              \
    for (ptrdiff_t i = 0; i < n; i++) trial[i] = y[i] + h * (sum);                                 \
    *at = t + C[s] * h;                                                                            \
    cardan_abreast_derivative(a, trial, k + (s) * n);

/* Error of the trials, and their worst entries. */
static void errors(cardan_abreast *a)
{
    const ptrdiff_t n = a->n;
    const real *k = (const real *)a->k, *y = (const real *)a->y, *trial = (const real *)a->trial;
    real sum5 = {0.0}, sum3 = {0.0}, worst = CARDAN_REAL(-1.0), culprit = CARDAN_REAL(-1.0);

    for (ptrdiff_t i = 0; i < n; i++) {
        /* fmax takes the number where the other one is none */
        const real scale = a->atol + a->rtol * cardan_max(cardan_abs(y[i]), cardan_abs(trial[i]));
        const real e5 = DOP853_DIFFERENCE(E5) / scale, e3 = DOP853_DIFFERENCE(E3) / scale;
        const cardan_mask worse = ~(cardan_mask)(e5 * e5 <= worst);
        worst = CARDAN_CHOICE(worse, e5 * e5, worst);
        culprit = CARDAN_CHOICE(worse, CARDAN_REAL((double)i), culprit);
        sum5 += e5 * e5;
        sum3 += e3 * e3;
    }
    *(real *)a->culprit = culprit;
    for (int j = 0; j < L; j++)
        a->error[j] = dop853_error(a->h[j], (double)n, sum5[j], sum3[j]);
}

void cardan_dop853_abreast(cardan_abreast *a)
{
    const ptrdiff_t n = a->n;
    const real *y = (const real *)a->y, *f = (const real *)a->f;
    const real t = *(const real *)a->t, h = *(const real *)a->h;
    real *k = (real *)a->k, *trial = (real *)a->trial, *at = (real *)a->at;

    for (ptrdiff_t i = 0; i < n; i++) k[i] = f[i];
    DOP853_STAGES(STAGE)
    for (ptrdiff_t i = 0; i < n; i++) trial[i] = y[i] + h * DOP853_SOLUTION;
    errors(a);
}

/* Over the step from y to trial, before it is the present one. */
void cardan_dop853_dense_abreast(cardan_abreast *a)
{
    const ptrdiff_t n = a->n;
    const real *y = (const real *)a->y, *end = (const real *)a->trial;
    const real t = *(const real *)a->t, h = *(const real *)a->t_new - t;
    real *k = (real *)a->k, *spread = (real *)a->spread, *at = (real *)a->at;
    /* its last row is written last */
    real *trial = spread + 6 * n;

    for (ptrdiff_t i = 0; i < n; i++) K(12) = ((const real *)a->next)[i];
    DOP853_DENSE_STAGES(STAGE)
    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = end[i] - y[i];
        DOP853_SPREAD(real)
    }
}

#endif
