/* Apply the lane build of a generated function to many states.
 *
 * Part of cardan, built like the function it calls: with -DCARDAN_LANES and, where every state has
 * parameters of its own, -DCARDAN_LANE_PARAMETERS. Caller owns all memory.
 */
#include "batch.h"

#if CARDAN_LANES > 1

enum { BLOCKS = 17, L = CARDAN_LANES };

/* room for so many vectors in whole squares */
static inline size_t round_up(size_t size) { return (size + L - 1) / L * L; }

/* loops over a square must be unrolled, or it lives in memory */
#ifdef __clang__
#define UNROLL
#else
#define UNROLL _Pragma("GCC unroll 8")
#endif

/* A square of numbers is turned in exchanges of ever larger parts: single numbers, pairs, fours. */
#if defined __clang__ || __GNUC__ >= 12
#define EXCHANGE(a, b, low, high)                                                                  \
    do {                                                                                           \
        const real upper = __builtin_shufflevector(a, b, low);                                     \
        b = __builtin_shufflevector(a, b, high);                                                   \
        a = upper;                                                                                 \
    } while (0)
#if CARDAN_LANES == 8
#define LOW_4 0, 1, 2, 3, 8, 9, 10, 11
#define HIGH_4 4, 5, 6, 7, 12, 13, 14, 15
#define LOW_1 0, 8, 2, 10, 4, 12, 6, 14
#define HIGH_1 1, 9, 3, 11, 5, 13, 7, 15
#define LOW_2 0, 1, 8, 9, 4, 5, 12, 13
#define HIGH_2 2, 3, 10, 11, 6, 7, 14, 15
#elif CARDAN_LANES == 4
#define LOW_1 0, 4, 2, 6
#define HIGH_1 1, 5, 3, 7
#define LOW_2 0, 1, 4, 5
#define HIGH_2 2, 3, 6, 7
#else
#define LOW_1 0, 2
#define HIGH_1 1, 3
#endif

/* transpose L vectors of L numbers */
static inline void turn(real *v)
{
    EXCHANGE(v[0], v[1], LOW_1, HIGH_1);
#if CARDAN_LANES >= 4
    EXCHANGE(v[2], v[3], LOW_1, HIGH_1);
    EXCHANGE(v[0], v[2], LOW_2, HIGH_2);
    EXCHANGE(v[1], v[3], LOW_2, HIGH_2);
#endif
#if CARDAN_LANES == 8
    EXCHANGE(v[4], v[5], LOW_1, HIGH_1);
    EXCHANGE(v[6], v[7], LOW_1, HIGH_1);
    EXCHANGE(v[4], v[6], LOW_2, HIGH_2);
    EXCHANGE(v[5], v[7], LOW_2, HIGH_2);
    EXCHANGE(v[0], v[4], LOW_4, HIGH_4);
    EXCHANGE(v[1], v[5], LOW_4, HIGH_4);
    EXCHANGE(v[2], v[6], LOW_4, HIGH_4);
    EXCHANGE(v[3], v[7], LOW_4, HIGH_4);
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
#if CARDAN_LANES == 8
    return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
#elif CARDAN_LANES == 4
    return (v[0] + v[1]) + (v[2] + v[3]);
#else
    return v[0] + v[1];
#endif
}

/* `size` entries of L rows into vectors, of which a whole number of squares is written; `room`
 * numbers from the first row on may be read; what is read is added to `sum` */
