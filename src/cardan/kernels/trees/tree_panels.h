/*
 * tree_panels.h: right sides of a tree become accelerations, a panel of columns at a time.
 *
 * A panel has two halves, each a vector of columns. Forces go inward from body to body in registers,
 * accelerations outward; at bodies with several children they wait in memory for the other ones.
 */
#ifndef CARDAN_TREE_PANELS_H
#define CARDAN_TREE_PANELS_H

#include "tree_articulated.h"

/* x in the column of a lane, 0 in all others, whatever x is */
#if CARDAN_WIDTH > 1
typedef cardan_word cardan_wide_mask
    __attribute__((vector_size(CARDAN_CHUNK * sizeof(double)), aligned(sizeof(double)), may_alias));
#define CARDAN_ONLY(x, mask) ((cardan_wide)((cardan_wide_mask)((x) - (cardan_wide){0.0}) & (mask)))
#define CARDAN_LANE(lane) (*(const cardan_wide_mask *)(cardan_lanes + CARDAN_CHUNK - 1 - (lane)))
static const cardan_word cardan_lanes[2 * CARDAN_CHUNK] = {
    [CARDAN_CHUNK - 1] = (cardan_word)-1,
};
#else
typedef int cardan_wide_mask;
#define CARDAN_ONLY(x, mask) (x)
#define CARDAN_LANE(lane) (lane)
#endif

/* written out, so that vectors stay in registers */
#define CARDAN_SIX_TIMES(step) step(0); step(1); step(2); step(3); step(4); step(5)
#define CARDAN_NINE_TIMES(step) CARDAN_SIX_TIMES(step); step(6); step(7); step(8)

/*
 * The columns of half a panel, `count` of those of `out` from `at` on. Changes at the speeds of these
 * slots act in them; causes are those of speed 0, NULL where nothing acts.
 */
typedef struct cardan_half {
    int at, count;
    int low, high; /* first and last of these speeds, low > high where nothing acts */
    const real *force;     /* the force that a change asks for (6) */
    const real *displaced; /* what joins it inboard of the joint (6) */
    const real *along;     /* zeta and eta (9) */
    real *out;             /* (speeds, width) by slots */
    int width;
} cardan_half;

/* Columns of a panel's row to a row of out. */
CARDAN_INLINE void cardan_half_out(const cardan_half *half, int slot, const real *x)
{
    real *const row = half->out + slot * half->width + half->at;

    if (half->count == CARDAN_WIDTH)
        CARDAN_AT(row) = CARDAN_READ(x);
    else
        for (int c = 0; c < half->count; ++c) row[c] = x[c];
}

/* x less the product of six numbers with a force, in two sums that do not wait for each other */
CARDAN_INLINE void cardan_wide_less(const real *row, const cardan_wide *y, cardan_wide *x)
{
    cardan_wide sum = *x - row[0] * y[0], more = row[3] * y[3];
    sum -= row[1] * y[1];
    more += row[4] * y[4];
    sum -= row[2] * y[2];
    more += row[5] * y[5];
    *x = sum - more;
}

/* y (6) += x times six numbers */
CARDAN_INLINE void cardan_wide_more(const real *row, const cardan_wide *x, cardan_wide *y)
{
    y[0] += row[0] * *x;
    y[1] += row[1] * *x;
    y[2] += row[2] * *x;
    y[3] += row[3] * *x;
    y[4] += row[4] * *x;
    y[5] += row[5] * *x;
}

/* x less the part of eta (3) that a speed takes */
CARDAN_INLINE void cardan_wide_turn(const real *row, const cardan_wide *eta, cardan_wide *x)
{
    *x -= row[0] * eta[0];
    *x -= row[1] * eta[1];
    *x -= row[2] * eta[2];
}

