/* Coefficients of RK45 in the sums they stand in, for rk45.c and lane_rk45.c: one text, so that lanes
 * do what single runs do. Stages are counted from 0.
 *
 * Source: J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl.
 * Math. 6 (1980) 19-26; E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential
 * Equations I, 2nd ed., sections II.5 and II.6 (dense output).
 */
#ifndef CARDAN_RK45_H
#define CARDAN_RK45_H

#include "cardan.h"

enum { RK45_END = 6 /* the stage at the end of the step */ };

/* nodes */
static const double C[7] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};

#ifndef K
#define K(j) k[(j) * n + i]
#endif

/* the last state before the one at the end, at the same time, is y + h times this */
#define RK45_FIFTH                                                                                 \
    (9017.0 / 3168 * K(0) - 355.0 / 33 * K(1) + 46732.0 / 5247 * K(2) + 49.0 / 176 * K(3)          \
     - 5103.0 / 18656 * K(4))

/* The stages of a step, one after the other: STAGE(s, sum) makes derivative s at y + h sum. */
#define RK45_STAGES(STAGE)                                                                         \
    STAGE(1, 1.0 / 5 * K(0))                                                                       \
    STAGE(2, 3.0 / 40 * K(0) + 9.0 / 40 * K(1))                                                    \
    STAGE(3, 44.0 / 45 * K(0) - 56.0 / 15 * K(1) + 32.0 / 9 * K(2))                                \
    STAGE(4, 19372.0 / 6561 * K(0) - 25360.0 / 2187 * K(1) + 64448.0 / 6561 * K(2)                 \
                 - 212.0 / 729 * K(3))                                                             \
    STAGE(5, RK45_FIFTH)                                                                           \
    STAGE(6, 35.0 / 384 * K(0) + 500.0 / 1113 * K(2) + 125.0 / 192 * K(3) - 2187.0 / 6784 * K(4)   \
                 + 11.0 / 84 * K(5))

/* the difference to order 4, for a step of length 1 */
#define RK45_DIFFERENCE                                                                            \
    (71.0 / 57600 * K(0) - 71.0 / 16695 * K(2) + 71.0 / 1920 * K(3) - 17253.0 / 339200 * K(4)      \
     + 22.0 / 525 * K(5) - 1.0 / 40 * K(6))

/* the highest row of the dense output, for a step of length 1 */
#define RK45_LAST_ROW                                                                              \
    (-12715105075.0 / 11282082432.0 * K(0) + 87487479700.0 / 32700410799.0 * K(2)                  \
     - 10690763975.0 / 1880347072.0 * K(3) + 701980252875.0 / 199316789632.0 * K(4)                \
     - 1453857185.0 / 822651844.0 * K(5) + 69997945.0 / 29380423.0 * K(6))

/* What entry i adds to the sum of squares, where errors count against `scale`. */
#define RK45_ERROR(number, scale)                                                                  \
    const number e = RK45_DIFFERENCE / (scale);                                                    \
    sum += e * e;

/* Error of a step of size h from the sum over n entries. */
#define RK45_NORM(h, n, sum) (cardan_abs(h) * cardan_sqrt((sum) / (n)))

#endif
