/*
 * tree.h: a tree of bodies as a table, and sums over the ancestors of a body as vectors.
 *
 * Generated files include it where states may stand side by side: `real` is one number or several.
 *
 * The axes are those of the ground and the origin is that of the first body that rotates, so that
 * what bodies hand to their parents adds up without a change of axes or origin, and no result
 * depends on where the tree stands. Bodies stand depth first, each behind its parent; so do the
 * speeds of their joints. The level of a speed is the number of speeds between it and the ground:
 * quantities of all ancestors of a body lie in an array by levels, a path, which a walk over the
 * bodies keeps up to date.
 *
 * A path and a row of M begin at multiples of CARDAN_CHUNK. What lies between their ends and the
 * next multiple is computed along with them and read by nobody.
 */
#ifndef CARDAN_TREE_H
#define CARDAN_TREE_H

#include "cardan.h"
#include <string.h>

/* single states take several entries of a path at once, lanes several states */
#define CARDAN_CHUNK 8
#if CARDAN_LANES > 1 || !defined __GNUC__
typedef real cardan_wide;
#define CARDAN_WIDTH 1
#else
typedef double cardan_wide
    __attribute__((vector_size(CARDAN_CHUNK * sizeof(double)), aligned(sizeof(double)), may_alias));
#define CARDAN_WIDTH CARDAN_CHUNK
#endif
#define CARDAN_AT(x) (*(cardan_wide *)(x))
#define CARDAN_READ(x) (*(const cardan_wide *)(x))

/* columns of a table: of a body, of a speed */
enum { CARDAN_PARENT, CARDAN_FIRST, CARDAN_COUNT, CARDAN_NUMBERS, CARDAN_MODES, CARDAN_END,
       CARDAN_BRANCH, CARDAN_BODY_ROW };
enum { CARDAN_SLOT, CARDAN_LEVEL, CARDAN_RUN, CARDAN_BEFORE, CARDAN_PLACE, CARDAN_JOINT,
       CARDAN_OF_SLOT, CARDAN_SPEED_ROW };

typedef struct cardan_tree {
    int bodies, speeds, depth; /* depth: levels, rounded up to a chunk */
    int serial;                /* every speed has its own number as slot, and is inboard of the next */
    const int *body;  /* parent, first speed, number of speeds, its numbers, its modes, the speed
                         behind those that it carries, its number among bodies with several
                         children or -1 */
    const int *speed; /* slot, level, first speed of its run, speed before it, row of M, first speed
                         of its joint; the speed whose slot is the number of the row */
} cardan_tree;

CARDAN_INLINE cardan_tree cardan_tree_of(int bodies, int speeds, int depth, int serial,
                                         const int *table)
{
    cardan_tree tree;

    tree.bodies = bodies;
    tree.speeds = speeds;
    tree.depth = depth;
    tree.serial = serial;
    tree.body = table;
    tree.speed = table + CARDAN_BODY_ROW * bodies;
    return tree;
}

/* the speed one level nearer to the ground: speeds of a run follow each other */
CARDAN_INLINE int cardan_inboard(const cardan_tree *tree, int k)
{
    const int *const row = tree->speed + CARDAN_SPEED_ROW * k;
    return k == row[CARDAN_RUN] ? row[CARDAN_BEFORE] : k - 1;
}

/* memory that is about to be written */
#ifdef __GNUC__
#define CARDAN_PREPARE(x) __builtin_prefetch((x), 1)
#else
#define CARDAN_PREPARE(x) ((void)(x))
#endif

/* a number rounded up to full chunks */
CARDAN_INLINE int cardan_chunks(int n) { return (n + CARDAN_CHUNK - 1) / CARDAN_CHUNK * CARDAN_CHUNK; }

/* n zeros */
CARDAN_INLINE void cardan_clear(int n, real *x)
{
    memset(x, 0, (size_t)n * sizeof(real));
}

/*
 * Numbers of a body with all bodies outboard of it: mass, first moment (3), inertia about the origin
 * (xx, xy, xz, yy, yz, zz), then whatever else adds up.
 *
 * numbers: of every body at its place; sums: (bodies, stride), stride a multiple of a chunk, of which
 * what lies behind `count` is read by nobody.
 */