/* Right sides of a joint (speeds, CARDAN_PANEL) and the forces on its body (6 of each half), inward. */
CARDAN_INLINE void cardan_panel_joint_inward(int count, const real *gain, real *x, cardan_wide *p,
                                             cardan_wide *r)
{
    const int width = CARDAN_WIDTH;

    if (count == 1) {
        cardan_wide left = CARDAN_READ(x), right = CARDAN_READ(x + width);
        cardan_wide_less(gain, p, &left);
        cardan_wide_less(gain, r, &right);
        cardan_wide_more(gain + CARDAN_SHARE, &left, p);
        cardan_wide_more(gain + CARDAN_SHARE, &right, r);
        CARDAN_AT(x) = gain[CARDAN_PIVOT] * left;
        CARDAN_AT(x + width) = gain[CARDAN_PIVOT] * right;
        return;
    }
    /* L^T of the joint, then all its speeds under the same force */
    for (int i = 1; i < count; ++i)
        for (int j = 0; j < i; ++j) {
            const real factor = gain[CARDAN_GAINS * i + CARDAN_WITHIN + j];
            real *const y = x + CARDAN_PANEL * i;
            CARDAN_AT(y) -= factor * CARDAN_READ(x + CARDAN_PANEL * j);
            CARDAN_AT(y + width) -= factor * CARDAN_READ(x + CARDAN_PANEL * j + width);
        }
    for (int i = 0; i < count; ++i) {
        real *const y = x + CARDAN_PANEL * i;
        cardan_wide left = CARDAN_READ(y), right = CARDAN_READ(y + width);
        cardan_wide_less(gain + CARDAN_GAINS * i, p, &left);
        cardan_wide_less(gain + CARDAN_GAINS * i, r, &right);
        CARDAN_AT(y) = left;
        CARDAN_AT(y + width) = right;
    }
    for (int i = 0; i < count; ++i) {
        const real *const row = gain + CARDAN_GAINS * i;
        real *const y = x + CARDAN_PANEL * i;
        const cardan_wide left = CARDAN_READ(y), right = CARDAN_READ(y + width);
        cardan_wide_more(row + CARDAN_SHARE, &left, p);
        cardan_wide_more(row + CARDAN_SHARE, &right, r);
        CARDAN_AT(y) = row[CARDAN_PIVOT] * left;
        CARDAN_AT(y + width) = row[CARDAN_PIVOT] * right;
    }
}

/* Accelerations of a joint in place of what right sides left, from those of the parent (9 of each). */
CARDAN_INLINE void cardan_panel_share(int count, const real *gain, real *x, const cardan_wide *a,
                                      const cardan_wide *b)
{
    for (int i = 0; i < count; ++i) {
        const real *const row = gain + CARDAN_GAINS * i;
        real *const y = x + CARDAN_PANEL * i;
        cardan_wide left = CARDAN_READ(y), right = CARDAN_READ(y + CARDAN_WIDTH);
        cardan_wide_turn(row + CARDAN_SHARE_ETA, a + 6, &left);
        cardan_wide_turn(row + CARDAN_SHARE_ETA, b + 6, &right);
        cardan_wide_less(row + CARDAN_SHARE, a, &left);
        cardan_wide_less(row + CARDAN_SHARE, b, &right);
        CARDAN_AT(y) = left;
        CARDAN_AT(y + CARDAN_WIDTH) = right;
    }
}

/*
 * What right sides left becomes the accelerations of a joint, and those of the body (9 of each half)
 * change, outward. moves: whether the parent does, which the
 * ground does not.
 */
CARDAN_INLINE void cardan_panel_joint_outward(int count, int moves, const real *gain, real *x,
                                              cardan_wide *a, cardan_wide *b)
{
    const int width = CARDAN_WIDTH;

    if (count == 1) {
        cardan_wide left = CARDAN_READ(x), right = CARDAN_READ(x + width);
        cardan_wide_turn(gain + CARDAN_SHARE_ETA, a + 6, &left);
        cardan_wide_turn(gain + CARDAN_SHARE_ETA, b + 6, &right);
        cardan_wide_less(gain + CARDAN_SHARE, a, &left);
        cardan_wide_less(gain + CARDAN_SHARE, b, &right);
        cardan_wide_more(gain, &left, a);
        cardan_wide_more(gain, &right, b);
        CARDAN_AT(x) = left;
        CARDAN_AT(x + width) = right;
        return;
    }
    /* all speeds of the joint share the acceleration of the parent */
    if (moves) cardan_panel_share(count, gain, x, a, b);
    for (int i = 0; i < count; ++i) {
        const cardan_wide left = CARDAN_READ(x + CARDAN_PANEL * i);
        const cardan_wide right = CARDAN_READ(x + CARDAN_PANEL * i + width);
        cardan_wide_more(gain + CARDAN_GAINS * i, &left, a);
        cardan_wide_more(gain + CARDAN_GAINS * i, &right, b);
    }
    /* L of the joint */
    for (int j = count - 2; j >= 0; --j)
        for (int i = j + 1; i < count; ++i) {
            const real factor = gain[CARDAN_GAINS * i + CARDAN_WITHIN + j];
            real *const y = x + CARDAN_PANEL * j;
            CARDAN_AT(y) -= factor * CARDAN_READ(x + CARDAN_PANEL * i);
            CARDAN_AT(y + width) -= factor * CARDAN_READ(x + CARDAN_PANEL * i + width);
        }
}

