/* Apply the lane build of a generated function to many states. Part of cardan. */
#ifndef CARDAN_BATCH_H
#define CARDAN_BATCH_H

#include "cardan.h"
#include <stddef.h>

/* the same function built for one state; `in` is its cardan_in */
typedef int cardan_single(const double *const *in, double *out, double *work);

/* f at n states, CARDAN_LANES at a time.
 *
 * blocks   16 pointers in the order of cardan_in, NULL where nothing is given or read
 * strides  16 distances from one state to the next, 0 for a block that all states share
 * sizes    16 numbers of entries
 * out      n results of out_size numbers, one behind the other
 * memory   aligned for `real`: CARDAN_LANES numbers for every entry of a block and of the result,
 *          each rounded up to a multiple of CARDAN_LANES, and for the work memory of f
 * finite   1 if all numbers read and all results are finite; 0 if not, or if their sum is too large
 * failed   index of the first state at which `single` returned a status other than 0, else -1
 *
 * States come row by row and are turned into vectors block by block of lanes; what is missing in
 * the last block repeats the last state. Blocks of which f returns a status are done again one by
 * one, so that statuses and results are those of single states. Returns the first status.
 */
int cardan_batch(int (*f)(const cardan_in *in, real *out, real *work), cardan_single *single,
                 const double *const *blocks, const size_t *strides, const size_t *sizes, size_t n,
                 double *out, size_t out_size, double *memory, ptrdiff_t *failed, int *finite);

#endif