CARDAN_APART void cardan_tree_sums(const cardan_tree *tree, int count, int stride,
                                   const real *numbers, real *sums)
{
    for (int i = 0; i < tree->bodies; ++i) {
        const real *const body = numbers + tree->body[CARDAN_BODY_ROW * i + CARDAN_NUMBERS];
        for (int k = 0; k < count; k += CARDAN_WIDTH)
            CARDAN_AT(sums + i * stride + k) = CARDAN_READ(body + k);
    }
    /* inward: children stand behind their parents */
    for (int i = tree->bodies - 1; i >= 0; --i) {
        const int parent = tree->body[CARDAN_BODY_ROW * i + CARDAN_PARENT];
        if (parent < 0) continue;
        for (int k = 0; k < count; k += CARDAN_WIDTH)
            CARDAN_AT(sums + parent * stride + k) += CARDAN_READ(sums + i * stride + k);
    }
}

/* moment and force (6) that accelerate a composite body by s (6): also its momentum by a twist */
CARDAN_INLINE void cardan_momentum(const real *body, const real *s, real *y)
{
    const real m = body[0], x = body[1], yy = body[2], z = body[3];

    y[0] = body[4] * s[0] + body[5] * s[1] + body[6] * s[2] + yy * s[5] - z * s[4];
    y[1] = body[5] * s[0] + body[7] * s[1] + body[8] * s[2] + z * s[3] - x * s[5];
    y[2] = body[6] * s[0] + body[8] * s[1] + body[9] * s[2] + x * s[4] - yy * s[3];
    y[3] = m * s[3] + s[1] * z - s[2] * yy;
    y[4] = m * s[4] + s[2] * x - s[0] * z;
    y[5] = m * s[5] + s[0] * yy - s[1] * x;
}

/* row[l] = x (6) times the column of six rows of a path at level l < count */
CARDAN_APART void cardan_path_six(int count, int depth, const real *x, const real *path, real *row)
{
    const real a = x[0], b = x[1], c = x[2], d = x[3], e = x[4], f = x[5];

    for (int l = 0; l < count; l += CARDAN_WIDTH) {
        const real *const at = path + l;
        cardan_wide sum = a * CARDAN_READ(at);
        sum += b * CARDAN_READ(at + depth);
        sum += c * CARDAN_READ(at + 2 * depth);
        sum += d * CARDAN_READ(at + 3 * depth);
        sum += e * CARDAN_READ(at + 4 * depth);
        sum += f * CARDAN_READ(at + 5 * depth);
        CARDAN_AT(row + l) = sum;
    }
}

/*
 * M (speeds, speeds) by slots from its rows, to out.
 *
 * Of serial speeds whole rows are written, eight at a time: what is mirrored goes to places that
 * follow each other.
 */
CARDAN_APART void cardan_tree_square(const cardan_tree *tree, const real *rows, real *out)
{
    const int n = tree->speeds;

    if (!tree->serial) {
        cardan_clear(n * n, out);
        for (int k = 0; k < n; ++k) {
            const int *const speed = tree->speed + CARDAN_SPEED_ROW * k;
            const int slot = speed[CARDAN_SLOT];
            for (int l = speed[CARDAN_LEVEL], j = k; l >= 0; --l, j = cardan_inboard(tree, j)) {
                const int at = tree->speed[CARDAN_SPEED_ROW * j + CARDAN_SLOT];
                out[slot * n + at] = rows[speed[CARDAN_PLACE] + l];
                out[at * n + slot] = rows[speed[CARDAN_PLACE] + l];
            }
        }
        return;
    }
    for (int first = 0; first < n; first += CARDAN_CHUNK) {
        const int last = first + CARDAN_CHUNK < n ? first + CARDAN_CHUNK : n;
        for (int k = first; k < last; ++k) {
            const real *const row = rows + tree->speed[CARDAN_SPEED_ROW * k + CARDAN_PLACE];
            const int next = k + CARDAN_CHUNK;
            for (int j = 0; CARDAN_WIDTH > 1 && next < n && j < n; j += CARDAN_WIDTH)
                CARDAN_PREPARE(out + next * n + j);
            memcpy(out + k * n, row, (size_t)(k + 1) * sizeof(real));
            for (int j = first; j < k; ++j) out[j * n + k] = row[j];
        }
        for (int k = last; k < n; ++k) {
            const real *const row = rows + tree->speed[CARDAN_SPEED_ROW * k + CARDAN_PLACE];
            for (int j = first; j < last; ++j) out[j * n + k] = row[j];
        }
    }
}

/* columns of motion (6) of the speeds of a body go to their levels of the path */
CARDAN_INLINE void cardan_path_enter(const cardan_tree *tree, int k, int count, const real *column,
                                     real *path)
{
    const int level = tree->speed[CARDAN_SPEED_ROW * k + CARDAN_LEVEL];
    for (int j = 0; j < count; ++j) path[j * tree->depth + level] = column[j];
}

#endif
