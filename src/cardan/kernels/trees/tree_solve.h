/*
 * tree_solve.h: M = L^T D L of a tree, and solutions for many columns at once.
 *
 * A row of M holds the entries of a speed with those between it and the ground, level by level: zeros
 * due to branches have no place in it. Rows are eliminated from the leaves inward, which fills in
 * nothing. Columns are solved in panels of two vectors; where four speeds follow each other, their
 * rows go over a panel together, so that it passes through registers a fourth as often.
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, section 6.5.
 */
#ifndef CARDAN_TREE_SOLVE_H
#define CARDAN_TREE_SOLVE_H

#include "tree.h"

/* columns of a panel; speeds whose rows go over it together */
#define CARDAN_PANEL (2 * CARDAN_WIDTH)
#define CARDAN_ROWS 4

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

/* x -= factor * y, `count` entries and those of the chunk behind them */
CARDAN_INLINE void cardan_row_less(int count, real factor, const real *y, real *x)
{
    for (int l = 0; l < count; l += CARDAN_WIDTH) CARDAN_AT(x + l) -= factor * CARDAN_READ(y + l);
}

/* row of M of a speed */
CARDAN_INLINE real *cardan_row(const cardan_tree *tree, int k, real *rows)
{
    return rows + tree->speed[CARDAN_SPEED_ROW * k + CARDAN_PLACE];
}

/* Eliminate speed k from the rows of its `count` nearest ancestors; its row keeps the factors. */
CARDAN_INLINE void cardan_tree_eliminate(const cardan_tree *tree, int k, int count, real *rows)
{
    const int level = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_LEVEL];
    real *const row = cardan_row(tree, k, rows);

    for (int l = level - 1, j = cardan_inboard(tree, k); l >= level - count; --l) {
        const real factor = row[l] * row[level];
        cardan_row_less(l + 1, factor, row, cardan_row(tree, j, rows));
        row[l] = factor;
        j = cardan_inboard(tree, j);
    }
}

/* The same for speeds k - 3 ... k of a run and all of their ancestors. */
CARDAN_INLINE int cardan_tree_eliminate_four(const cardan_tree *tree, int k, real *rows)
{
    real *const row_a = cardan_row(tree, k, rows), *const row_b = cardan_row(tree, k - 1, rows);
    real *const row_c = cardan_row(tree, k - 2, rows), *const row_d = cardan_row(tree, k - 3, rows);
    const int level = tree->speed[CARDAN_SPEED_ROW * (k - 3) + CARDAN_LEVEL];
    int status;

    /* among themselves */
    status = cardan_pivot(row_a + level + 3);
    cardan_tree_eliminate(tree, k, 3, rows);
    status |= cardan_pivot(row_b + level + 2);
    cardan_tree_eliminate(tree, k - 1, 2, rows);
    status |= cardan_pivot(row_c + level + 1);
    cardan_tree_eliminate(tree, k - 2, 1, rows);
    status |= cardan_pivot(row_d + level);

    for (int l = level - 1, j = cardan_inboard(tree, k - 3); l >= 0; --l) {
        const real a = row_a[l] * row_a[level + 3], b = row_b[l] * row_b[level + 2];
        const real c = row_c[l] * row_c[level + 1], d = row_d[l] * row_d[level];
        real *const row = cardan_row(tree, j, rows);
        for (int m = 0; m <= l; m += CARDAN_WIDTH) {
            cardan_wide x = CARDAN_READ(row + m);
            x -= a * CARDAN_READ(row_a + m);
            x -= b * CARDAN_READ(row_b + m);
            x -= c * CARDAN_READ(row_c + m);
            x -= d * CARDAN_READ(row_d + m);
            CARDAN_AT(row + m) = x;
        }
        row_a[l] = a;
        row_b[l] = b;
        row_c[l] = c;
        row_d[l] = d;
        j = cardan_inboard(tree, j);
    }
    return status;
}

