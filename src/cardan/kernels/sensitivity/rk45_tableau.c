/* Coefficients of RK45 as a table, from the sums that the method takes.
 *
 * Part of cardan. A sum of derivatives of which one is 1 and all others are 0 is its coefficient.
 */
#define K(j) (real)((j) == column)
#include "steps.h"
#include "rk45_tables.h"

enum { STAGES = RK45_END };

ptrdiff_t cardan_rk45_tableau(real *nodes, real *weights, real *matrix)
{
    for (ptrdiff_t s = 0; s < STAGES; s++)
        nodes[s] = C[s];
    for (ptrdiff_t column = 0; column < STAGES; column++) {
        matrix[column] = 0;
/* the last stage is the solution */
#define ENTRY(s, sum) *((s) < STAGES ? matrix + (s) * STAGES + column : weights + column) = (sum);
        RK45_STAGES(ENTRY)
#undef ENTRY
    }
    return STAGES;
}