static void gather(const double *rows, size_t stride, size_t size, size_t room, real *to, real *sum)
{
    size_t k = 0;
    /* whole squares, the last of which may overlap the one before or reach into the next rows */
    if (size >= L || (L - 1) * stride + L <= room)
        for (; k < size; k += L) {
            const size_t at = size >= L && k + L > size ? size - L : k;
            real square[L];
            columns(rows + at, stride, square);
            *sum += total(square);
            UNROLL for (size_t i = 0; i < L; ++i) to[at + i] = square[i];
        }
    for (; k < size; ++k) {
        for (size_t j = 0; j < L; ++j) to[k][j] = rows[j * stride + k];
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
static void scatter(const real *from, size_t size, double *rows, real *sum)
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

/* one state after the other, as cardan_map does it */
static int one_by_one(cardan_single *single, const double *const *blocks, const size_t *strides,
                      size_t first, size_t last, double *out, size_t out_size, double *work,
                      ptrdiff_t *failed)
{
    int status = CARDAN_OK;
    for (size_t i = first; i < last; ++i) {
        const double *in[BLOCKS];
        for (int k = 0; k < BLOCKS; ++k) in[k] = blocks[k] ? blocks[k] + i * strides[k] : NULL;
        const int answer = single(in, out + i * out_size, work);
        if (answer == CARDAN_OK) continue;
        for (size_t k = 0; k < out_size; ++k) out[i * out_size + k] = NAN;
        if (status == CARDAN_OK) {
            status = answer;
            *failed = (ptrdiff_t)i;
        }
    }
    return status;
}

int cardan_batch(int (*f)(const cardan_in *in, real *out, real *work), cardan_single *single,
                 const double *const *blocks, const size_t *strides, const size_t *sizes, size_t n,
                 double *out, size_t out_size, double *memory, ptrdiff_t *failed, int *finite)
{
    cardan_in in = {0};
    const real **field[BLOCKS] = {&in.t,   &in.q,   &in.u,      &in.z,    &in.s,
                                  &in.r,   NULL,    NULL,       &in.udot, &in.zdot,
                                  &in.lam, &in.tau, &in.wrench, &in.du,   &in.q0,
                                  &in.e,   &in.v};
    enum { W = 7 };
    int moving[BLOCKS], movers = 0, status = CARDAN_OK;
    real *column[BLOCKS], *next = (real *)memory, sum = {0.0};

    *failed = -1;
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
        next += round_up(sizes[k]);
        if (strides[k])
            moving[movers++] = k;
        else
            for (size_t i = 0; i < sizes[k]; ++i) {
                column[k][i] = CARDAN_REAL(blocks[k][i]);
                sum += column[k][i];
            }
    }
    real *const result = next, *const work = next + round_up(out_size);
    for (size_t i = out_size; i < round_up(out_size); ++i) result[i] = CARDAN_REAL(0.0);

    for (size_t i = 0; i < n; i += L) {
        const size_t left = n - i;
        for (int m = 0; m < movers; ++m) {
            const int k = moving[m];
            const double *const rows = blocks[k] + i * strides[k];
            if (left >= L)
                gather(rows, strides[k], sizes[k], (left - 1) * strides[k] + sizes[k], column[k],
                       &sum);
            else
                for (size_t e = 0; e < sizes[k]; ++e) {
                    for (size_t j = 0; j < L; ++j)
                        column[k][e][j] = rows[(j < left ? j : left - 1) * strides[k] + e];
                    sum += column[k][e];
                }
        }
        const int answer = f(&in, result, work);
        if (answer != CARDAN_OK) {
            ptrdiff_t bad = -1;
            const int first = one_by_one(single, blocks, strides, i, left < L ? n : i + L, out,
                                         out_size, (double *)work, &bad);
            if (status == CARDAN_OK) {
                status = first;
                *failed = bad;
            }
        } else if (left >= L) {
            scatter(result, out_size, out + i * out_size, &sum);
        } else {
            for (size_t e = 0; e < out_size; ++e) {
                for (size_t j = 0; j < left; ++j) out[(i + j) * out_size + e] = result[e][j];
                sum += result[e];
            }
        }
    }
    *finite = status == CARDAN_OK;
    for (int j = 0; j < L; ++j) *finite = *finite && sum[j] - sum[j] == 0.0;
    return status;
}

#endif
