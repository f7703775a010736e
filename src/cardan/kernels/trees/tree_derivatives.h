/*
 * tree_derivatives.h: derivatives of the inverse and the forward dynamics of a tree.
 *
 * A change of q or u at a joint moves what is outboard of it as one rigid body; besides, it changes
 * the angular velocity there by eta and the acceleration by a field zeta, linear in place. The bodies
 * outboard of a joint answer with the force I zeta + B eta, where I and B are sums over them: their
 * inertia and the flow of their momentum. So the entry of a speed and an ancestor is one product of a
 * row with a path, for what the ancestor causes at the speed and for what the speed causes there.
 *
 * Of forward dynamics M udot = drive comes first; changes of the accelerations follow with the same
 * factors: M dudot = change of the forces - change of the inverse dynamics at udot.
 *
 * Source: S. Singh, R. Russell, P. Wensing, Efficient analytical derivatives of rigid-body dynamics
 * using spatial vector algebra, IEEE Robotics and Automation Letters 7 (2022).
 */
#ifndef CARDAN_TREE_DERIVATIVES_H
#define CARDAN_TREE_DERIVATIVES_H

#include "tree_slopes.h"

/* kinds of outputs */
enum { CARDAN_COLUMNS, CARDAN_OF_M };

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
CARDAN_INLINE void cardan_slope_block(const cardan_slopes *s, const int *body, int k,
                                      const real *along_q, const real *along_u, const real *wrench)
{
    const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
    const int slot = s->tree.speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT];

    for (int j = 0; j < count; ++j) {
        const real *const column = cardan_slope_speed(s, body, first + j) + CARDAN_S;
        real of_q = cardan_six(column, along_q);
        if (body[CARDAN_MODES] >= 0) {
            const real *const change =
                s->numbers + body[CARDAN_MODES] + 6 * (j * count + k - first);
            of_q -= cardan_six(change, wrench);
        }
        *cardan_entry(s, first + j, slot) = of_q;
        *cardan_entry(s, first + j, s->half + slot) = cardan_six(column, along_u);
    }
}

/* Entries of speed k at its ancestors and of these at it, run by run; `row` holds both by levels. */
CARDAN_INLINE void cardan_slope_scatter(const cardan_slopes *s, int k, int inboard, int level)
{
    const cardan_tree *const tree = &s->tree;
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

/* Right sides: changes of the inverse dynamics along q and u, negated. */
CARDAN_APART void cardan_slope_sides(const cardan_slopes *s)
{
    const cardan_tree *const tree = &s->tree;
    const int depth = tree->depth, serial = tree->serial;
    const int further = serial ? tree->speeds * CARDAN_PANEL : CARDAN_PANEL;
    const int offset = serial ? s->half % CARDAN_PANEL : 0;

    cardan_clear(CARDAN_PATHS * depth, s->path);
    for (int i = 0; i < tree->bodies; ++i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const real *const sums = s->sums + CARDAN_SLOPE_STRIDE * i;
        const real *const wrench = sums + CARDAN_WRENCH;
        const int first = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
        const int level = count ? tree->speed[CARDAN_SPEED_ROW * first + CARDAN_LEVEL] : 0;
        const int inboard = count ? cardan_inboard(tree, first) : -1;
        for (int k = first; k < first + count; ++k) {
            const real *const numbers = cardan_slope_speed(s, body, k);
            const real *const column = numbers + CARDAN_S, *const zeta = s->zeta + 6 * k;
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
            cardan_slope_block(s, body, k, along_q, along_u, wrench);

            /* inboard of the joint, forces are displaced too */
            cardan_cross_more(column, wrench, there);
            cardan_cross_more(column + 3, wrench + 3, there);
            cardan_cross_more(column, wrench + 3, there + 3);
            cardan_negative(there, along_q);
            cardan_path_six(level, depth, along_q, s->path + CARDAN_S * depth, s->row);
            cardan_path_six(level, depth, along_u, s->path + CARDAN_S * depth, s->row + depth);
            cardan_slope_scatter(s, k, inboard, level);
        }
        for (int k = first; k < first + count; ++k) {
            const real *const numbers = cardan_slope_speed(s, body, k);
            cardan_path_enter(tree, k, CARDAN_ZETA_Q, numbers, s->path);
            cardan_path_enter(tree, k, 6, s->zeta + 6 * k, s->path + CARDAN_ZETA_Q * depth);
        }
    }
}

/* M^-1 (speeds, speeds) to out: of a panel only what lies on and above the diagonal. */
CARDAN_APART void cardan_slope_inverse(const cardan_slopes *s, real *panel, real *out)
{
    const cardan_tree *const tree = &s->tree;
    const int n = tree->speeds;

    for (int first = 0; first < n; first += CARDAN_PANEL) {
        const int last = first + CARDAN_PANEL < n ? first + CARDAN_PANEL : n;
        cardan_clear(n * CARDAN_PANEL, panel);
        for (int k = first; k < last; ++k) panel[k * CARDAN_PANEL + k - first] = CARDAN_REAL(1.0);
        cardan_tree_panel(tree, last, s->rows, panel);
        for (int k = first; k < last; ++k) {
            const int slot = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT];
            for (int j = 0; j <= k; ++j) {
                const int at = tree->speed[CARDAN_SPEED_ROW * j + CARDAN_SLOT];
                const real entry = panel[j * CARDAN_PANEL + k - first];
                out[slot * n + at] = entry;
                out[at * n + slot] = entry;
            }
        }
    }
}

