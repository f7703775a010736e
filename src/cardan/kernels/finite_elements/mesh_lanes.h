/* Rows of numbers of elements, of which several go side by side: in memory the numbers of a place
 * stand one behind the other, in the blocks of functions those of all elements do (lanes).
 *
 * Part of cardan. Caller owns all memory.
 *
 * Rows go as squares of 4 by 8 where there are 8 lanes; what is left, and other numbers of lanes,
 * go number by number.
 */
#ifndef CARDAN_MESH_LANES_H
#define CARDAN_MESH_LANES_H

#include "cardan.h"
#include <stddef.h>

/* lanes at most; numbers of a row and of a vector of a square */
enum { CARDAN_ELEMENT_LANES = 8, CARDAN_FOUR = 4 };

#if defined __clang__ || __GNUC__ >= 12
#define CARDAN_SQUARES 1
typedef real cardan_two __attribute__((vector_size(16), aligned(8), may_alias));
typedef real cardan_four __attribute__((vector_size(32), aligned(8), may_alias));
typedef real cardan_eight __attribute__((vector_size(64), aligned(8), may_alias));

/* a vector that begins at a number */
#define CARDAN_AT(type, at) (*(type *)(void *)(at))
#define CARDAN_OF(type, at) (*(const type *)(const void *)(at))

#define CARDAN_EXCHANGE(a, b, low, high)                                                           \
    do {                                                                                           \
        const cardan_eight upper = __builtin_shufflevector(a, b, low);                             \
        b = __builtin_shufflevector(a, b, high);                                                   \
        a = upper;                                                                                 \
    } while (0)
#define CARDAN_LOW_1 0, 8, 2, 10, 4, 12, 6, 14
#define CARDAN_HIGH_1 1, 9, 3, 11, 5, 13, 7, 15
#define CARDAN_LOW_2 0, 1, 8, 9, 4, 5, 12, 13
#define CARDAN_HIGH_2 2, 3, 10, 11, 6, 7, 14, 15

/* transpose both halves of four vectors: (row k, row k + 4) become number k of all rows */
static inline void cardan_turn_square(cardan_eight *v)
{
    CARDAN_EXCHANGE(v[0], v[1], CARDAN_LOW_1, CARDAN_HIGH_1);
    CARDAN_EXCHANGE(v[2], v[3], CARDAN_LOW_1, CARDAN_HIGH_1);
    CARDAN_EXCHANGE(v[0], v[2], CARDAN_LOW_2, CARDAN_HIGH_2);
    CARDAN_EXCHANGE(v[1], v[3], CARDAN_LOW_2, CARDAN_HIGH_2);
}

