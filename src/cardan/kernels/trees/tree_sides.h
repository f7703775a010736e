/*
 * tree_sides.h: derivatives of the inverse dynamics of a tree.
 *
 * A change of q or u at a joint moves what is outboard of it as one rigid body; besides, it changes
 * the angular velocity there by eta and the acceleration by a field zeta, linear in place. The bodies
 * outboard of a joint answer with the force I zeta + B eta, where I and B are sums over them: their
 * inertia and the flow of their momentum. So the entry of a speed and an ancestor is one product of a
 * row with a path, for what the ancestor causes at the speed and for what the speed causes there.
 *
 * Source: S. Singh, R. Russell, P. Wensing, Efficient analytical derivatives of rigid-body dynamics
 * using spatial vector algebra, IEEE Robotics and Automation Letters 7 (2022).
 */
#ifndef CARDAN_TREE_SIDES_H
#define CARDAN_TREE_SIDES_H

#include "tree_slopes.h"

/* numbers of a body that add up, with room for chunks */
enum { CARDAN_SIDE_BODY = CARDAN_WRENCH, CARDAN_SIDE_STRIDE = 24 };
#define CARDAN_PATHS 21

/* What a walk over the tree reads and leaves behind. */
typedef struct cardan_sides {
    cardan_slopes slopes;
    real *sums;   /* of the numbers of bodies that add up (bodies, CARDAN_SIDE_STRIDE) */
    real *path;   /* zeta along u, S, eta and zeta along q by levels (CARDAN_PATHS, depth) */
    real *row;    /* four rows of a path */
    real *rows;   /* of M */
    real *panels; /* panels of columns (speeds, CARDAN_PANEL): along q, u and other entries, negated */
    int half;     /* columns along q, rounded up to a chunk */
} cardan_sides;

/* place of an entry */
CARDAN_INLINE real *cardan_entry(const cardan_sides *s, int row, int column)
{
    const unsigned place = (unsigned)column, panel = place / CARDAN_PANEL;
    return s->panels + (panel * (unsigned)s->slopes.tree.speeds + (unsigned)row) * CARDAN_PANEL
           + place % CARDAN_PANEL;
}

/* y (6) += B eta: (tr K - K) eta and eta x P */
CARDAN_INLINE void cardan_flow_force(const real *body, const real *eta, real *y)
{
    const real *const k = body + CARDAN_FLOW_K;

    y[0] += (k[4] + k[8]) * eta[0] - k[1] * eta[1] - k[2] * eta[2];
    y[1] += (k[0] + k[8]) * eta[1] - k[3] * eta[0] - k[5] * eta[2];
    y[2] += (k[0] + k[4]) * eta[2] - k[6] * eta[0] - k[7] * eta[1];
    cardan_cross_more(eta, body + CARDAN_FLOW_P, y + 3);
}

/* g (3) = B^T S: the part of B eta along S is g . eta */
CARDAN_INLINE void cardan_flow_along(const real *body, const real *s, real *g)
{
    const real *const k = body + CARDAN_FLOW_K;

    g[0] = (k[4] + k[8]) * s[0] - k[3] * s[1] - k[6] * s[2];
    g[1] = (k[0] + k[8]) * s[1] - k[1] * s[0] - k[7] * s[2];
    g[2] = (k[0] + k[4]) * s[2] - k[2] * s[0] - k[5] * s[1];
    cardan_cross_more(body + CARDAN_FLOW_P, s + 3, g);
}

/*
 * row[l] = x (9) times the column of nine rows of a path at level l < count. The row lies in
 * panels, which begin `further` numbers apart: in the first one from `offset` on.
 */
CARDAN_APART void cardan_path_nine(int count, int depth, int further, int offset, const real *x,
                                   const real *path, real *row)
{
    for (int l = 0; l < count; l += CARDAN_WIDTH) {
        const real *const at = path + l;
        cardan_wide sum = x[0] * CARDAN_READ(at);
        sum += x[1] * CARDAN_READ(at + depth);
        sum += x[2] * CARDAN_READ(at + 2 * depth);
        sum += x[3] * CARDAN_READ(at + 3 * depth);
        sum += x[4] * CARDAN_READ(at + 4 * depth);
        sum += x[5] * CARDAN_READ(at + 5 * depth);
        sum += x[6] * CARDAN_READ(at + 6 * depth);
        sum += x[7] * CARDAN_READ(at + 7 * depth);
        sum += x[8] * CARDAN_READ(at + 8 * depth);
        CARDAN_AT(row + (l + offset) / CARDAN_PANEL * further + (l + offset) % CARDAN_PANEL) = sum;
    }
}