/* Rows of M become those of L, with reciprocals of D at their ends. */
CARDAN_APART int cardan_tree_factor(const cardan_tree *tree, real *rows)
{
    int status = CARDAN_OK, k = tree->speeds - 1;

    while (k >= 0) {
        const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
        if (k - speed[CARDAN_RUN] + 1 >= CARDAN_ROWS) {
            status |= cardan_tree_eliminate_four(tree, k, rows);
            k -= CARDAN_ROWS;
        } else {
            status |= cardan_pivot(cardan_row(tree, k, rows) + speed[CARDAN_LEVEL]);
            cardan_tree_eliminate(tree, k, speed[CARDAN_LEVEL], rows);
            k -= 1;
        }
    }
    return status;
}

/* the sum of row[l] * x[l] for `count` entries, in four sums that do not wait for each other */
CARDAN_INLINE real cardan_row_dot(int count, const real *row, const real *x)
{
    real a = CARDAN_REAL(0.0), b = a, c = a, d = a;
    int l = 0;

    for (; l + 4 <= count; l += 4) {
        a += row[l] * x[l];
        b += row[l + 1] * x[l + 1];
        c += row[l + 2] * x[l + 2];
        d += row[l + 3] * x[l + 3];
    }
    for (; l < count; ++l) a += row[l] * x[l];
    return (a + b) + (c + d);
}

/* x (speeds) becomes the solution of M x = right side; ancestors are visited run by run. */
CARDAN_APART void cardan_tree_solve(const cardan_tree *tree, const real *rows, real *x)
{
    /* L^T from the leaves inward */
    for (int k = tree->speeds - 1; k >= 0; --k) {
        const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
        const real *const row = rows + speed[CARDAN_PLACE];
        const real xk = x[k];
        int level = speed[CARDAN_LEVEL], j = cardan_inboard(tree, k);
        while (j >= 0) {
            const int *const run = tree->speed + CARDAN_SPEED_ROW * j;
            const int count = j - run[CARDAN_RUN] + 1;
            real *const y = x + run[CARDAN_RUN];
            level -= count;
            for (int l = 0; l < count; ++l) y[l] -= row[level + l] * xk;
            j = run[CARDAN_BEFORE];
        }
    }
    /* D, then L outward */
    for (int k = 0; k < tree->speeds; ++k) {
        const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
        const real *const row = rows + speed[CARDAN_PLACE];
        int level = speed[CARDAN_LEVEL], j = cardan_inboard(tree, k);
        real sum = x[k] * row[level];
        while (j >= 0) {
            const int *const run = tree->speed + CARDAN_SPEED_ROW * j;
            const int count = j - run[CARDAN_RUN] + 1;
            level -= count;
            sum -= cardan_row_dot(count, row + level, x + run[CARDAN_RUN]);
            j = run[CARDAN_BEFORE];
        }
        x[k] = sum;
    }
}

/* One row of L^T over a panel: rows of its ancestors lose multiples of its own. */
CARDAN_INLINE void cardan_panel_inward(const cardan_tree *tree, int k, const real *rows, real *panel)
{
    const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
    const real *const row = rows + speed[CARDAN_PLACE];
    const real *const x = panel + k * CARDAN_PANEL;
    const cardan_wide left = CARDAN_READ(x), right = CARDAN_READ(x + CARDAN_WIDTH);

    for (int l = speed[CARDAN_LEVEL] - 1, j = cardan_inboard(tree, k); l >= 0; --l) {
        real *const y = panel + j * CARDAN_PANEL;
        CARDAN_AT(y) -= row[l] * left;
        CARDAN_AT(y + CARDAN_WIDTH) -= row[l] * right;
        j = cardan_inboard(tree, j);
    }
}

