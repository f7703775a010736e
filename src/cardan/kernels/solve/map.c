/* Apply one generated function to many states, and check numbers.
 *
 * Part of cardan. Caller owns all memory; nothing here allocates or keeps state.
 */
#include "map.h"
#include <math.h>
#include <stdint.h>

enum { BLOCKS = 17 };

int cardan_map(int (*f)(const cardan_in *in, real *out, real *work), const real *const *blocks,
               const size_t *strides, size_t n, real *out, size_t out_stride, real *work,
               ptrdiff_t *failed)
{
    cardan_in in = {0};
    const real **field[BLOCKS] = {&in.t,    &in.q,    &in.u,   &in.z,   &in.s,
                                  &in.r,    &in.p,    &in.w,   &in.udot, &in.zdot,
                                  &in.lam,  &in.tau,  &in.wrench, &in.du, &in.q0,
                                  &in.e,    &in.v};
    const real **moving[BLOCKS];
    size_t step[BLOCKS];
    int movers = 0, status = 0;

    *failed = -1;
    if (cardan_too_large(n, out_stride))
        return CARDAN_TOO_LARGE;
    /* input record of the first state; list the blocks that advance from state to state */
    for (int k = 0; k < BLOCKS; k++) {
        *field[k] = blocks[k];
        if (blocks[k] && strides[k]) {
            if (cardan_too_large(n, strides[k]))
                return CARDAN_TOO_LARGE;
            moving[movers] = field[k];
            step[movers++] = strides[k];
        }
    }
    /* a failing state does not stop the loop */
    for (size_t i = 0; i < n; i++) {
        int answer = f(&in, out + i * out_stride, work);
        if (answer != 0) {
            /* no result: NaN; report the first nonzero status */
            for (size_t k = 0; k < out_stride; k++)
                out[i * out_stride + k] = NAN;
            if (status == 0) {
                status = answer;
                *failed = (ptrdiff_t)i;
            }
        }
        for (int k = 0; k < movers; k++)
            *moving[k] += step[k];
    }
    return status;
}

int cardan_too_large(size_t rows, size_t size)
{
    return size != 0 && rows > (size_t)PTRDIFF_MAX / sizeof(real) / size;
}

ptrdiff_t cardan_first_bad(const real *x, size_t n)
{
    size_t i = 0;

    /* blocks of 8: x - x is 0 for every finite number and NaN otherwise */
    for (; n - i >= 8; i += 8) {
        real a = (x[i] - x[i]) + (x[i + 1] - x[i + 1]);
        real b = (x[i + 2] - x[i + 2]) + (x[i + 3] - x[i + 3]);
        real c = (x[i + 4] - x[i + 4]) + (x[i + 5] - x[i + 5]);
        real d = (x[i + 6] - x[i + 6]) + (x[i + 7] - x[i + 7]);
        if (!((a + b) + (c + d) == 0))
            break;
    }
    /* the remainder, or the block that contains the culprit */
    for (; i < n; i++)
        if (!(x[i] - x[i] == 0))
            return (ptrdiff_t)i;
    return -1;
}
