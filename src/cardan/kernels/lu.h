/* Dense linear systems that are factored once and solved often. Part of cardan. */
#ifndef CARDAN_LU_H
#define CARDAN_LU_H

#include "cardan.h"
#include <stddef.h>

int cardan_lu_factor(ptrdiff_t n, real *a, real *order);
void cardan_lu_solve(ptrdiff_t n, const real *a, const real *order, real *b);

#endif
