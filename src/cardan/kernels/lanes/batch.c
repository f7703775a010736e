/* Apply the lane build of a generated function to many states.
 *
 * Part of cardan, built like the function it calls: with -DCARDAN_LANES and, where every state has
 * parameters of its own, -DCARDAN_LANE_PARAMETERS. Caller owns all memory.
 */
#include "batch.h"

#if CARDAN_LANES > 1

enum { BLOCKS = 17, L = CARDAN_LANES, GROUP = 4 };

/* room for so many vectors in whole squares */
static inline size_t round_up(size_t size) { return (size + L - 1) / L * L; }

/* loops over a square must be unrolled, or it lives in memory */
#ifdef __clang__
#define UNROLL
#else
#define UNROLL _Pragma("GCC unroll 16")
#endif

#if defined __clang__ || __GNUC__ >= 12
/* A square of numbers is transposed in exchanges of ever larger parts: numbers, pairs, fours, eights.
 * An exchange takes the lower (upper) halves of parts from both vectors. */
#if CARDAN_LANES == 16
#define LOW_1 0, 16, 2, 18, 4, 20, 6, 22, 8, 24, 10, 26, 12, 28, 14, 30
#define HIGH_1 1, 17, 3, 19, 5, 21, 7, 23, 9, 25, 11, 27, 13, 29, 15, 31
#define LOW_2 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29
#define HIGH_2 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31
#define LOW_4 0, 1, 2, 3, 16, 17, 18, 19, 8, 9, 10, 11, 24, 25, 26, 27
#define HIGH_4 4, 5, 6, 7, 20, 21, 22, 23, 12, 13, 14, 15, 28, 29, 30, 31
#define LOW_8 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23
#define HIGH_8 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31
#elif CARDAN_LANES == 8
#define LOW_1 0, 8, 2, 10, 4, 12, 6, 14
#define HIGH_1 1, 9, 3, 11, 5, 13, 7, 15
#define LOW_2 0, 1, 8, 9, 4, 5, 12, 13
#define HIGH_2 2, 3, 10, 11, 6, 7, 14, 15
#define LOW_4 0, 1, 2, 3, 8, 9, 10, 11
#define HIGH_4 4, 5, 6, 7, 12, 13, 14, 15
#elif CARDAN_LANES == 4
#define LOW_1 0, 4, 2, 6
#define HIGH_1 1, 5, 3, 7
#define LOW_2 0, 1, 4, 5
#define HIGH_2 2, 3, 6, 7
#else
#define LOW_1 0, 2
#define HIGH_1 1, 3
#endif

/* all exchanges of parts of so many numbers: of every vector with the one that far behind it */
#define EXCHANGE(v, part, low, high)                                                               \
    UNROLL for (size_t pair = 0; pair < L / 2; ++pair)                                             \
    {                                                                                              \
        const size_t i = pair / (part) * 2 * (part) + pair % (part);                               \
        const real upper = __builtin_shufflevector((v)[i], (v)[i + (part)], low);                  \
        (v)[i + (part)] = __builtin_shufflevector((v)[i], (v)[i + (part)], high);                  \
        (v)[i] = upper;                                                                            \
    }

/* transpose L vectors of L numbers */
static inline void turn(real *v)
{
    EXCHANGE(v, 1, LOW_1, HIGH_1)
#if CARDAN_LANES >= 4
    EXCHANGE(v, 2, LOW_2, HIGH_2)
#endif
#if CARDAN_LANES >= 8
    EXCHANGE(v, 4, LOW_4, HIGH_4)
#endif
#if CARDAN_LANES == 16
    EXCHANGE(v, 8, LOW_8, HIGH_8)
#endif
}

/* L rows of L numbers into L vectors */
static inline void columns(const double *rows, size_t stride, real *v)
{
    UNROLL for (size_t j = 0; j < L; ++j) memcpy(v + j, rows + j * stride, sizeof(real));
    turn(v);
}

/* row j of a square that was turned */
static inline void put_row(const real *v, size_t j, double *row)
{
    memcpy(row, v + j, sizeof(real));
}
#else
/* compilers without shuffles: number by number */
static inline void turn(real *v) { (void)v; }

static inline void put_row(const real *v, size_t j, double *row)
{
    for (size_t i = 0; i < L; ++i) row[i] = v[i][j];
}

static inline void columns(const double *rows, size_t stride, real *v)
{
    for (size_t i = 0; i < L; ++i)
        for (size_t j = 0; j < L; ++j) v[i][j] = rows[j * stride + i];
}
#endif