/* rows between one that is written and one whose memory is fetched for that */
#define CARDAN_AHEAD 12

CARDAN_INLINE void cardan_half_ahead(const cardan_half *half, int slot)
{
    const real *const row = half->out + slot * half->width + half->at;

    CARDAN_PREPARE(row);
    if (CARDAN_WIDTH > 1) CARDAN_PREPARE(row + CARDAN_WIDTH - 1);
}

/* Rows of a panel, of speeds first ... end - 1, to the outputs of its halves by slots; they become 0. */
CARDAN_INLINE void cardan_panel_out(const cardan_tree *tree, int first, int end, real *panel,
                                    const cardan_half *half)
{
    for (int k = first; k < end; ++k) {
        const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
        real *const x = panel + CARDAN_PANEL * k;
        if (k + CARDAN_AHEAD < tree->speeds) {
            const int slot = speed[CARDAN_SPEED_ROW * CARDAN_AHEAD + CARDAN_SLOT];
            cardan_half_ahead(half, slot);
            cardan_half_ahead(half + 1, slot);
        }
        cardan_half_out(half, speed[CARDAN_SLOT], x);
        cardan_half_out(half + 1, speed[CARDAN_SLOT], x + CARDAN_WIDTH);
        cardan_clear(CARDAN_PANEL, x);
    }
}

/* Forces (6) that changes at the speeds of a body cause, to y (6). */
CARDAN_INLINE void cardan_half_forces(const cardan_half *half, const real *causes,
                                      const cardan_tree *tree, int first, int end, cardan_wide *y)
{
    if (!causes || first > half->high || end <= half->low) return;
    for (int k = first; k < end; ++k) {
        const int lane = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT] - half->at;
        if (lane < 0 || lane >= CARDAN_WIDTH) continue;
        const real *const x = causes + CARDAN_CAUSE * k;
        const cardan_wide_mask mask = CARDAN_LANE(lane);
#define CARDAN_JOIN(c) y[c] += CARDAN_ONLY(x[c], mask)
        CARDAN_SIX_TIMES(CARDAN_JOIN);
#undef CARDAN_JOIN
        (void)mask;
    }
}

/* zeta and eta (9) of changes at the speeds of a body, to y (9). */
CARDAN_INLINE void cardan_half_motion(const cardan_half *half, const cardan_tree *tree, int first,
                                      int end, cardan_wide *y)
{
    if (first > half->high || end <= half->low) return;
    for (int k = first; k < end; ++k) {
        const int lane = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_SLOT] - half->at;
        if (lane < 0 || lane >= CARDAN_WIDTH) continue;
        const real *const x = half->along + CARDAN_CAUSE * k;
        const cardan_wide_mask mask = CARDAN_LANE(lane);
#define CARDAN_JOIN(c) y[c] += CARDAN_ONLY(x[c], mask)
        CARDAN_NINE_TIMES(CARDAN_JOIN);
#undef CARDAN_JOIN
        (void)mask;
    }
}

/*
 * Right sides in the panel, of speeds low ... high, and forces of causes become what they leave at
 * every speed, over D. All other rows are 0.
 */
