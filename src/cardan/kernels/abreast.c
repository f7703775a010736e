/* What trial steps of every method share, side by side.
 *
 * Part of cardan, built with -DCARDAN_LANES like the function it calls. Caller owns all memory.
 */
#include "abreast.h"
#include "lanes.h"

#if CARDAN_LANES > 1

enum { L = CARDAN_LANES, NOT_FINITE = -1 /* as in run.h */ };

typedef int lane_function(const cardan_in *in, real *out, real *work);

size_t cardan_abreast_size(void)
{
    return sizeof(cardan_abreast);
}

void cardan_abreast_derivative(cardan_abreast *a, const real *y, real *f)
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
    in.tau = in.wrench = (const real *)a->at_rest;
    in.w = (const wreal *)a->w;
    /* a mask is -1 where it is set */
    *(cardan_mask *)a->evaluations -= (cardan_mask)(*(const cardan_mask *)a->failed == 0);
    /* a status tells of any of them */
    if (((lane_function *)a->rhs)(&in, f, (real *)a->work) != 0)
        a->alone(a->owner, (const double *)y, (double *)f);
}

/* The mask of the lanes whose trial is taken. */
static void takers(const cardan_abreast *a, cardan_mask *taken)
{
    const real given = *(const real *)a->taken;

    *taken = (cardan_mask)(given != 0.0);
}

/* Take no more what is not finite, and note which entry it is. */
static void refuse_not_finite(cardan_abreast *a, const real *y)
{
    cardan_mask good = ~(cardan_mask){0};

    for (ptrdiff_t i = 0; i < a->n; i++) good &= (cardan_mask)(y[i] - y[i] == 0.0);
    for (int j = 0; j < L; j++) {
        if (good[j] || a->taken[j] == 0)
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

void cardan_abreast_commit(cardan_abreast *a)
{
    const real *y = (const real *)a->y;
    real *trial = (real *)a->trial;
    cardan_mask taken;

    /* as cardan_normalize does it */
    for (ptrdiff_t i = 0; i < a->quaternion_count; i++) {
        real *q = trial + a->quaternions[i];
        const real norm = cardan_sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int j = 0; j < 4; j++) q[j] /= norm;
    }
    for (int j = 0; j < L; j++)
        if (a->taken[j] != 0)
            a->culprit[j] = -1;
    refuse_not_finite(a, trial);
    /* the others stay where they are: whatever their trial was, it is evaluated nowhere */
    takers(a, &taken);
    for (ptrdiff_t i = 0; i < a->n; i++) trial[i] = CARDAN_CHOICE(taken, trial[i], y[i]);
    *(real *)a->at = CARDAN_CHOICE(taken, *(real *)a->t_new, *(real *)a->t);
    for (int j = 0; j < L; j++)
        if (a->taken[j] == 0 && a->failed[j] == 0)
            a->failed[j] = 1;
    /* a derivative of the trial may be that at its end, unless normalizing changed the state */
    if (a->known >= 0 && a->quaternion_count == 0)
        memcpy(a->next, (const real *)a->k + a->known * a->n, (size_t)a->n * sizeof(real));
    else
        cardan_abreast_derivative(a, trial, (real *)a->next);
    for (int j = 0; j < L; j++) {
        if (a->failed[j] == 1 && a->taken[j] == 0)
            a->failed[j] = 0;
        if (a->failed[j] != 0)
            a->taken[j] = 0;
    }
    refuse_not_finite(a, (const real *)a->next);
}

void cardan_abreast_move(cardan_abreast *a)
{
    real *y = (real *)a->y, *f = (real *)a->f;
    const real *trial = (const real *)a->trial, *next = (const real *)a->next;
    cardan_mask taken;

    takers(a, &taken);
    for (ptrdiff_t i = 0; i < a->n; i++) {
        y[i] = CARDAN_CHOICE(taken, trial[i], y[i]);
        f[i] = CARDAN_CHOICE(taken, next[i], f[i]);
    }
}

#endif