static inline void cardan_fetch_square(const real *const *from, ptrdiff_t at, real *to)
{
    cardan_eight v[CARDAN_FOUR];

    for (int k = 0; k < CARDAN_FOUR; k++) {
        const cardan_four low = CARDAN_OF(cardan_four, from[k] + at);
        const cardan_four high = CARDAN_OF(cardan_four, from[k + CARDAN_FOUR] + at);
        v[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    }
    cardan_turn_square(v);
    for (int k = 0; k < CARDAN_FOUR; k++)
        CARDAN_AT(cardan_eight, to + k * CARDAN_ELEMENT_LANES) = v[k];
}

/* number k of up to four, 0 beyond; then those of row k */
static inline void cardan_open_square(const real *from, ptrdiff_t n, cardan_eight *v)
{
    for (int k = 0; k < CARDAN_FOUR; k++)
        v[k] = k < n ? CARDAN_OF(cardan_eight, from + k * CARDAN_ELEMENT_LANES) : (cardan_eight){0};
    cardan_turn_square(v);
}

/* Add four numbers of each row. */
static inline void cardan_add_fours(const real *from, real *const *to, ptrdiff_t at)
{
    cardan_eight v[CARDAN_FOUR];

    cardan_open_square(from, CARDAN_FOUR, v);
    for (int k = 0; k < CARDAN_FOUR; k++) {
        CARDAN_AT(cardan_four, to[k] + at) += __builtin_shufflevector(v[k], v[k], 0, 1, 2, 3);
        CARDAN_AT(cardan_four, to[k + CARDAN_FOUR] + at) +=
            __builtin_shufflevector(v[k], v[k], 4, 5, 6, 7);
    }
}

/* The same of two: what was just stored is not read across its end. */
static inline void cardan_add_twos(const real *from, real *const *to, ptrdiff_t at)
{
    cardan_eight v[CARDAN_FOUR];

    cardan_open_square(from, 2, v);
    for (int k = 0; k < CARDAN_FOUR; k++) {
        CARDAN_AT(cardan_two, to[k] + at) += __builtin_shufflevector(v[k], v[k], 0, 1);
        CARDAN_AT(cardan_two, to[k + CARDAN_FOUR] + at) +=
            __builtin_shufflevector(v[k], v[k], 4, 5);
    }
}

/* Set four numbers of each row. */
static inline void cardan_set_fours(const real *from, real *const *to, ptrdiff_t at)
{
    cardan_eight v[CARDAN_FOUR];

    cardan_open_square(from, CARDAN_FOUR, v);
    for (int k = 0; k < CARDAN_FOUR; k++) {
        CARDAN_AT(cardan_four, to[k] + at) = __builtin_shufflevector(v[k], v[k], 0, 1, 2, 3);
        CARDAN_AT(cardan_four, to[k + CARDAN_FOUR] + at) =
            __builtin_shufflevector(v[k], v[k], 4, 5, 6, 7);
    }
}
#else
#define CARDAN_SQUARES 0
#endif

/* n numbers of the rows `from` (lanes) into `to` (n, lanes). Returns where the next go. */
static inline real *cardan_fetch(const real *const *from, ptrdiff_t n, real *to, ptrdiff_t lanes)
{
#if CARDAN_SQUARES
    if (lanes == CARDAN_ELEMENT_LANES && n >= CARDAN_FOUR) {
        for (ptrdiff_t i = 0; i < n; i += CARDAN_FOUR) {
            const ptrdiff_t at = i + CARDAN_FOUR > n ? n - CARDAN_FOUR : i;
            cardan_fetch_square(from, at, to + at * CARDAN_ELEMENT_LANES);
        }
        return to + n * lanes;
    }
#endif
    for (ptrdiff_t lane = 0; lane < lanes; lane++)
        for (ptrdiff_t i = 0; i < n; i++)
            to[i * lanes + lane] = from[lane][i];
    return to + n * lanes;
}

/* Add `from` (n, lanes) to the first `filled` of the rows `to`. */
static inline void cardan_spill(const real *from, ptrdiff_t n, ptrdiff_t lanes, real *const *to,
                                ptrdiff_t filled)
{
    ptrdiff_t i = 0;

#if CARDAN_SQUARES
    if (filled == CARDAN_ELEMENT_LANES) {
        for (; i + CARDAN_FOUR <= n; i += CARDAN_FOUR)
            cardan_add_fours(from + i * lanes, to, i);
        for (; i + 2 <= n; i += 2)
            cardan_add_twos(from + i * lanes, to, i);
    }
#endif
    for (; i < n; i++)
        for (ptrdiff_t lane = 0; lane < filled; lane++)
            to[lane][i] += from[i * lanes + lane];
}

/* Set rows instead. */
static inline void cardan_write(const real *from, ptrdiff_t n, ptrdiff_t lanes, real *const *to,
                                ptrdiff_t filled)
{
#if CARDAN_SQUARES
    if (filled == CARDAN_ELEMENT_LANES && n >= CARDAN_FOUR) {
        for (ptrdiff_t i = 0; i < n; i += CARDAN_FOUR) {
            const ptrdiff_t at = i + CARDAN_FOUR > n ? n - CARDAN_FOUR : i;
            cardan_set_fours(from + at * lanes, to, at);
        }
        return;
    }
#endif
    for (ptrdiff_t lane = 0; lane < filled; lane++)
        for (ptrdiff_t i = 0; i < n; i++)
            to[lane][i] = from[i * lanes + lane];
}

/* to = kept to + share from, n numbers */
static inline void cardan_mix(ptrdiff_t n, real share, const real *from, real kept, real *to)
{
    ptrdiff_t i = 0;

#if CARDAN_SQUARES
    for (; i + CARDAN_ELEMENT_LANES <= n; i += CARDAN_ELEMENT_LANES) {
        const cardan_eight a = CARDAN_OF(cardan_eight, from + i);
        const cardan_eight b = CARDAN_OF(cardan_eight, to + i);
        CARDAN_AT(cardan_eight, to + i) = kept * b + share * a;
    }
#endif
    for (; i < n; i++)
        to[i] = kept * to[i] + share * from[i];
}

/* Three numbers x become Tᵀ x, lane by lane; T (9, lanes). */
static inline void cardan_turn_three(const real *T, ptrdiff_t lanes, real *x)
{
#if CARDAN_SQUARES
    if (lanes == CARDAN_ELEMENT_LANES) {
        const cardan_eight *t = (const cardan_eight *)(const void *)T;
        cardan_eight *v = (cardan_eight *)(void *)x;
        const cardan_eight a = v[0], b = v[1], c = v[2];
        for (int j = 0; j < 3; j++)
            v[j] = a * t[j] + b * t[3 + j] + c * t[6 + j];
        return;
    }
#endif
    for (ptrdiff_t lane = 0; lane < lanes; lane++, T++, x++) {
        const real a = x[0], b = x[lanes], c = x[2 * lanes];
        for (ptrdiff_t j = 0; j < 3; j++)
            x[j * lanes] = a * T[j * lanes] + b * T[(3 + j) * lanes] + c * T[(6 + j) * lanes];
    }
}

#endif
