/* Apply one generated function to many states, and check numbers.
 *
 * Part of cardan. Caller owns all memory; nothing here allocates or keeps state.
 */
#include "cardan.h"
#include <stddef.h>

typedef int (*cardan_function)(const cardan_in *in, real *out, real *work);

int cardan_map(cardan_function f, const real *const *blocks, const ptrdiff_t *strides,
               ptrdiff_t n, real *out, ptrdiff_t out_stride, real *work, ptrdiff_t *failed);
ptrdiff_t cardan_first_bad(const real *x, ptrdiff_t n);

/* f at n states.
 *
 * blocks   15 pointers in the order of cardan_in, NULL where nothing is given
 * strides  15 distances from one state to the next, 0 for a block that all states share
 * out      n results, out_stride apart
 * failed   index of the first state at which f returned a status other than 0, else -1
 *
 * Every state is evaluated. Returns the first status that is not 0.
 */
int cardan_map(cardan_function f, const real *const *blocks, const ptrdiff_t *strides,
               ptrdiff_t n, real *out, ptrdiff_t out_stride, real *work, ptrdiff_t *failed)
{
    const real *at[15];
    cardan_in in;
    int status = 0;

    *failed = -1;
    for (int k = 0; k < 15; k++)
        at[k] = blocks[k];
    for (ptrdiff_t i = 0; i < n; i++) {
        /* the record of this state */
        in.t = at[0];
        in.q = at[1];
        in.u = at[2];
        in.z = at[3];
        in.s = at[4];
        in.r = at[5];
        in.p = at[6];
        in.w = at[7];
        in.udot = at[8];
        in.zdot = at[9];
        in.lam = at[10];
        in.tau = at[11];
        in.wrench = at[12];
        in.du = at[13];
        in.q0 = at[14];
        int answer = f(&in, out + i * out_stride, work);
        if (answer != 0 && status == 0) {
            status = answer;
            *failed = i;
        }
        /* the next state; a block that is not there stays away */
        for (int k = 0; k < 15; k++)
            if (at[k])
                at[k] += strides[k];
    }
    return status;
}

/* Index of the first entry that is NaN or infinite, -1 if all are finite. */
ptrdiff_t cardan_first_bad(const real *x, ptrdiff_t n)
{
    ptrdiff_t i = 0;

    /* blocks of 8: x - x is 0 for every finite number and NaN otherwise */
    for (; i + 8 <= n; i += 8) {
        real a = (x[i] - x[i]) + (x[i + 1] - x[i + 1]);
        real b = (x[i + 2] - x[i + 2]) + (x[i + 3] - x[i + 3]);
        real c = (x[i + 4] - x[i + 4]) + (x[i + 5] - x[i + 5]);
        real d = (x[i + 6] - x[i + 6]) + (x[i + 7] - x[i + 7]);
        if (!((a + b) + (c + d) == 0))
            break;
    }
    for (; i < n; i++)
        if (!(x[i] - x[i] == 0))
            return i;
    return -1;
}