/* the sum of a square: infinite or NaN if one of its numbers is */
static inline real total(const real *v)
{
    real sums[L];
    UNROLL for (size_t i = 0; i < L / 2; ++i) sums[i] = v[i] + v[i + L / 2];
#if CARDAN_LANES == 16
    UNROLL for (size_t i = 0; i < 4; ++i) sums[i] += sums[i + 4];
#endif
#if CARDAN_LANES >= 8
    UNROLL for (size_t i = 0; i < 2; ++i) sums[i] += sums[i + 2];
#endif
#if CARDAN_LANES >= 4
    sums[0] += sums[1];
#endif
    return sums[0];
}

/* Numbers of L states or more: how far it is from one state to the next, and from one entry of a
 * state to the next. */
typedef struct numbers {
    size_t stride, spacing, size;
} numbers;

/* The entries of GROUP blocks of L states that stand side by side, entry by entry, into vectors: `room`
 * of them for a block. Several blocks at once, as lines of memory that two blocks share would be gone
 * before the second one, where entries are a power of two apart. What is read is added to `sum`. */
static void gather_group(const double *from, const numbers *a, real *to, size_t room, real *sum)
{
    real sums[GROUP] = {{0.0}};
    for (size_t k = 0; k < a->size; ++k)
        UNROLL for (size_t g = 0; g < GROUP; ++g)
        {
            real x;
            memcpy(&x, from + k * a->spacing + g * L, sizeof x);
            sums[g] += x;
            to[g * room + k] = x;
        }
    for (size_t g = 0; g < GROUP; ++g) *sum += sums[g];
}

/* the entries of L of the `left` states into vectors, of which a whole number of squares is written;
 * what is read is added to `sum` */
static void gather(const double *from, const numbers *a, size_t left, real *to, real *sum)
{
    const size_t size = a->size, room = (left - 1) * a->stride + size;
    size_t k = 0;
    /* whole squares, the last of which may overlap the one before or reach into the next rows */
    if (a->spacing == 1 && left >= L && (size >= L || (L - 1) * a->stride + L <= room))
        for (; k < size; k += L) {
            const size_t at = size >= L && k + L > size ? size - L : k;
            real square[L];
            columns(from + at, a->stride, square);
            *sum += total(square);
            UNROLL for (size_t i = 0; i < L; ++i) to[at + i] = square[i];
        }
    /* number by number; what is missing repeats the last state */
    for (; k < size; ++k) {
        for (size_t j = 0; j < L; ++j)
            to[k][j] = from[(j < left ? j : left - 1) * a->stride + k * a->spacing];
        *sum += to[k];
    }
}

/* up to L numbers, in halves that overlap: loops over so few become calls of memcpy */
static inline void put_few(const double *from, size_t size, double *to)
{
    if (size >= L / 2) {
        memcpy(to, from, L / 2 * sizeof(double));
        memcpy(to + size - L / 2, from + size - L / 2, L / 2 * sizeof(double));
    } else {
        for (size_t i = 0; i < size; ++i) to[i] = from[i];
    }
}

/* `size` vectors, of which a whole number of squares is read, into L rows, one behind the other;
 * they are added to `sum` */
static void scatter_rows(const real *from, size_t size, double *rows, real *sum)
{
    for (size_t k = 0; k < size; k += L) {
        /* the last square overlaps the one before, or reaches into rows still to come */
        const size_t at = size >= L && k + L > size ? size - L : k;
        real square[L];
        UNROLL for (size_t i = 0; i < L; ++i) square[i] = from[at + i];
        *sum += total(square);
        turn(square);
        UNROLL for (size_t j = 0; j < L; ++j) {
            double *const row = rows + j * size + at;
            if (j * size + at + L <= L * size) {
                put_row(square, j, row);
            } else {
                double last[L];
                put_row(square, j, last);
                put_few(last, size - at, row);
            }
        }
    }
}

/* vectors to the results of the first `left` states; they are added to `sum` */
static void scatter(const real *from, const numbers *a, size_t left, double *to, real *sum)
{
    if (left >= L && a->spacing == 1) {
        scatter_rows(from, a->size, to, sum);
        return;
    }
    real all = {0.0};
    for (size_t k = 0; k < a->size; ++k) {
        double *const at = to + k * a->spacing;
        const real x = from[k];
        all += x;
        if (left >= L && a->stride == 1)
            memcpy(at, &x, sizeof x);
        else
            for (size_t j = 0; j < left && j < L; ++j) at[j * a->stride] = x[j];
    }
    *sum += all;
}