/* The same of four rows k - 3 ... k of a run, over all that lies inboard of them. */
CARDAN_INLINE void cardan_panel_inward_four(const cardan_tree *tree, int k, const real *rows,
                                                real *panel)
{
    const int *const speed = tree->speed + CARDAN_SPEED_ROW * (k - 3);
    const real *const row_a = rows + speed[3 * CARDAN_SPEED_ROW + CARDAN_PLACE];
    const real *const row_b = rows + speed[2 * CARDAN_SPEED_ROW + CARDAN_PLACE];
    const real *const row_c = rows + speed[CARDAN_SPEED_ROW + CARDAN_PLACE];
    const real *const row_d = rows + speed[CARDAN_PLACE];
    const int level = speed[CARDAN_LEVEL];
    real *const x = panel + (k - 3) * CARDAN_PANEL;
    cardan_wide a, b, c, d, a2, b2, c2, d2;

    /* among themselves */
    a = CARDAN_READ(x + 3 * CARDAN_PANEL);
    b = CARDAN_READ(x + 2 * CARDAN_PANEL) - row_a[level + 2] * a;
    c = CARDAN_READ(x + CARDAN_PANEL) - row_a[level + 1] * a;
    c -= row_b[level + 1] * b;
    d = CARDAN_READ(x) - row_a[level] * a;
    d -= row_b[level] * b;
    d -= row_c[level] * c;
    CARDAN_AT(x + 2 * CARDAN_PANEL) = b;
    CARDAN_AT(x + CARDAN_PANEL) = c;
    CARDAN_AT(x) = d;
    a2 = CARDAN_READ(x + 3 * CARDAN_PANEL + CARDAN_WIDTH);
    b2 = CARDAN_READ(x + 2 * CARDAN_PANEL + CARDAN_WIDTH) - row_a[level + 2] * a2;
    c2 = CARDAN_READ(x + CARDAN_PANEL + CARDAN_WIDTH) - row_a[level + 1] * a2;
    c2 -= row_b[level + 1] * b2;
    d2 = CARDAN_READ(x + CARDAN_WIDTH) - row_a[level] * a2;
    d2 -= row_b[level] * b2;
    d2 -= row_c[level] * c2;
    CARDAN_AT(x + 2 * CARDAN_PANEL + CARDAN_WIDTH) = b2;
    CARDAN_AT(x + CARDAN_PANEL + CARDAN_WIDTH) = c2;
    CARDAN_AT(x + CARDAN_WIDTH) = d2;

    for (int l = level - 1, j = cardan_inboard(tree, k - 3); l >= 0; --l) {
        real *const y = panel + j * CARDAN_PANEL;
        cardan_wide left = CARDAN_READ(y), right = CARDAN_READ(y + CARDAN_WIDTH);
        left -= row_a[l] * a;
        right -= row_a[l] * a2;
        left -= row_b[l] * b;
        right -= row_b[l] * b2;
        left -= row_c[l] * c;
        right -= row_c[l] * c2;
        left -= row_d[l] * d;
        right -= row_d[l] * d2;
        CARDAN_AT(y) = left;
        CARDAN_AT(y + CARDAN_WIDTH) = right;
        j = cardan_inboard(tree, j);
    }
}

/* One row of L over a panel: it loses multiples of those of its ancestors. */
CARDAN_INLINE void cardan_panel_outward(const cardan_tree *tree, int k, const real *rows, real *panel)
{
    const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
    const int level = speed[CARDAN_LEVEL];
    const real *const row = rows + speed[CARDAN_PLACE];
    real *const x = panel + k * CARDAN_PANEL;
    cardan_wide left = row[level] * CARDAN_READ(x), right = row[level] * CARDAN_READ(x + CARDAN_WIDTH);

    for (int l = level - 1, j = cardan_inboard(tree, k); l >= 0; --l) {
        const real *const y = panel + j * CARDAN_PANEL;
        left -= row[l] * CARDAN_READ(y);
        right -= row[l] * CARDAN_READ(y + CARDAN_WIDTH);
        j = cardan_inboard(tree, j);
    }
    CARDAN_AT(x) = left;
    CARDAN_AT(x + CARDAN_WIDTH) = right;
}

