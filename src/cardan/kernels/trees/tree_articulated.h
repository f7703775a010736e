/*
 * tree_articulated.h: articulated bodies of a tree, and accelerations for many right sides at once.
 *
 * An articulated body is a body with all that it carries, whose joints outboard give way: its force
 * under an acceleration a that it shares with what it carries, and under a change eta of their
 * angular velocities, is A (6, 9) [a; eta] + p, with the inertia and the flow of momentum in A and
 * with p what joints and other forces leave of themselves. In axes of the ground about one origin,
 * articulated bodies add up as they stand, so a right side passes over a body in two products of
 * six numbers inward and as many outward: the work for all columns grows with the square of the
 * number of bodies.
 *
 * Where a change acts as one acceleration on all that a joint carries, as changes of q and u do,
 * nothing of it travels inward there: it joins the acceleration that travels outward.
 *
 * Speeds of one joint are eliminated together: in L^T u the block of M that belongs to the joint is
 * the diagonal D. Columns go in panels of two vectors.
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, chapter 7.
 */
#ifndef CARDAN_TREE_ARTICULATED_H
#define CARDAN_TREE_ARTICULATED_H

#include "tree_slopes.h"

/* A of a body: nine columns */
#define CARDAN_MATRIX (9 * CARDAN_SIX)
/*
 * Gains of a speed: where it acts (6 of a chunk), the share of an acceleration and an eta that it takes
 * (6 of a chunk, 3), 1 / D, its row of L among the speeds of its joint.
 */
enum { CARDAN_SHARE = CARDAN_CHUNK, CARDAN_SHARE_ETA = 2 * CARDAN_CHUNK,
       CARDAN_PIVOT = CARDAN_SHARE_ETA + 3, CARDAN_WITHIN, CARDAN_GAINS = CARDAN_WITHIN + 6 };
/*
 * What changes of q and u at a speed cause: the forces that what it carries asks for by them, of which
 * six of a chunk count; the force that q displaces inboard of the joint; zeta (6 of a chunk)
 * and eta (3) along q and along u.
 */
enum { CARDAN_FORCE_Q = 0, CARDAN_FORCE_U = CARDAN_CHUNK, CARDAN_DISPLACED = 2 * CARDAN_CHUNK,
       CARDAN_ALONG_Q = 3 * CARDAN_CHUNK, CARDAN_ALONG_U = 5 * CARDAN_CHUNK,
       CARDAN_CAUSE = 7 * CARDAN_CHUNK };

typedef struct cardan_articulated {
    cardan_slopes slopes;
    real *matrices; /* A (bodies, CARDAN_MATRIX) */
    real *gains;    /* of speeds (speeds, CARDAN_GAINS) */
    real *causes;   /* (speeds, CARDAN_CAUSE) */
    real *inward;   /* force of other children at bodies with several (branches, 6, CARDAN_PANEL) */
    real *outward;  /* accelerations and etas of such bodies (branches, 9, CARDAN_PANEL) */
    real *panel;    /* (speeds, CARDAN_PANEL) */
} cardan_articulated;

/* the reciprocal of a pivot, NaN where it is not positive: then the status says so */
CARDAN_INLINE int cardan_pivot(real *pivot)
{
    int status = CARDAN_OK;
#if CARDAN_LANES > 1
    for (int lane = 0; lane < CARDAN_LANES; ++lane)
        if (!((*pivot)[lane] > 0.0)) {
            (*pivot)[lane] = NAN;
            status = CARDAN_SINGULAR;
        }
#else
    if (!(*pivot > 0.0)) {
        *pivot = NAN;
        status = CARDAN_SINGULAR;
    }
#endif
    *pivot = 1.0 / *pivot;
    return status;
}

/* a column of A */
CARDAN_INLINE void cardan_matrix_column(real *y, real a, real b, real c, real d, real e, real f)
{
    y[0] = a;
    y[1] = b;
    y[2] = c;
    y[3] = d;
    y[4] = e;
    y[5] = f;
    cardan_clear(CARDAN_SIX - 6, y + 6);
}

