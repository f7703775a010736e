/*
 * tree_derivatives.h: derivatives of the forward or the inverse dynamics of a tree.
 *
 * Of forward dynamics M udot = drive comes first, body by body. A change of q or u at a joint acts on
 * what the joint carries as one acceleration and one change of angular velocity (tree_sides.h); the
 * accelerations that follow from it take a product of a row with six numbers per body and column,
 * where M as a matrix takes one per pair of bodies and column.
 */
#ifndef CARDAN_TREE_DERIVATIVES_H
#define CARDAN_TREE_DERIVATIVES_H

#include "tree_panels.h"
#include "tree_sides.h"

/* What derivatives of forward dynamics are asked for. */
typedef struct cardan_columns {
    int half;   /* columns along q, rounded up to a chunk: those along u begin there */
    int moving; /* whether columns of S change besides moving with their bodies */
    int kind;   /* of an output */
    int first;  /* column of its first one */
    int width;  /* number of its columns */
    int count;  /* of those in half a panel, from `at` of the output on */
    int at;
    real *out;  /* the output (speeds, width) */
} cardan_columns;

/* Right sides of half a panel: ones of M^-1, forces of elements, changes of the columns of S. */
CARDAN_APART void cardan_half_sides(const cardan_articulated *t, const cardan_columns *columns,
                                    int changes, const int *change, real *panel, int *low, int *high)
{
    const cardan_slopes *const s = &t->slopes;
    const int *const speed = s->tree.speed;
    const int first = columns->first + columns->at, end = first + columns->count;
    int n = 0, last = changes;

    if (columns->kind == CARDAN_OF_M) {
        for (int c = 0; c < columns->count; ++c) {
            const int row = speed[CARDAN_SPEED_ROW * (columns->at + c) + CARDAN_OF_SLOT];
            panel[CARDAN_PANEL * row + c] = CARDAN_REAL(1.0);
            if (row < *low) *low = row;
            if (row > *high) *high = row;
        }
        return;
    }
    /* changes stand by columns */
    while (n < last) {
        const int middle = (n + last) / 2;
        if (change[3 * middle + 1] < first)
            n = middle + 1;
        else
            last = middle;
    }
    /* forces of elements: rows that no column of the panel reaches widen what goes inward */
    for (; n < changes && change[3 * n + 1] < end; ++n) {
        const int row = change[3 * n];
        panel[CARDAN_PANEL * row + change[3 * n + 1] - first] += s->numbers[change[3 * n + 2]];
        if (row < *low) *low = row;
        if (row > *high) *high = row;
    }
    /* columns of S that change with q take another part of the force on their joint */
    if (columns->first || !columns->moving) return;
    for (int i = 0; i < s->tree.bodies; ++i) {
        const int *const body = s->tree.body + CARDAN_BODY_ROW * i;
        const int joint = body[CARDAN_FIRST], count = body[CARDAN_COUNT];
        if (body[CARDAN_MODES] < 0) continue;
        for (int k = 0; k < count; ++k) {
            const int column = speed[CARDAN_SPEED_ROW * (joint + k) + CARDAN_SLOT];
            if (column < first || column >= end) continue;
            for (int j = 0; j < count; ++j)
                panel[CARDAN_PANEL * (joint + j) + column - first] -=
                    cardan_six(s->numbers + body[CARDAN_MODES] + 6 * (j * count + k),
                               s->wrench + CARDAN_SIX * i);
        }
    }
}

/* What changes in the columns of half a panel cause, and where results go. */
CARDAN_APART void cardan_half_of(const cardan_articulated *t, const cardan_columns *columns,
                                 cardan_half *half)
{
    const int of_q = columns->first == 0;

    half->at = columns->at;
    half->count = columns->count;
    half->width = columns->width;
    half->out = columns->out;
    half->low = t->slopes.tree.speeds;
    half->high = -1;
    half->force = half->displaced = half->along = NULL;
    /* changes of q and u act at their speeds; ones of M^-1 and other right sides do not */
    if (columns->kind == CARDAN_OF_M || columns->first > columns->half || !columns->count) return;
    half->force = t->causes + (of_q ? CARDAN_FORCE_Q : CARDAN_FORCE_U);
    half->along = t->causes + (of_q ? CARDAN_ALONG_Q : CARDAN_ALONG_U);
    if (of_q) half->displaced = t->causes + CARDAN_DISPLACED;
    for (int c = 0; c < half->count; ++c) {
        const int k = t->slopes.tree.speed[CARDAN_SPEED_ROW * (half->at + c) + CARDAN_OF_SLOT];
        if (k < half->low) half->low = k;
        if (k > half->high) half->high = k;
    }
}