/* The same of four rows k ... k + 3 of a run. */
CARDAN_INLINE void cardan_panel_outward_four(const cardan_tree *tree, int k, const real *rows,
                                                 real *panel)
{
    const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
    const real *const row_a = rows + speed[CARDAN_PLACE];
    const real *const row_b = rows + speed[CARDAN_SPEED_ROW + CARDAN_PLACE];
    const real *const row_c = rows + speed[2 * CARDAN_SPEED_ROW + CARDAN_PLACE];
    const real *const row_d = rows + speed[3 * CARDAN_SPEED_ROW + CARDAN_PLACE];
    const int level = speed[CARDAN_LEVEL];
    real *const x = panel + k * CARDAN_PANEL;
    const cardan_wide right_a = CARDAN_READ(x + CARDAN_WIDTH);
    const cardan_wide right_b = CARDAN_READ(x + CARDAN_PANEL + CARDAN_WIDTH);
    const cardan_wide right_c = CARDAN_READ(x + 2 * CARDAN_PANEL + CARDAN_WIDTH);
    const cardan_wide right_d = CARDAN_READ(x + 3 * CARDAN_PANEL + CARDAN_WIDTH);
    cardan_wide a = row_a[level] * CARDAN_READ(x), a2 = row_a[level] * right_a;
    cardan_wide b = row_b[level + 1] * CARDAN_READ(x + CARDAN_PANEL);
    cardan_wide b2 = row_b[level + 1] * right_b;
    cardan_wide c = row_c[level + 2] * CARDAN_READ(x + 2 * CARDAN_PANEL);
    cardan_wide c2 = row_c[level + 2] * right_c;
    cardan_wide d = row_d[level + 3] * CARDAN_READ(x + 3 * CARDAN_PANEL);
    cardan_wide d2 = row_d[level + 3] * right_d;

    for (int l = level - 1, j = cardan_inboard(tree, k); l >= 0; --l) {
        const real *const y = panel + j * CARDAN_PANEL;
        const cardan_wide left = CARDAN_READ(y), right = CARDAN_READ(y + CARDAN_WIDTH);
        a -= row_a[l] * left;
        a2 -= row_a[l] * right;
        b -= row_b[l] * left;
        b2 -= row_b[l] * right;
        c -= row_c[l] * left;
        c2 -= row_c[l] * right;
        d -= row_d[l] * left;
        d2 -= row_d[l] * right;
        j = cardan_inboard(tree, j);
    }
    /* among themselves */
    b -= row_b[level] * a;
    b2 -= row_b[level] * a2;
    c -= row_c[level] * a;
    c2 -= row_c[level] * a2;
    c -= row_c[level + 1] * b;
    c2 -= row_c[level + 1] * b2;
    d -= row_d[level] * a;
    d2 -= row_d[level] * a2;
    d -= row_d[level + 1] * b;
    d2 -= row_d[level + 1] * b2;
    d -= row_d[level + 2] * c;
    d2 -= row_d[level + 2] * c2;
    CARDAN_AT(x) = a;
    CARDAN_AT(x + CARDAN_WIDTH) = a2;
    CARDAN_AT(x + CARDAN_PANEL) = b;
    CARDAN_AT(x + CARDAN_PANEL + CARDAN_WIDTH) = b2;
    CARDAN_AT(x + 2 * CARDAN_PANEL) = c;
    CARDAN_AT(x + 2 * CARDAN_PANEL + CARDAN_WIDTH) = c2;
    CARDAN_AT(x + 3 * CARDAN_PANEL) = d;
    CARDAN_AT(x + 3 * CARDAN_PANEL + CARDAN_WIDTH) = d2;
}

/*
 * A panel (speeds, CARDAN_PANEL) of right sides becomes that of the solutions, in its first `count`
 * rows. Rows behind them are 0 and are not looked at.
 */
CARDAN_APART void cardan_tree_panel(const cardan_tree *tree, int count, const real *rows, real *panel)
{
    int k = count - 1;

    while (k >= 0) {
        const int run = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_RUN];
        if (k - run + 1 >= CARDAN_ROWS) {
            cardan_panel_inward_four(tree, k, rows, panel);
            k -= CARDAN_ROWS;
        } else {
            cardan_panel_inward(tree, k, rows, panel);
            k -= 1;
        }
    }
    k = 0;
    while (k < count) {
        const int *const last = tree->speed + CARDAN_SPEED_ROW * (k + CARDAN_ROWS - 1);
        if (k + CARDAN_ROWS <= count
            && last[CARDAN_RUN] <= k) {
            cardan_panel_outward_four(tree, k, rows, panel);
            k += CARDAN_ROWS;
        } else {
            cardan_panel_outward(tree, k, rows, panel);
            k += 1;
        }
    }
}

#endif