/* A of a body by itself */
CARDAN_INLINE void cardan_matrix_of_body(const real *body, real *y)
{
    const real none = CARDAN_REAL(0.0), *const k = body + CARDAN_FLOW_K;
    const real m = body[0], a = body[1], b = body[2], c = body[3];
    const real *const p = body + CARDAN_FLOW_P;
    const int next = CARDAN_SIX;

    cardan_matrix_column(y, body[4], body[5], body[6], none, -c, b);
    cardan_matrix_column(y + next, body[5], body[7], body[8], c, none, -a);
    cardan_matrix_column(y + 2 * next, body[6], body[8], body[9], -b, a, none);
    cardan_matrix_column(y + 3 * next, none, c, -b, m, none, none);
    cardan_matrix_column(y + 4 * next, -c, none, a, none, m, none);
    cardan_matrix_column(y + 5 * next, b, -a, none, none, none, m);
    cardan_matrix_column(y + 6 * next, k[4] + k[8], -k[3], -k[6], none, -p[2], p[1]);
    cardan_matrix_column(y + 7 * next, -k[1], k[0] + k[8], -k[7], p[2], none, -p[0]);
    cardan_matrix_column(y + 8 * next, -k[2], -k[5], k[0] + k[4], -p[1], p[0], none);
}

/* y (6 of a chunk) = A [x; eta], or the part of A that belongs to x where eta is NULL */
CARDAN_INLINE void cardan_matrix_times(const real *matrix, const real *x, const real *eta, real *y)
{
    const int next = CARDAN_SIX;

    for (int l = 0; l < 6; l += CARDAN_WIDTH) {
        const real *const at = matrix + l;
        cardan_wide sum = x[0] * CARDAN_READ(at), more = x[3] * CARDAN_READ(at + 3 * next);
        sum += x[1] * CARDAN_READ(at + next);
        more += x[4] * CARDAN_READ(at + 4 * next);
        sum += x[2] * CARDAN_READ(at + 2 * next);
        more += x[5] * CARDAN_READ(at + 5 * next);
        if (eta) {
            sum += eta[0] * CARDAN_READ(at + 6 * next);
            more += eta[1] * CARDAN_READ(at + 7 * next);
            sum += eta[2] * CARDAN_READ(at + 8 * next);
        }
        CARDAN_AT(y + l) = sum + more;
    }
}

/* Row i of a joint's gains less a multiple of row j, as L^T D L of its block of M asks for. */
CARDAN_INLINE void cardan_gain_less(int i, int j, real *gains, real *moved)
{
    real *const gain = gains + CARDAN_GAINS * i, *const pivot = gains + CARDAN_GAINS * j;
    const real factor = gain[CARDAN_WITHIN + j] * pivot[CARDAN_PIVOT];

    for (int m = j + 1; m <= i; ++m)
        gain[CARDAN_WITHIN + m] -= factor * gains[CARDAN_GAINS * m + CARDAN_WITHIN + j];
    gain[CARDAN_WITHIN + j] = factor;
    cardan_six_less(factor, pivot, gain);
    cardan_six_less(factor, moved + CARDAN_SIX * j, moved + CARDAN_SIX * i);
    for (int c = 0; c < 3; ++c)
        gain[CARDAN_SHARE_ETA + c] -= factor * pivot[CARDAN_SHARE_ETA + c];
}

/*
 * Gains of the speeds of a joint from A of its body. On entry their rows of L have the inertia of
 * rotors. moved: (speeds of the joint, CARDAN_SIX): the shares of an acceleration times D.
 */
