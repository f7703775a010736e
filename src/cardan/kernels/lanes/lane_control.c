/* Trials of several runs side by side, and what becomes of them: the decisions of control.c.
 *
 * Part of cardan, built with -DCARDAN_LANES like the function it calls. Caller owns all memory.
 */
#include "simd_steps.h"
#include "control.h"

#if CARDAN_LANES > 1

enum { NOT_FINITE = -1, TOO_SMALL = -2 /* as in run.h */ };

/* The step that every lane tries; none where no run is under way, or none is long enough. */
static void begin(cardan_simd *a, const real *least)
{
    const cardan_mask idle = *(const cardan_mask *)a->idle;
    const real t = *(const real *)a->t;
    cardan_mask *const ended = (cardan_mask *)a->ended, *const failed = (cardan_mask *)a->failed;
    real *const h = (real *)a->h, *const t_new = (real *)a->t_new;
    cardan_mask lost;

    cardan_next_trial(&t, (const real *)a->until, (const real *)a->size, least, a->max_step, h,
                      t_new, &lost);
    lost &= ~idle;
    *ended = lost & (uint64_t)TOO_SMALL;
    *failed = (lost | idle) & 1;
    *h = CARDAN_CHOICE(lost | idle, CARDAN_REAL(0.0), *h);
    *t_new = CARDAN_CHOICE(lost | idle, t, *t_new);
}

/* The size of the next step of the lanes in `refused`, whose run may end with that. */
static void refuse(cardan_simd *a, const cardan_mask *refused, const real *growth,
                   const real *least)
{
    const cardan_mask status = *(const cardan_mask *)a->failed;
    const cardan_mask failed = (cardan_mask)(status != 0);
    cardan_mask *const ended = (cardan_mask *)a->ended;
    real *const size = (real *)a->size;
    real next;

    cardan_rejected_size((const real *)a->h, &failed, growth, &next);
    *size = CARDAN_CHOICE(*refused, next, *size);
    const cardan_mask small = *refused & ~(cardan_mask)(cardan_abs(next) >= *least);
    *ended |= small & ((status & failed) | (~failed & (uint64_t)TOO_SMALL));
    /* a mask is -1 where it is set */
    *(cardan_mask *)a->rejections -= *refused;
    *(cardan_mask *)a->rejected -= *refused;
}

/* Which trials are good enough, and the size of the step after them. */
static void judge(cardan_simd *a, const real *least, real *growth)
{
    const real error = *(const real *)a->error;
    cardan_mask *const failed = (cardan_mask *)a->failed;
    cardan_mask *const rejected = (cardan_mask *)a->rejected;
    real *const size = (real *)a->size, *const culprit = (real *)a->culprit;
    const cardan_mask good = (cardan_mask)(*failed == 0);
    const cardan_mask finite = (cardan_mask)(error - error == 0.0);
    const cardan_mask taken = good & finite & (cardan_mask)(error <= 1.0);
    const cardan_mask refused = ~taken & ~*(const cardan_mask *)a->idle
                                & (cardan_mask)(*(const cardan_mask *)a->ended == 0);
    const cardan_mask again = (cardan_mask)(*rejected != 0);
    real next, damped;

    *(cardan_mask *)a->taken = taken;
    *failed |= good & ~finite & (uint64_t)NOT_FINITE;
    *culprit = CARDAN_CHOICE(good & ~taken, CARDAN_REAL((double)SIMD_WORST), CARDAN_REAL(-1.0));
    cardan_growth((int)a->order, &error, growth);
    cardan_damped_growth((int)a->order, &error, (const real *)a->error_before, &damped);
    cardan_accepted_size((const real *)a->h, size, &again, &damped, a->max_step, &next);
    *size = CARDAN_CHOICE(taken, next, *size);
    *rejected &= ~taken;
    refuse(a, &refused, growth, least);
}

ptrdiff_t cardan_simd_try(cardan_simd *a)
{
    const cardan_mask *const ended = (const cardan_mask *)a->ended;
    real *const before = (real *)a->error_before;
    cardan_mask fallen;
    real least, growth;

    cardan_least_step((const real *)a->t, (const real *)a->span, &least);
    begin(a, &least);
    a->trial_step(a);
    judge(a, &least, &growth);
    /* while the trial is what it was */
    if (cardan_some(ended))
        a->worst(a);
    fallen = *(const cardan_mask *)a->taken;
    if (cardan_some(&fallen))
        cardan_simd_commit(a);
    *before = CARDAN_CHOICE(*(const cardan_mask *)a->taken, *(const real *)a->error, *before);
    *(cardan_mask *)a->steps -= *(const cardan_mask *)a->taken;
    fallen &= ~*(const cardan_mask *)a->taken;
    if (cardan_some(&fallen))
        refuse(a, &fallen, &growth, &least);
    return cardan_some(ended);
}

#endif