/* Columns of the right sides, or of the solutions in their place, to rows of out by slots. */
CARDAN_INLINE void cardan_slope_columns(const cardan_slopes *s, int width, int first, real *out)
{
    for (int k = 0; k < s->tree.speeds; ++k) {
        real *const row = out + s->tree.speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT] * width;
        for (int c = 0, count; c < width; c += count) {
            const int inside = CARDAN_PANEL - (first + c) % CARDAN_PANEL;
            count = inside < width - c ? inside : width - c;
            memcpy(row + c, cardan_entry(s, k, first + c), (size_t)count * sizeof(real));
        }
    }
}

/*
 * Derivatives to out.
 *
 * room: of the rows of M. serial: as of a tree. forward: of the accelerations under tau; else of the
 * forces at in->udot. columns: right sides besides those along q and u. outputs: rows of (kind,
 * columns, first column). changes: rows of (speed, column, place) that add to right sides; rotors:
 * rows of (speed, speed, place) that add to M. The numbers of the bodies begin at work + start,
 * scratch at work + scratch.
 */
CARDAN_APART int cardan_tree_derivatives(int bodies, int speeds, int depth, int room, int serial,
                                         int forward, int columns, int outputs, int changes,
                                         int rotors, int start, int scratch, const int *table,
                                         const cardan_in *in, real *out, real *work)
{
    const int half = cardan_chunks(speeds), count = 2 * half + columns;
    const int panels = (count + CARDAN_PANEL - 1) / CARDAN_PANEL, panel = speeds * CARDAN_PANEL;
    cardan_slopes s;
    int status = CARDAN_OK;

    s.tree = cardan_tree_of(bodies, speeds, depth, serial, table);
    const int *const output = s.tree.speed + CARDAN_SPEED_ROW * speeds;
    const int *const change = output + 3 * outputs, *const rotor = change + 3 * changes;
    s.half = half;
    s.numbers = work + start;
    s.sums = work + scratch;
    s.path = s.sums + CARDAN_SLOPE_STRIDE * bodies;
    s.row = s.path + CARDAN_PATHS * depth;
    s.rows = s.row + 4 * depth;
    s.further = s.rows + room;
    s.udot = s.further + 12 * bodies;
    s.zeta = s.udot + speeds;
    s.panels = s.zeta + 6 * speeds;

    cardan_tree_sums(&s.tree, CARDAN_SLOPE_BODY, CARDAN_SLOPE_STRIDE, s.numbers, s.sums);
    cardan_slope_rows(&s, rotors, rotor, forward ? in->tau : NULL);
    if (forward) {
        status = cardan_tree_factor(&s.tree, s.rows);
        cardan_tree_solve(&s.tree, s.rows, s.udot);
    } else {
        for (int k = 0; k < speeds; ++k)
            s.udot[k] = in->udot[s.tree.speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT]];
    }
    cardan_slope_accelerate(&s);
    cardan_clear(panels * panel, s.panels);
    cardan_slope_sides(&s);
    for (int n = 0; n < changes; ++n)
        *cardan_entry(&s, change[3 * n], change[3 * n + 1]) += s.numbers[change[3 * n + 2]];
    for (int p = 0; p < panels; ++p) {
        real *const side = s.panels + p * panel;
        if (forward)
            cardan_tree_panel(&s.tree, speeds, s.rows, side);
        else
            for (int m = 0; m < panel; ++m) side[m] = -side[m];
    }

    for (int n = 0; n < outputs; ++n) {
        const int width = output[3 * n + 1], first = output[3 * n + 2];
        if (output[3 * n] != CARDAN_OF_M)
            cardan_slope_columns(&s, width, first, out);
        else if (forward)
            cardan_slope_inverse(&s, s.panels + panels * panel, out);
        else
            cardan_tree_square(&s.tree, s.rows, out);
        out += speeds * width;
    }
    return status;
}

#endif