CARDAN_APART int cardan_joint_factor(const cardan_slopes *s, const int *body, const real *matrix,
                                     real *gains, real *moved)
{
    const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
    int status = CARDAN_OK;

    for (int i = 0; i < count; ++i) {
        real *const gain = gains + CARDAN_GAINS * i, *const share = gain + CARDAN_SHARE_ETA;
        const real *const column = cardan_slope_speed(s, body, first + i) + CARDAN_S;
        cardan_six_copy(column, gain);
        cardan_matrix_times(matrix, column, NULL, moved + CARDAN_SIX * i);
        share[0] = cardan_six(matrix + 6 * CARDAN_SIX, column);
        share[1] = cardan_six(matrix + 7 * CARDAN_SIX, column);
        share[2] = cardan_six(matrix + 8 * CARDAN_SIX, column);
        for (int j = 0; j <= i; ++j)
            gain[CARDAN_WITHIN + j] += cardan_six(column, moved + CARDAN_SIX * j);
    }
    /* L^T D L of the block, from the first speed on */
    for (int j = 0; j < count; ++j) {
        real *const pivot = gains + CARDAN_GAINS * j, *const share = pivot + CARDAN_SHARE_ETA;
        pivot[CARDAN_PIVOT] = pivot[CARDAN_WITHIN + j];
        status |= cardan_pivot(pivot + CARDAN_PIVOT);
        for (int i = count - 1; i > j; --i) cardan_gain_less(i, j, gains, moved);
        for (int c = 0; c < 6; c += CARDAN_WIDTH)
            CARDAN_AT(pivot + CARDAN_SHARE + c) =
                pivot[CARDAN_PIVOT] * CARDAN_READ(moved + CARDAN_SIX * j + c);
        share[0] *= pivot[CARDAN_PIVOT];
        share[1] *= pivot[CARDAN_PIVOT];
        share[2] *= pivot[CARDAN_PIVOT];
    }
    return status;
}

/* A of a parent, with what is left of A of its child where the joint gives way. */
CARDAN_APART void cardan_matrix_inward(int count, const real *gains, const real *moved,
                                       const real *matrix, real *parent)
{
    for (int c = 0; c < 9; ++c) {
        const real *const share = gains + (c < 6 ? CARDAN_SHARE + c : CARDAN_SHARE_ETA + c - 6);
        for (int l = CARDAN_SIX * c; l < CARDAN_SIX * c + 6; l += CARDAN_WIDTH) {
            cardan_wide sum = CARDAN_READ(matrix + l);
            for (int j = 0; j < count; ++j)
                sum -= share[CARDAN_GAINS * j] * CARDAN_READ(moved + CARDAN_SIX * j + l - CARDAN_SIX * c);
            CARDAN_AT(parent + l) += sum;
        }
    }
}

/* Forces on the speeds of a joint (count) become what they leave of themselves, over D. */
CARDAN_INLINE void cardan_joint_inward(int count, const real *gains, real *x, real *force)
{
    for (int i = 1; i < count; ++i)
        for (int j = 0; j < i; ++j) x[i] -= gains[CARDAN_GAINS * i + CARDAN_WITHIN + j] * x[j];
    for (int i = 0; i < count; ++i) x[i] -= cardan_six(gains + CARDAN_GAINS * i, force);
    for (int i = 0; i < count; ++i) {
        const real *const gain = gains + CARDAN_GAINS * i;
        cardan_six_more(x[i], gain + CARDAN_SHARE, force);
        x[i] *= gain[CARDAN_PIVOT];
    }
}

/*
 * A, gains and, on the way, what applied forces, `tau` and the motion at udot = 0 leave for udot.
 * rotors: rows of (speed, speed, place) that add to M.
 */
