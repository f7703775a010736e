/* What trial steps of every method share, side by side.
 *
 * Part of cardan, built with -DCARDAN_LANES like the function it calls. Caller owns all memory.
 */
#include "simd_steps.h"
#include "lanes.h"

#if CARDAN_LANES > 1

enum { L = CARDAN_LANES, NOT_FINITE = -1 /* as in run.h */ };

typedef int lane_function(const cardan_in *in, real *out, real *work);

void cardan_simd_derivative(cardan_simd *a, const real *y, real *f)
{
    cardan_in in = {0};

    if (a->inputs)
        a->inputs(a->owner);
    in.t = (const real *)a->at;
    in.q = y;
    in.u = y + a->nq;
    in.z = y + a->nq + a->nu;
    in.s = (const real *)a->s;
    in.r = (const real *)a->r;
    in.tau = in.wrench = (const real *)a->zeros;
    in.w = (const wreal *)a->w;
    /* a mask is -1 where it is set */
    *(cardan_mask *)a->evaluations -= (cardan_mask)(*(const cardan_mask *)a->failed == 0);
    /* a status tells of any of them */
    if (((lane_function *)a->rhs)(&in, f, (real *)a->work) != 0)
        a->alone(a->owner, (const double *)y, (double *)f);
}

/* Take no more what is not finite, and note which entry it is. */
static void refuse_not_finite(cardan_simd *a, const real *y)
{
    real sum = {0.0};

    /* of zeros, unless a number is none or infinite */
    for (ptrdiff_t i = 0; i < a->n; i++) sum += y[i] - y[i];
    for (int j = 0; j < L; j++) {
        if (sum[j] == 0 || a->taken[j] == 0)
            continue;
        a->failed[j] = NOT_FINITE;
        a->taken[j] = 0;
        for (a->culprit[j] = 0; a->culprit[j] < (double)a->n; a->culprit[j]++) {
            const double value = y[(ptrdiff_t)a->culprit[j]][j];
            if (!(value - value == 0))
                break;
        }
    }
}

void cardan_simd_commit(cardan_simd *a)
{
    const real *y = (const real *)a->y;
    real *trial = (real *)a->trial;
    cardan_mask *const taken = (cardan_mask *)a->taken, *const failed = (cardan_mask *)a->failed;

    /* as cardan_normalize does it */
    for (ptrdiff_t i = 0; i < a->quaternion_count; i++) {
        real *q = trial + a->quaternions[i];
        const real norm = cardan_sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int j = 0; j < 4; j++) q[j] /= norm;
    }
    refuse_not_finite(a, trial);
    /* the others stay where they are: whatever their trial was, it is evaluated nowhere */
    for (ptrdiff_t i = 0; i < a->n; i++) trial[i] = CARDAN_CHOICE(*taken, trial[i], y[i]);
    *(real *)a->at = CARDAN_CHOICE(*taken, *(real *)a->t_new, *(real *)a->t);
    /* a derivative of the trial may be that at its end, unless normalizing changed the state */
    if (a->last_stage >= 0 && a->quaternion_count == 0) {
        memcpy(a->next, (const real *)a->k + a->last_stage * a->n, (size_t)a->n * sizeof(real));
    } else {
        const cardan_mask waiting = ~*taken & (cardan_mask)(*failed == 0);
        *failed |= waiting;
        cardan_simd_derivative(a, trial, (real *)a->next);
        *failed &= ~waiting;
        *taken &= (cardan_mask)(*failed == 0);
    }
    refuse_not_finite(a, (const real *)a->next);
}

ptrdiff_t cardan_simd_move(cardan_simd *a)
{
    const cardan_mask taken = *(const cardan_mask *)a->taken;
    real *y = (real *)a->y, *f = (real *)a->k, *t = (real *)a->t;
    const real *trial = (const real *)a->trial, *next = (const real *)a->next;

    for (ptrdiff_t i = 0; i < a->n; i++) {
        y[i] = CARDAN_CHOICE(taken, trial[i], y[i]);
        f[i] = CARDAN_CHOICE(taken, next[i], f[i]);
    }
    *t = CARDAN_CHOICE(taken, *(const real *)a->t_new, *t);
    const cardan_mask there = taken & (cardan_mask)(*t == *(const real *)a->until);
    return cardan_some(&there);
}

#endif
