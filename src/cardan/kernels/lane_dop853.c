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

/* Error of the trials, and their worst entries. */
static void errors(cardan_abreast *a)
{
    const ptrdiff_t n = a->n;
    const real *k = (const real *)a->k;
    real sum5 = {0.0}, sum3 = {0.0}, worst = CARDAN_REAL(-1.0), culprit = CARDAN_REAL(-1.0);

    for (ptrdiff_t i = 0; i < n; i++) {
        const real scale = ABREAST_SCALE(a, i);
        const real e5 = DOP853_DIFFERENCE(E5) / scale, e3 = DOP853_DIFFERENCE(E3) / scale;
        ABREAST_WORST(e5 * e5)
        sum5 += e5 * e5;
        sum3 += e3 * e3;
    }
    *(real *)a->culprit = culprit;
    for (int j = 0; j < L; j++)
        a->error[j] = dop853_error(a->h[j], (double)n, sum5[j], sum3[j]);
}

void cardan_dop853_abreast(cardan_abreast *a)
{
    ABREAST_TRIAL(a)

    a->known = -1;
    for (ptrdiff_t i = 0; i < n; i++) k[i] = f[i];
    DOP853_STAGES(ABREAST_STAGE)
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
    DOP853_DENSE_STAGES(ABREAST_STAGE)
    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = end[i] - y[i];
        DOP853_SPREAD(real)
    }
}

#endif