CARDAN_APART void cardan_panel_inward(const cardan_articulated *t, int low, int high,
                                      const cardan_half *half)
{
    const cardan_tree *const tree = &t->slopes.tree;
    const cardan_wide none = {0.0};
    cardan_wide p[6], r[6];

#define CARDAN_EMPTY(c) p[c] = r[c] = none
#define CARDAN_ARRIVE(c)                                                                            \
    p[c] += CARDAN_READ(there + CARDAN_PANEL * (c));                                               \
    r[c] += CARDAN_READ(there + CARDAN_PANEL * (c) + CARDAN_WIDTH)
#define CARDAN_LEAVE(c)                                                                            \
    CARDAN_AT(there + CARDAN_PANEL * (c)) += p[c];                                                 \
    CARDAN_AT(there + CARDAN_PANEL * (c) + CARDAN_WIDTH) += r[c]
    CARDAN_SIX_TIMES(CARDAN_EMPTY);
    for (int i = tree->bodies - 1; i >= 0; --i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const int first = body[CARDAN_FIRST], end = first + body[CARDAN_COUNT];
        const int parent = body[CARDAN_PARENT], branch = body[CARDAN_BRANCH];
        /* only bodies that move some of these speeds, or are moved by them */
        if (first > high || body[CARDAN_END] <= low) continue;
        if (branch >= 0) {
            real *const there = t->inward + 6 * CARDAN_PANEL * branch;
            CARDAN_SIX_TIMES(CARDAN_ARRIVE);
            cardan_clear(6 * CARDAN_PANEL, there);
        }
        cardan_half_forces(half, half->force, tree, first, end, p);
        cardan_half_forces(half + 1, half[1].force, tree, first, end, r);
        cardan_panel_joint_inward(end - first, t->gains + CARDAN_GAINS * first,
                                  t->panel + CARDAN_PANEL * first, p, r);
        cardan_half_forces(half, half->displaced, tree, first, end, p);
        cardan_half_forces(half + 1, half[1].displaced, tree, first, end, r);
        /* the parent that comes next has the force in registers, any other one in memory */
        if (parent >= 0 && parent != i - 1) {
            real *const there = t->inward
                + 6 * CARDAN_PANEL * tree->body[CARDAN_BODY_ROW * parent + CARDAN_BRANCH];
            CARDAN_SIX_TIMES(CARDAN_LEAVE);
        }
        if (parent < 0 || parent != i - 1) {
            CARDAN_SIX_TIMES(CARDAN_EMPTY);
        }
    }
#undef CARDAN_EMPTY
#undef CARDAN_ARRIVE
#undef CARDAN_LEAVE
}

/* What right sides left at the speeds, over D, becomes their accelerations; the panel becomes 0. */
CARDAN_APART void cardan_panel_outward(const cardan_articulated *t, const cardan_half *half)
{
    const cardan_tree *const tree = &t->slopes.tree;
    const cardan_wide none = {0.0};
    cardan_wide a[9], b[9];

#define CARDAN_EMPTY(c) a[c] = b[c] = none
#define CARDAN_ARRIVE(c)                                                                            \
    a[c] = CARDAN_READ(there + CARDAN_PANEL * (c));                                                \
    b[c] = CARDAN_READ(there + CARDAN_PANEL * (c) + CARDAN_WIDTH)
#define CARDAN_LEAVE(c)                                                                            \
    CARDAN_AT(there + CARDAN_PANEL * (c)) = a[c];                                                  \
    CARDAN_AT(there + CARDAN_PANEL * (c) + CARDAN_WIDTH) = b[c]
    CARDAN_NINE_TIMES(CARDAN_EMPTY);
    for (int i = 0; i < tree->bodies; ++i) {
        const int *const body = tree->body + CARDAN_BODY_ROW * i;
        const int first = body[CARDAN_FIRST], end = first + body[CARDAN_COUNT];
        const int parent = body[CARDAN_PARENT], branch = body[CARDAN_BRANCH];
        /* the motion of a parent that came just before is in registers */
        if (parent < 0) {
            CARDAN_NINE_TIMES(CARDAN_EMPTY);
        } else if (parent != i - 1) {
            const real *const there = t->outward
                + 9 * CARDAN_PANEL * tree->body[CARDAN_BODY_ROW * parent + CARDAN_BRANCH];
            CARDAN_NINE_TIMES(CARDAN_ARRIVE);
        }
        cardan_panel_joint_outward(end - first, parent >= 0, t->gains + CARDAN_GAINS * first,
                                   t->panel + CARDAN_PANEL * first, a, b);
        cardan_panel_out(tree, first, end, t->panel, half);
        /* what changes at these speeds cause acts on all that they carry */
        cardan_half_motion(half, tree, first, end, a);
        cardan_half_motion(half + 1, tree, first, end, b);
        if (branch >= 0) {
            real *const there = t->outward + 9 * CARDAN_PANEL * branch;
            CARDAN_NINE_TIMES(CARDAN_LEAVE);
        }
    }
#undef CARDAN_EMPTY
#undef CARDAN_ARRIVE
#undef CARDAN_LEAVE
}

#endif
