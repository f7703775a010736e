/*
 * tree_slopes.h: what derivatives of a tree start from: rows of M, forces at rest, accelerations.
 */
#ifndef CARDAN_TREE_SLOPES_H
#define CARDAN_TREE_SLOPES_H

#include "tree_mass.h"
#include "tree_solve.h"

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
#define CARDAN_SLOPE_STRIDE 32
#define CARDAN_PATHS 21


CARDAN_INLINE void cardan_cross_more(const real *a, const real *b, real *y)
{
    y[0] += a[1] * b[2] - a[2] * b[1];
    y[1] += a[2] * b[0] - a[0] * b[2];
    y[2] += a[0] * b[1] - a[1] * b[0];
}

CARDAN_INLINE real cardan_six(const real *x, const real *y)
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3] + x[4] * y[4] + x[5] * y[5];
}

/* What a walk over the tree reads and leaves behind. */
typedef struct cardan_slopes {
    cardan_tree tree;
    const real *numbers; /* of the bodies */
    real *sums;          /* of the numbers of bodies that add up (bodies, CARDAN_SLOPE_STRIDE) */
    real *path;          /* zeta along u, S, eta and zeta along q by levels (CARDAN_PATHS, depth) */
    real *row;           /* four rows of a path */
    real *rows;          /* of M, then of L */
    real *further;       /* acceleration by udot, then the force that it takes (bodies, 6 each) */
    real *udot;          /* by speeds in the order of the tree */
    real *zeta;          /* along q, with udot (speeds, 6) */
    real *panels;        /* right sides, panel by panel: along q, along u from `half` on, others */
    int half;            /* columns along q, rounded up to a chunk */
} cardan_slopes;

/* place of an entry of the right sides */
CARDAN_INLINE real *cardan_entry(const cardan_slopes *s, int row, int column)
{
    const unsigned place = (unsigned)column, panel = place / CARDAN_PANEL;
    return s->panels + (panel * (unsigned)s->tree.speeds + (unsigned)row) * CARDAN_PANEL
           + place % CARDAN_PANEL;
}

/* numbers of a speed of a body */
CARDAN_INLINE const real *cardan_slope_speed(const cardan_slopes *s, const int *body, int k)
{
    return s->numbers + body[CARDAN_NUMBERS] + CARDAN_SLOPE_BODY
           + (k - body[CARDAN_FIRST]) * CARDAN_SLOPE_SPEED;
}

/* Rows of M, and of the right side what elements and the caller supply less what udot = 0 takes. */
CARDAN_APART void cardan_slope_rows(const cardan_slopes *s, int rotors, const int *rotor,
                                    const real *tau)
{
    const cardan_tree *const tree = &s->tree;

    cardan_clear(6 * tree->depth, s->path);
    for (int i = 0; i < tree->bodies; ++i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const real *const sums = s->sums + CARDAN_SLOPE_STRIDE * i;
        for (int k = body[CARDAN_FIRST]; k < body[CARDAN_FIRST] + body[CARDAN_COUNT]; ++k) {
            const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
            const real *const numbers = cardan_slope_speed(s, body, k);
            real momentum[6];
            cardan_path_enter(tree, k, 6, numbers + CARDAN_S, s->path);
            cardan_momentum(sums, numbers + CARDAN_S, momentum);
            cardan_path_six(speed[CARDAN_LEVEL] + 1, tree->depth, momentum, s->path,
                            s->rows + speed[CARDAN_PLACE]);
            if (tau)
                s->udot[k] = tau[speed[CARDAN_SLOT]] + numbers[CARDAN_LOAD]
                             - cardan_six(numbers + CARDAN_S, sums + CARDAN_WRENCH);
        }
    }
    cardan_tree_rotors(tree, rotors, rotor, s->numbers, s->rows);
}

/* What udot adds: to accelerations, to zeta along q, to the forces that bodies take. */
CARDAN_APART void cardan_slope_accelerate(const cardan_slopes *s)
{
    const cardan_tree *const tree = &s->tree;
    real *const force = s->further + 6 * tree->bodies;

    for (int i = 0; i < tree->bodies; ++i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
        real *const here = s->further + 6 * i;
        real before[6];
        for (int c = 0; c < 6; ++c)
            before[c] = body[CARDAN_PARENT] < 0 ? CARDAN_REAL(0.0)
                                                : s->further[6 * body[CARDAN_PARENT] + c];
        for (int c = 0; c < 6; ++c) here[c] = before[c];
        for (int k = first; k < first + count; ++k) {
            const real *const numbers = cardan_slope_speed(s, body, k);
            const real *const column = numbers + CARDAN_S;
            real *const zeta = s->zeta + 6 * k;
            for (int c = 0; c < 6; ++c) {
                zeta[c] = numbers[CARDAN_ZETA_Q + c];
                here[c] += column[c] * s->udot[k];
            }
            /* the acceleration of the parent, seen by what is displaced along S */
            cardan_cross_more(before, column, zeta);
            cardan_cross_more(before + 3, column, zeta + 3);
            cardan_cross_more(before, column + 3, zeta + 3);
            if (body[CARDAN_MODES] < 0) continue;
            for (int j = 0; j < count; ++j) {
                const real *const change =
                    s->numbers + body[CARDAN_MODES] + 6 * (j * count + k - first);
                for (int c = 0; c < 6; ++c) zeta[c] += change[c] * s->udot[first + j];
            }
        }
        cardan_momentum(s->numbers + body[CARDAN_NUMBERS], here, force + 6 * i);
    }
    for (int i = tree->bodies - 1; i >= 0; --i) {
        const int parent = tree->body[CARDAN_BODY_ROW * i + CARDAN_PARENT];
        real *const wrench = s->sums + CARDAN_SLOPE_STRIDE * i + CARDAN_WRENCH;
        for (int c = 0; c < 6; ++c) {
            wrench[c] += force[6 * i + c];
            if (parent >= 0) force[6 * parent + c] += force[6 * i + c];
        }
    }
}

#endif