/* Entries of the speeds of one joint with each other; forces come negated. */
CARDAN_INLINE void cardan_side_block(const cardan_sides *s, const int *body, int k,
                                      const real *along_q, const real *along_u, const real *wrench)
{
    const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
    const int slot = s->slopes.tree.speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT];

    for (int j = 0; j < count; ++j) {
        const real *const column = cardan_slope_speed(&s->slopes, body, first + j) + CARDAN_S;
        real of_q = cardan_six(column, along_q);
        if (body[CARDAN_MODES] >= 0) {
            const real *const change =
                s->slopes.numbers + body[CARDAN_MODES] + 6 * (j * count + k - first);
            of_q -= cardan_six(change, wrench);
        }
        *cardan_entry(s, first + j, slot) = of_q;
        *cardan_entry(s, first + j, s->half + slot) = cardan_six(column, along_u);
    }
}

/* Entries of speed k at its ancestors and of these at it, run by run; `row` holds both by levels. */
CARDAN_INLINE void cardan_side_scatter(const cardan_sides *s, int k, int inboard, int level)
{
    const cardan_tree *const tree = &s->slopes.tree;
    const int depth = tree->depth, panel = CARDAN_PANEL;
    const int slot = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT];
    real *const of_q = cardan_entry(s, 0, slot), *const of_u = cardan_entry(s, 0, s->half + slot);

    for (int l = level - 1, j = inboard; l >= 0; --l) {
        of_q[j * panel] = s->row[l];
        of_u[j * panel] = s->row[depth + l];
        if (!tree->serial) {
            const int at = tree->speed[CARDAN_SPEED_ROW * j + CARDAN_SLOT];
            *cardan_entry(s, k, at) = s->row[2 * depth + l];
            *cardan_entry(s, k, s->half + at) = s->row[3 * depth + l];
        }
        j = cardan_inboard(tree, j);
    }
}

/* y (6) = - x (6) */
CARDAN_INLINE void cardan_negative(const real *x, real *y)
{
    for (int c = 0; c < 6; ++c) y[c] = -x[c];
}

/* Changes of the inverse dynamics along q and u, negated. */
CARDAN_APART void cardan_side_entries(const cardan_sides *s)
{
    const cardan_tree *const tree = &s->slopes.tree;
    const int depth = tree->depth, serial = tree->serial;
    const int further = serial ? tree->speeds * CARDAN_PANEL : CARDAN_PANEL;
    const int offset = serial ? s->half % CARDAN_PANEL : 0;

    cardan_clear(CARDAN_PATHS * depth, s->path);
    for (int i = 0; i < tree->bodies; ++i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const real *const sums = s->sums + CARDAN_SIDE_STRIDE * i;
        const real *const wrench = s->slopes.wrench + CARDAN_SIX * i;
        const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
        const int level = count ? tree->speed[CARDAN_SPEED_ROW * first + CARDAN_LEVEL] : 0;
        const int inboard = count ? cardan_inboard(tree, first) : -1;
        for (int k = first; k < first + count; ++k) {
            const real *const numbers = cardan_slope_speed(&s->slopes, body, k);
            const real *const column = numbers + CARDAN_S, *const zeta = s->slopes.zeta + CARDAN_SIX * k;
            real along_q[6], along_u[6], moved[6], there[6], answer[12];

            /* how the speed answers to what its ancestors cause: rows of serial speeds go to their
             * panels, and what stands behind their ends there is overwritten later */
            cardan_momentum(sums, column, there);
            cardan_flow_along(sums, column, moved);
            for (int c = 0; c < 3; ++c) answer[c] = answer[9 + c] = -moved[c];
            for (int c = 0; c < 6; ++c) answer[3 + c] = -there[c];
            cardan_path_nine(level, depth, further, 0, answer, s->path + CARDAN_ETA_Q * depth,
                             serial ? cardan_entry(s, k, 0) : s->row + 2 * depth);
            cardan_path_nine(level, depth, further, offset, answer + 3,
                             s->path + CARDAN_ZETA_U * depth,
                             serial ? cardan_entry(s, k, s->half) - offset : s->row + 3 * depth);

            /* what the speed asks of all that it moves */
            cardan_momentum(sums, zeta, there);
            cardan_flow_force(sums, numbers + CARDAN_ETA_Q, there);
            cardan_negative(there, along_q);
            cardan_momentum(sums, numbers + CARDAN_ZETA_U, moved);
            cardan_flow_force(sums, column, moved);
            cardan_negative(moved, along_u);
            cardan_side_block(s, body, k, along_q, along_u, wrench);

            /* inboard of the joint, forces are displaced too */
            cardan_cross_more(column, wrench, there);
            cardan_cross_more(column + 3, wrench + 3, there);
            cardan_cross_more(column, wrench + 3, there + 3);
            cardan_negative(there, along_q);
            cardan_path_six(level, depth, along_q, s->path + CARDAN_S * depth, s->row);
            cardan_path_six(level, depth, along_u, s->path + CARDAN_S * depth, s->row + depth);
            cardan_side_scatter(s, k, inboard, level);
        }
        for (int k = first; k < first + count; ++k) {
            const real *const numbers = cardan_slope_speed(&s->slopes, body, k);
            cardan_path_enter(tree, k, CARDAN_ZETA_Q, numbers, s->path);
            cardan_path_enter(tree, k, 6, s->slopes.zeta + CARDAN_SIX * k, s->path + CARDAN_ZETA_Q * depth);
        }
    }
}

