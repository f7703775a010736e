/* Tables whose columns are done several at a time, as vectors of the compiler.
 *
 * Part of cardan.
 */
#ifndef CARDAN_SIDE_BY_SIDE_H
#define CARDAN_SIDE_BY_SIDE_H

#include "cardan.h"
#include <stddef.h>

enum { CARDAN_SIDE_BY_SIDE = 8 };

/* numbers of so many columns; they need no alignment */
typedef real side_by_side
    __attribute__((vector_size(CARDAN_SIDE_BY_SIDE * sizeof(real)), aligned(sizeof(real)), may_alias));
#define AT(at) (*(side_by_side *)(void *)(at))
#define OF(at) (*(const side_by_side *)(const void *)(at))

/* sums (rows, wide) grow by a matrix (rows, size) times x (size, wide). */
static inline void add_product(ptrdiff_t wide, ptrdiff_t rows, ptrdiff_t size, const real *by,
                               const real *x, real *sums)
{
    for (ptrdiff_t k = 0; k < wide; k += CARDAN_SIDE_BY_SIDE)
        for (ptrdiff_t i = 0; i < rows; i++) {
            side_by_side sum = AT(sums + i * wide + k);
            for (ptrdiff_t j = 0; j < size; j++)
                sum += by[i * size + j] * OF(x + j * wide + k);
            AT(sums + i * wide + k) = sum;
        }
}

#endif
