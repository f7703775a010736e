/*
 * tree_slopes.h: what derivatives of a tree start from: the motion under udot and the forces of it.
 */
#ifndef CARDAN_TREE_SLOPES_H
#define CARDAN_TREE_SLOPES_H

#include "tree_mass.h"

/*
 * Numbers of a body: those of tree_mass.h, twice its momentum P (3), twice its flow of momentum K (9,
 * the integral of v x^T dm), moment and force that it takes at udot = 0 less those applied to it (6).
 * Of a speed: zeta along u (6), the column S (6), eta along q (3), zeta along q at udot = 0 (6), the
 * force of elements along it. Of the modes of a joint: change of column j of S along q_k, row by row
 * of j, where it is not fixed to the body.
 */
enum { CARDAN_FLOW_P = 10, CARDAN_FLOW_K = 13, CARDAN_WRENCH = 22, CARDAN_SLOPE_BODY = 28 };
enum { CARDAN_ZETA_U = 0, CARDAN_S = 6, CARDAN_ETA_Q = 12, CARDAN_ZETA_Q = 15, CARDAN_LOAD = 21,
       CARDAN_SLOPE_SPEED = 22 };

CARDAN_INLINE void cardan_cross_more(const real *a, const real *b, real *y)
{
    y[0] += a[1] * b[2] - a[2] * b[1];
    y[1] += a[2] * b[0] - a[0] * b[2];
    y[2] += a[0] * b[1] - a[1] * b[0];
}

/* product of six numbers with six, in two sums that do not wait for each other */
CARDAN_INLINE real cardan_six(const real *x, const real *y)
{
    const real a = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    const real b = x[3] * y[3] + x[4] * y[4] + x[5] * y[5];

    return a + b;
}

/*
 * Six numbers with room for a chunk, of which what lies behind the six is read by nobody; it may come
 * from whatever stands behind the six where they come from.
 */
#define CARDAN_SIX CARDAN_CHUNK

CARDAN_INLINE void cardan_six_copy(const real *x, real *y)
{
    for (int c = 0; c < 6; c += CARDAN_WIDTH) CARDAN_AT(y + c) = CARDAN_READ(x + c);
}

CARDAN_INLINE void cardan_six_add(const real *x, real *y)
{
    for (int c = 0; c < 6; c += CARDAN_WIDTH) CARDAN_AT(y + c) += CARDAN_READ(x + c);
}

CARDAN_INLINE void cardan_six_more(real factor, const real *x, real *y)
{
    for (int c = 0; c < 6; c += CARDAN_WIDTH) CARDAN_AT(y + c) += factor * CARDAN_READ(x + c);
}

CARDAN_INLINE void cardan_six_less(real factor, const real *x, real *y)
{
    for (int c = 0; c < 6; c += CARDAN_WIDTH) CARDAN_AT(y + c) -= factor * CARDAN_READ(x + c);
}

/* columns of a panel */
#define CARDAN_PANEL (2 * CARDAN_WIDTH)
/* kinds of outputs */
enum { CARDAN_COLUMNS, CARDAN_OF_M };

/* What a walk over the tree reads and leaves behind. */
typedef struct cardan_slopes {
    cardan_tree tree;
    const real *numbers; /* of the bodies */
    real *further;       /* acceleration by udot (bodies, CARDAN_SIX) */
    real *wrench;        /* moment and force of a body with all that it carries (bodies, CARDAN_SIX) */
    real *udot;          /* by speeds in the order of the tree */
    real *zeta;          /* along q, with udot (speeds, CARDAN_SIX) */
} cardan_slopes;

/* numbers of a speed of a body */
CARDAN_INLINE const real *cardan_slope_speed(const cardan_slopes *s, const int *body, int k)
{
    return s->numbers + body[CARDAN_NUMBERS] + CARDAN_SLOPE_BODY
           + (k - body[CARDAN_FIRST]) * CARDAN_SLOPE_SPEED;
}

/* What udot adds at a body: to its acceleration, to zeta along q, to the force that it takes. */
CARDAN_APART void cardan_slope_accelerate(const cardan_slopes *s, int i)
{
    const int *const body = s->tree.body + CARDAN_BODY_ROW * i;
    const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT], parent = body[CARDAN_PARENT];
    const real *const numbers = s->numbers + body[CARDAN_NUMBERS];
    const real *const before = s->further + CARDAN_SIX * parent;
    real *const here = s->further + CARDAN_SIX * i, *const wrench = s->wrench + CARDAN_SIX * i;

    if (parent < 0)
        cardan_clear(CARDAN_SIX, here);
    else
        cardan_six_copy(before, here);
    for (int k = first; k < first + count; ++k) {
        const real *const speed = cardan_slope_speed(s, body, k), *const column = speed + CARDAN_S;
        real *const zeta = s->zeta + CARDAN_SIX * k;
        cardan_six_more(s->udot[k], column, here);
        cardan_six_copy(speed + CARDAN_ZETA_Q, zeta);
        /* the acceleration of the parent, seen by what is displaced along S */
        if (parent >= 0) {
            cardan_cross_more(before, column, zeta);
            cardan_cross_more(before + 3, column, zeta + 3);
            cardan_cross_more(before, column + 3, zeta + 3);
        }
        if (body[CARDAN_MODES] < 0) continue;
        for (int j = 0; j < count; ++j) {
            const real *const change = s->numbers + body[CARDAN_MODES] + 6 * (j * count + k - first);
            for (int c = 0; c < 6; ++c) zeta[c] += change[c] * s->udot[first + j];
        }
    }
    cardan_momentum(numbers, here, wrench);
    cardan_six_add(numbers + CARDAN_WRENCH, wrench);
}

/* Forces that bodies take become those that they take with all that they carry. */
CARDAN_APART void cardan_slope_wrenches(const cardan_slopes *s)
{
    for (int i = s->tree.bodies - 1; i >= 0; --i) {
        const int parent = s->tree.body[CARDAN_BODY_ROW * i + CARDAN_PARENT];
        if (parent >= 0)
            cardan_six_add(s->wrench + CARDAN_SIX * i, s->wrench + CARDAN_SIX * parent);
    }
}

#endif
