/* Apply the lane build of a generated function to many states. Part of cardan. */
#ifndef CARDAN_BATCH_H
#define CARDAN_BATCH_H

#include "cardan.h"
#include <stddef.h>

/* the numbers of single states: in single precision whoever compiles says -DCARDAN_WIDE=double */
#ifndef CARDAN_WIDE
#define CARDAN_WIDE double
#endif

/* the same function built for one state; `in` is its cardan_in */
typedef int cardan_single(const CARDAN_WIDE *const *in, CARDAN_WIDE *out, CARDAN_WIDE *work);

/* f at n states, CARDAN_LANES at a time.
 *
 * blocks   17 pointers in the order of cardan_in, NULL where nothing is given or read
 * strides  18 distances from one state to the next: of the blocks, 0 where all states share one, and
 *          of the result
 * spacings 18 distances from one entry of a state to the next; 1 where all states share a block
 * sizes    18 numbers of entries
 * out      where the result of the first state goes
 * memory   aligned for `real`: 4 CARDAN_LANES numbers for every entry of a block and CARDAN_LANES for
 *          one of the result, entries rounded up to a multiple of CARDAN_LANES, and for the work
 *          memory of f; then the same of one state in numbers of `single`, nothing rounded
 * finite   1 if all numbers read and all results are finite; 0 if not, or if their sum is too large
 * failed   index of the first state at which `single` returned a status other than 0, else -1
 *
 * Rows of states (spacing 1, results one behind the other) are transposed into vectors block by
 * block of lanes; where the states of an entry stand side by side (stride 1) vectors are read as
 * they are. What is missing in the last block repeats the last state. Blocks of which f returns a
 * status are done again one by one, so that statuses and results are those of single states.
 * Returns the first status.
 */
int cardan_batch(int (*f)(const cardan_in *in, real *out, real *work), cardan_single *single,
                 const double *const *blocks, const size_t *strides, const size_t *spacings,
                 const size_t *sizes, size_t n, double *out, size_t work_size, double *memory,
                 ptrdiff_t *failed, int *finite);

#endif