CARDAN_APART int cardan_tree_articulate(const cardan_articulated *a, int rotors, const int *rotor,
                                        const real *tau)
{
    const cardan_slopes *const s = &a->slopes;
    const cardan_tree *const tree = &s->tree;
    int status = CARDAN_OK;

    cardan_clear(CARDAN_GAINS * tree->speeds, a->gains);
    for (int n = 0; n < rotors; ++n) {
        const int *const at = rotor + 3 * n;
        const int first = tree->speed[CARDAN_SPEED_ROW * at[0] + CARDAN_JOINT];
        a->gains[CARDAN_GAINS * at[0] + CARDAN_WITHIN + at[1] - first] += s->numbers[at[2]];
    }
    for (int i = 0; i < tree->bodies; ++i) {
        const real *const numbers = s->numbers + tree->body[CARDAN_BODY_ROW * i + CARDAN_NUMBERS];
        cardan_matrix_of_body(numbers, a->matrices + CARDAN_MATRIX * i);
        cardan_six_copy(numbers + CARDAN_WRENCH, s->wrench + CARDAN_SIX * i);
    }
    /* inward: joints give way, and what is left joins the parent */
    for (int i = tree->bodies - 1; i >= 0; --i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const int parent = body[CARDAN_PARENT], first = body[CARDAN_FIRST];
        const real *const matrix = a->matrices + CARDAN_MATRIX * i;
        real *const gains = a->gains + CARDAN_GAINS * first;
        real moved[6 * CARDAN_SIX];
        status |= cardan_joint_factor(s, body, matrix, gains, moved);
        for (int k = first; k < first + body[CARDAN_COUNT]; ++k)
            s->udot[k] = tau[tree->speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT]]
                         + cardan_slope_speed(s, body, k)[CARDAN_LOAD];
        cardan_joint_inward(body[CARDAN_COUNT], gains, s->udot + first,
                            s->wrench + CARDAN_SIX * i);
        if (parent < 0) continue;
        cardan_six_add(s->wrench + CARDAN_SIX * i, s->wrench + CARDAN_SIX * parent);
        cardan_matrix_inward(body[CARDAN_COUNT], gains, moved, matrix,
                             a->matrices + CARDAN_MATRIX * parent);
    }
    return status;
}

/* udot and, with it, the motion of all bodies and the forces that they take. */
CARDAN_APART void cardan_tree_accelerate(const cardan_articulated *a)
{
    const cardan_slopes *const s = &a->slopes;

    for (int i = 0; i < s->tree.bodies; ++i) {
        const int *const body = s->tree.body + CARDAN_BODY_ROW * i;
        const int count = body[CARDAN_COUNT];
        const real *const gains = a->gains + CARDAN_GAINS * body[CARDAN_FIRST];
        real *const x = s->udot + body[CARDAN_FIRST];
        const int parent = body[CARDAN_PARENT];
        for (int k = 0; parent >= 0 && k < count; ++k)
            x[k] -= cardan_six(gains + CARDAN_GAINS * k + CARDAN_SHARE,
                               s->further + CARDAN_SIX * parent);
        for (int j = count - 2; j >= 0; --j)
            for (int k = j + 1; k < count; ++k)
                x[j] -= gains[CARDAN_GAINS * k + CARDAN_WITHIN + j] * x[k];
        cardan_slope_accelerate(s, i);
    }
    cardan_slope_wrenches(s);
}

/* Causes of all speeds. */
CARDAN_APART void cardan_tree_causes(const cardan_articulated *a)
{
    const cardan_slopes *const s = &a->slopes;

    for (int i = 0; i < s->tree.bodies; ++i) {
        const int *const body = s->tree.body + CARDAN_BODY_ROW * i;
        const real *const matrix = a->matrices + CARDAN_MATRIX * i, *const wrench = s->wrench + CARDAN_SIX * i;
        for (int k = body[CARDAN_FIRST]; k < body[CARDAN_FIRST] + body[CARDAN_COUNT]; ++k) {
            const real *const numbers = cardan_slope_speed(s, body, k);
            const real *const column = numbers + CARDAN_S;
            real *const cause = a->causes + CARDAN_CAUSE * k;
            real *const moved = cause + CARDAN_DISPLACED;
            real *const along_q = cause + CARDAN_ALONG_Q, *const along_u = cause + CARDAN_ALONG_U;
            cardan_six_copy(s->zeta + CARDAN_SIX * k, along_q);
            cardan_six_copy(numbers + CARDAN_ZETA_U, along_u);
            for (int c = 0; c < 3; ++c) along_q[6 + c] = numbers[CARDAN_ETA_Q + c];
            for (int c = 0; c < 3; ++c) along_u[6 + c] = column[c];
            cardan_matrix_times(matrix, along_q, along_q + 6, cause + CARDAN_FORCE_Q);
            cardan_matrix_times(matrix, along_u, along_u + 6, cause + CARDAN_FORCE_U);
            cardan_clear(6, moved);
            cardan_cross_more(column, wrench, moved);
            cardan_cross_more(column + 3, wrench + 3, moved);
            cardan_cross_more(column, wrench + 3, moved + 3);
        }
    }
}

#endif
