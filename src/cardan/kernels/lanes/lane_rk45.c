/* RK45 for several runs side by side: the text of rk45.c, each lane with its own t and h.
 *
 * Part of cardan, built with -DCARDAN_LANES like the function it calls. Caller owns all memory.
 * Source: as in rk45.c.
 */
#include "simd_steps.h"
#include "lanes.h"

#if CARDAN_LANES > 1
#include "rk45_tables.h"

static void trial_step(cardan_simd *a)
{
    SIMD_TRIAL(a)
    real sum = {0.0};

    a->last_stage = RK45_END;
    RK45_STAGES(SIMD_STAGE)
    for (ptrdiff_t i = 0; i < n; i++) {
        RK45_ERROR(real, SIMD_SCALE(a, i))
    }
    *(real *)a->error = RK45_NORM(h, (double)(n > 0 ? n : 1), sum);
}

static void worst(cardan_simd *a)
{
    const ptrdiff_t n = a->n;
    const real *k = (const real *)a->k;

    SIMD_CULPRIT(a, RK45_DIFFERENCE / SIMD_SCALE(a, i))
}

/* Over the step from y to trial, before it is the present one. */
static void dense(cardan_simd *a)
{
    const ptrdiff_t n = a->n;
    const real *y = (const real *)a->y, *end = (const real *)a->trial;
    const real *last = (const real *)a->next;
    const real h = *(const real *)a->t_new - *(const real *)a->t;
    real *k = (real *)a->k, *interpolant = (real *)a->interpolant;

    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = end[i] - y[i];
        interpolant[i] = rise;
        interpolant[n + i] = h * k[i] - rise;
        interpolant[2 * n + i] = 2 * rise - h * (last[i] + k[i]);
        K(6) = last[i];
        interpolant[3 * n + i] = h * RK45_LAST_ROW;
    }
}

const cardan_lane_method cardan_rk45_lane_method = {trial_step, dense, worst};

#endif