/* A panel of two halves: right sides, then accelerations, to their outputs. */
CARDAN_APART void cardan_panel_solve(const cardan_articulated *t, const cardan_columns *columns,
                                     int changes, const int *change)
{
    int low = t->slopes.tree.speeds, high = -1;
    cardan_half half[2];

    for (int h = 0; h < 2; ++h) {
        cardan_half_of(t, columns + h, half + h);
        if (!columns[h].count) continue;
        cardan_half_sides(t, columns + h, changes, change, t->panel + CARDAN_WIDTH * h, &low, &high);
        if (half[h].low < low) low = half[h].low;
        if (half[h].high > high) high = half[h].high;
    }
    cardan_panel_inward(t, low, high, half);
    cardan_panel_outward(t, half);
}

/*
 * Derivatives of the accelerations to out. Columns of the same slots of all outputs go together:
 * they pass over the same bodies inward.
 */
CARDAN_APART void cardan_forward_slopes(const cardan_articulated *t, int half, int outputs,
                                        const int *output, int changes, const int *change, real *out)
{
    const int speeds = t->slopes.tree.speeds;
    cardan_columns columns[2];
    int next = 1, filled = 0;

    columns[0].half = columns[1].half = half;
    columns[0].moving = 0;
    for (int i = 0; i < t->slopes.tree.bodies; ++i)
        columns[0].moving |= t->slopes.tree.body[CARDAN_BODY_ROW * i + CARDAN_MODES] >= 0;
    columns[1].moving = columns[0].moving;
    for (int at = 0; next; at += CARDAN_WIDTH) {
        real *place = out;
        next = 0;
        for (int n = 0; n < outputs; ++n) {
            const int width = output[3 * n + 1];
            cardan_columns *const part = columns + filled;
            if (at < width) {
                part->kind = output[3 * n];
                part->first = output[3 * n + 2];
                part->width = width;
                /* the last columns reach back over some before them, so that vectors are full */
                part->count = CARDAN_WIDTH < width ? CARDAN_WIDTH : width;
                part->at = at + part->count < width ? at : width - part->count;
                part->out = place;
                next = 1;
                filled = !filled;
                if (!filled) cardan_panel_solve(t, columns, changes, change);
            }
            place += speeds * width;
        }
    }
    if (filled) {
        columns[1] = columns[0];
        columns[1].count = 0;
        cardan_panel_solve(t, columns, changes, change);
    }
}

/*
 * Derivatives to out.
 *
 * room: of the rows of M. serial: as of a tree. branches: bodies with several children. forward: of
 * the accelerations under tau; else of the forces at in->udot. columns: right sides besides those
 * along q and u. outputs: rows of (kind, columns, first column). changes: rows of (speed, column,
 * place) that add to right sides, sorted by columns; rotors: rows of (speed, speed, place) that add
 * to M. The numbers of the bodies begin at work + start, scratch at work + scratch.
 */
CARDAN_APART int cardan_tree_derivatives(int bodies, int speeds, int depth, int room, int serial,
                                         int branches, int forward, int columns, int outputs,
                                         int changes, int rotors, int start, int scratch,
                                         const int *table, const cardan_in *in, real *out, real *work)
{
    const int half = cardan_chunks(speeds);
    real *place = work + scratch;
    cardan_slopes slopes;
    int status = CARDAN_OK;

    slopes.tree = cardan_tree_of(bodies, speeds, depth, serial, table);
    const int *const output = slopes.tree.speed + CARDAN_SPEED_ROW * speeds;
    const int *const change = output + 3 * outputs, *const rotor = change + 3 * changes;
    slopes.numbers = work + start;
    slopes.further = place, place += CARDAN_SIX * bodies;
    slopes.wrench = place, place += CARDAN_SIX * bodies;
    slopes.udot = place, place += speeds;
    slopes.zeta = place, place += CARDAN_SIX * speeds;
    if (forward) {
        cardan_articulated t;
        t.slopes = slopes;
        t.matrices = place, place += CARDAN_MATRIX * bodies;
        t.gains = place, place += CARDAN_GAINS * speeds;
        t.causes = place, place += CARDAN_CAUSE * speeds;
        t.inward = place, place += 6 * CARDAN_PANEL * branches;
        t.outward = place, place += 9 * CARDAN_PANEL * branches;
        t.panel = place;
        status = cardan_tree_articulate(&t, rotors, rotor, in->tau);
        cardan_tree_accelerate(&t);
        cardan_tree_causes(&t);
        cardan_clear(6 * CARDAN_PANEL * branches, t.inward);
        cardan_clear(CARDAN_PANEL * speeds, t.panel);
        cardan_forward_slopes(&t, half, outputs, output, changes, change, out);
    } else {
        cardan_sides s;
        s.slopes = slopes;
        s.half = half;
        s.sums = place, place += CARDAN_SIDE_STRIDE * bodies;
        s.path = place, place += CARDAN_PATHS * depth;
        s.row = place, place += 4 * depth;
        s.rows = place, place += room;
        s.panels = place;
        for (int k = 0; k < speeds; ++k)
            slopes.udot[k] = in->udot[slopes.tree.speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT]];
        cardan_side_derivatives(&s, columns, outputs, output, changes, change, rotors, rotor, out);
    }
    return status;
}

#endif
