/* The step to try and the size of the next one: one text for single runs and for lanes.
 *
 * Part of cardan. control.c includes it where a `real` is a number, lane_control.c where it is a
 * vector of one number per lane: what decides about a step has the same bits in both. Products in
 * sums are exact, so that nothing is left to how compilers fuse them.
 * Sources: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * section II.4; K. Gustafsson, Control theoretic techniques for stepsize selection in explicit
 * Runge-Kutta methods, ACM Transactions on Mathematical Software 17 (1991).
 */
#ifndef CARDAN_CONTROL_H
#define CARDAN_CONTROL_H

#include "lanes.h"
#include <float.h>

/* conditions and choices */
#if CARDAN_LANES > 1
typedef cardan_mask cardan_boolean; /* all bits where it holds */
#define CARDAN_WHERE(truth, a, b) CARDAN_CHOICE(truth, CARDAN_REAL(a), CARDAN_REAL(b))
#else
typedef int cardan_boolean;
#define CARDAN_WHERE(truth, a, b) ((truth) ? (a) : (b))
#endif
#define CARDAN_SMALLER(a, b) CARDAN_WHERE((b) < (a), b, a)
#define CARDAN_LARGER(a, b) CARDAN_WHERE((a) < (b), b, a)
/* the length x with the sign of y */
#define CARDAN_SIGNED(x, y) CARDAN_WHERE((y) < 0.0, -(x), x)

static const double CARDAN_SAFETY = 0.9, CARDAN_SHRINK = 1.0 / 3, CARDAN_GROW = 6;
/* of a control that rejects less; errors of the step before that are smaller tell nothing */
static const double CARDAN_DAMPED_SAFETY = 0.93, CARDAN_LEAST_ERROR = 1e-2;

/* The smallest step that t can resolve, beside t = 0 that is something to a time `span`. */
CARDAN_INLINE void cardan_least_step(const real *t, const real *span, real *least)
{
    const real far = cardan_abs(*t);

    *least = 16 * DBL_EPSILON * CARDAN_LARGER(far, *span);
}

/* From t over h to t_new, not beyond `until`, where `size` is what control asks for; `lost` where
 * that is less than t can resolve. */
CARDAN_INLINE void cardan_next_trial(const real *t, const real *until, const real *size,
                                     const real *least, double max_step, real *h, real *t_new,
                                     cardan_boolean *lost)
{
    const real left = *until - *t, far = cardan_abs(left), size_now = cardan_abs(*size);
    const real requested = CARDAN_SMALLER(size_now, max_step);
    /* the step that t can tell: roundings of many times would add up */
    const real there = *t + CARDAN_SIGNED(requested, *size), attained = there - *t;
    const real length = cardan_abs(attained), longer = 1.01 * length, sliver = length + *least;
    /* stretch a little rather than leave a sliver before the stop */
    const real stretched = CARDAN_SMALLER(longer, max_step);
    const cardan_boolean last = (cardan_boolean)(far <= CARDAN_LARGER(sliver, stretched));

    *lost = (cardan_boolean)(requested < *least) & (cardan_boolean)(*least < far);
    *h = CARDAN_WHERE(last, left, attained);
    *t_new = CARDAN_WHERE(last, *until, there);
}

/* What a step may grow by after this error of a method of this order, before bounds. */
CARDAN_INLINE void cardan_growth(int order, const real *error, real *growth)
{
    if (order == 8) {
        const real fourth = cardan_sqrt(cardan_sqrt(*error));
        *growth = CARDAN_SAFETY / cardan_sqrt(fourth);
    } else {
        *growth = CARDAN_SAFETY * cardan_pow(*error, CARDAN_REAL(-1.0 / (double)order));
    }
}

/* The same after a step that was good enough, by its error and that `before` of the step before it:
 * a PI controller with gains 3/8 and 3/8, (before^(3/8) / error^(3/4))^(1 / order).
 *
 * Against (1 / error)^(1 / order) it takes a tenth fewer evaluations for the same error of the motion,
 * over scenes with joints of all kinds, and rejects half as many trials: docs/integrators.md.
 */
CARDAN_INLINE void cardan_damped_growth(int order, const real *error, const real *before,
                                        real *growth)
{
    const real earlier = CARDAN_LARGER(CARDAN_LEAST_ERROR, *before);
    const real better = cardan_sqrt(earlier) / *error;

    if (order == 8) {
        /* to the power of 1/16 + 1/32 */
        const real root = cardan_sqrt(cardan_sqrt(better)), sixteenth = cardan_sqrt(cardan_sqrt(root));
        *growth = CARDAN_DAMPED_SAFETY * sixteenth * cardan_sqrt(sixteenth);
    } else {
        *growth = CARDAN_DAMPED_SAFETY * cardan_pow(better, CARDAN_REAL(0.75 / (double)order));
    }
}

/* Size after a step of h that was good enough; one that was cut at a stop does not shrink it. */
CARDAN_INLINE void cardan_accepted_size(const real *h, const real *size,
                                        const cardan_boolean *rejected, const real *growth,
                                        double max_step, real *next)
{
    const real shrunk = CARDAN_LARGER(CARDAN_SHRINK, *growth);
    const real most = CARDAN_WHERE(*rejected, 1.0, CARDAN_GROW);
    const real factor = CARDAN_SMALLER(most, shrunk);
    const real length = cardan_abs(*h), before = cardan_abs(*size), grown = length * factor;
    const cardan_boolean cut
        = (cardan_boolean)(length < 0.99 * before) & (cardan_boolean)(factor >= 1.0);
    const real retained = CARDAN_LARGER(grown, before), proposal = CARDAN_WHERE(cut, retained, grown);
    const real bounded = CARDAN_SMALLER(proposal, max_step);

    *next = CARDAN_SIGNED(bounded, *h);
}

/* Size after a step of h that was not good enough, or that failed. */
CARDAN_INLINE void cardan_rejected_size(const real *h, const cardan_boolean *failed,
                                        const real *growth, real *next)
{
    const real wished = CARDAN_WHERE(*failed, 0.25, *growth);
    const real factor = CARDAN_LARGER(0.2, wished);

    *next = *h * CARDAN_SMALLER(0.9, factor);
}

#endif