/* States from `first` to before `last` one after the other, as cardan_map does it, in `room` for the
 * numbers of one. */
static int one_by_one(cardan_single *single, const double *const *blocks, const numbers *shapes,
                      size_t first, size_t last, double *out, CARDAN_WIDE *room, ptrdiff_t *failed)
{
    const numbers *const result = shapes + BLOCKS;
    int status = CARDAN_OK;
    for (size_t i = first; i < last; ++i) {
        const CARDAN_WIDE *in[BLOCKS];
        CARDAN_WIDE *next = room;
        for (int k = 0; k < BLOCKS; ++k) {
            const numbers *const a = shapes + k;
            in[k] = blocks[k] ? next : NULL;
            for (size_t e = 0; blocks[k] && e < a->size; ++e)
                *next++ = blocks[k][i * a->stride + e * a->spacing];
        }
        const int answer = single(in, next, next + result->size);
        for (size_t e = 0; e < result->size; ++e)
            out[i * result->stride + e * result->spacing]
                = answer == CARDAN_OK ? (double)next[e] : (double)NAN;
        if (answer != CARDAN_OK && status == CARDAN_OK) {
            status = answer;
            *failed = (ptrdiff_t)i;
        }
    }
    return status;
}

int cardan_batch(int (*f)(const cardan_in *in, real *out, real *work), cardan_single *single,
                 const double *const *blocks, const size_t *strides, const size_t *spacings,
                 const size_t *sizes, size_t n, double *out, size_t work_size, double *memory,
                 ptrdiff_t *failed, int *finite)
{
    cardan_in in = {0};
    const real **field[BLOCKS] = {&in.t,   &in.q,   &in.u,      &in.z,    &in.s,
                                  &in.r,   NULL,    NULL,       &in.udot, &in.zdot,
                                  &in.lam, &in.tau, &in.wrench, &in.du,   &in.q0,
                                  &in.e,   &in.v};
    enum { W = 7 };
    numbers shapes[BLOCKS + 1];
    int moving[BLOCKS], movers = 0, status = CARDAN_OK;
    real *column[BLOCKS], *next = (real *)memory, sum = {0.0};

    *failed = -1;
    for (int k = 0; k <= BLOCKS; ++k) shapes[k] = (numbers){strides[k], spacings[k], sizes[k]};
    const numbers *const shape = shapes + BLOCKS;
    /* what all states share is copied into all lanes once */
    for (int k = 0; k < BLOCKS; ++k) {
        if (!blocks[k]) continue;
#ifdef CARDAN_LANE_PARAMETERS
        if (k == W) field[k] = &in.w;
#else
        if (k == W) in.w = blocks[k];
#endif
        if (!field[k]) continue;
        *field[k] = column[k] = next;
        next += GROUP * round_up(sizes[k]);
        if (strides[k])
            moving[movers++] = k;
        else
            for (size_t i = 0; i < sizes[k]; ++i) {
                column[k][i] = CARDAN_REAL(blocks[k][i]);
                sum += column[k][i];
            }
    }
    real *const result = next, *const work = next + round_up(shape->size);
    for (size_t i = shape->size; i < round_up(shape->size); ++i) result[i] = CARDAN_REAL(0.0);

    for (size_t i = 0; i < n; i += L) {
        const size_t left = n - i, member = i / L % GROUP;
        const int grouped = left + member * L >= GROUP * L;
        for (int m = 0; m < movers; ++m) {
            const int k = moving[m];
            const size_t room = round_up(sizes[k]);
            const double *const from = blocks[k] + i * strides[k];
            real *to = column[k];
            if (strides[k] == 1 && grouped) {
                if (member == 0) gather_group(from, shapes + k, to, room, &sum);
                to += member * room;
            } else {
                gather(from, shapes + k, left, to, &sum);
            }
            *field[k] = to;
        }
        const int answer = f(&in, result, work);
        if (answer == CARDAN_OK) {
            scatter(result, shape, left, out + i * shape->stride, &sum);
            continue;
        }
        ptrdiff_t bad = -1;
        const int first = one_by_one(single, blocks, shapes, i, left < L ? n : i + L, out,
                                     (CARDAN_WIDE *)(work + work_size), &bad);
        if (status == CARDAN_OK) {
            status = first;
            *failed = bad;
        }
    }
    *finite = status == CARDAN_OK;
    for (int j = 0; j < L; ++j) *finite = *finite && sum[j] - sum[j] == 0.0;
    return status;
}

#endif
