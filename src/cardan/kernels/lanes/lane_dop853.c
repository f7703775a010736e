/* DOP853 for several runs side by side: the text of dop853.c, each lane with its own t and h.
 *
 * Part of cardan, built with -DCARDAN_LANES like the function it calls. Caller owns all memory.
 * Source: as in dop853.c.
 */
#include "simd_steps.h"
#include "lanes.h"

#if CARDAN_LANES > 1
#include "dop853_tables.h"

static void trial_step(cardan_simd *a)
{
    SIMD_TRIAL(a)
    real sum5 = {0.0}, sum3 = {0.0};

    a->last_stage = -1;
    DOP853_STAGES(SIMD_STAGE)
    for (ptrdiff_t i = 0; i < n; i++) {
        trial[i] = y[i] + h * DOP853_SOLUTION;
        DOP853_ERROR(real, SIMD_SCALE(a, i))
    }
    *(real *)a->error = DOP853_NORM(h, (double)n, sum5, sum3);
}

static void worst(cardan_simd *a)
{
    const ptrdiff_t n = a->n;
    const real *k = (const real *)a->k;

    SIMD_CULPRIT(a, DOP853_DIFFERENCE(E5) / SIMD_SCALE(a, i))
}

/* Over the step from y to trial, before it is the present one. */
static void dense(cardan_simd *a)
{
    const ptrdiff_t n = a->n;
    const real *y = (const real *)a->y, *end = (const real *)a->trial;
    const real t = *(const real *)a->t, h = *(const real *)a->t_new - t;
    real *k = (real *)a->k, *interpolant = (real *)a->interpolant, *at = (real *)a->at;
    /* its last row is written last */
    real *trial = interpolant + 6 * n;

    for (ptrdiff_t i = 0; i < n; i++) K(12) = ((const real *)a->next)[i];
    DOP853_DENSE_STAGES(SIMD_STAGE)
    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = end[i] - y[i];
        DOP853_INTERPOLANT(real)
    }
}

const cardan_lane_method cardan_dop853_lane_method = {trial_step, dense, worst};

#endif