/* Rows of M. */
CARDAN_APART void cardan_side_rows(const cardan_sides *s, int rotors, const int *rotor)
{
    const cardan_tree *const tree = &s->slopes.tree;

    cardan_clear(6 * tree->depth, s->path);
    for (int i = 0; i < tree->bodies; ++i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const real *const sums = s->sums + CARDAN_SIDE_STRIDE * i;
        for (int k = body[CARDAN_FIRST]; k < body[CARDAN_FIRST] + body[CARDAN_COUNT]; ++k) {
            const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
            const real *const column = cardan_slope_speed(&s->slopes, body, k) + CARDAN_S;
            real momentum[6];
            cardan_path_enter(tree, k, 6, column, s->path);
            cardan_momentum(sums, column, momentum);
            cardan_path_six(speed[CARDAN_LEVEL] + 1, tree->depth, momentum, s->path,
                            s->rows + speed[CARDAN_PLACE]);
        }
    }
    cardan_tree_rotors(tree, rotors, rotor, s->slopes.numbers, s->rows);
}

/* Columns to rows of out by slots. */
CARDAN_INLINE void cardan_side_columns(const cardan_sides *s, int width, int first, real *out)
{
    for (int k = 0; k < s->slopes.tree.speeds; ++k) {
        real *const row = out + s->slopes.tree.speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT] * width;
        for (int c = 0, count; c < width; c += count) {
            const int inside = CARDAN_PANEL - (first + c) % CARDAN_PANEL;
            count = inside < width - c ? inside : width - c;
            memcpy(row + c, cardan_entry(s, k, first + c), (size_t)count * sizeof(real));
        }
    }
}

/*
 * Derivatives to out, from the motion under s->slopes.udot.
 *
 * columns: besides those along q and u. outputs, changes, rotors: as of cardan_tree_derivatives.
 */
CARDAN_APART void cardan_side_derivatives(const cardan_sides *s, int columns, int outputs,
                                          const int *output, int changes, const int *change,
                                          int rotors, const int *rotor, real *out)
{
    const int speeds = s->slopes.tree.speeds, count = 2 * s->half + columns;
    const int size = (count + CARDAN_PANEL - 1) / CARDAN_PANEL * speeds * CARDAN_PANEL;

    cardan_tree_sums(&s->slopes.tree, CARDAN_SIDE_BODY, CARDAN_SIDE_STRIDE, s->slopes.numbers,
                     s->sums);
    for (int i = 0; i < s->slopes.tree.bodies; ++i) cardan_slope_accelerate(&s->slopes, i);
    cardan_slope_wrenches(&s->slopes);
    cardan_clear(size, s->panels);
    cardan_side_entries(s);
    for (int n = 0; n < changes; ++n)
        *cardan_entry(s, change[3 * n], change[3 * n + 1]) += s->slopes.numbers[change[3 * n + 2]];
    for (int m = 0; m < size; ++m) s->panels[m] = -s->panels[m];
    for (int n = 0; n < outputs; ++n) {
        const int width = output[3 * n + 1], first = output[3 * n + 2];
        if (output[3 * n] == CARDAN_OF_M) {
            cardan_side_rows(s, rotors, rotor);
            cardan_tree_square(&s->slopes.tree, s->rows, out);
        } else {
            cardan_side_columns(s, width, first, out);
        }
        out += speeds * width;
    }
}

#endif
