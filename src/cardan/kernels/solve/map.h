/* Apply one generated function to many states, and check numbers. Part of cardan. */
#ifndef CARDAN_MAP_H
#define CARDAN_MAP_H

#include "cardan.h"
#include <stddef.h>

/* f at n states.
 *
 * blocks   16 pointers in the order of cardan_in, NULL for unused blocks
 * strides  16 distances from one state to the next, 0 for a block that all states share
 * out      n results of out_stride numbers
 * work     work memory of f
 * failed   index of the first state at which f returned a status other than 0, else -1
 *
 * Every state is evaluated; the result is NaN where f returned a status. Returns the first nonzero
 * status, or CARDAN_TOO_LARGE, without evaluating anything, for sizes that no array can have.
 */
enum { CARDAN_TOO_LARGE = -1 };

int cardan_map(int (*f)(const cardan_in *in, real *out, real *work), const real *const *blocks,
               const size_t *strides, size_t n, real *out, size_t out_stride, real *work,
               ptrdiff_t *failed);

/* Whether `rows` rows of `size` numbers exceed the largest possible array. */
int cardan_too_large(size_t rows, size_t size);

/* Index of the first entry that is NaN or infinite, -1 if all n are finite. */
ptrdiff_t cardan_first_bad(const real *x, size_t n);

#endif
