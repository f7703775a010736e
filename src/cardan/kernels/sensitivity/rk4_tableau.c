/* Coefficients of the classical Runge-Kutta method as a table.
 *
 * Part of cardan.
 */
#include "steps.h"

enum { STAGES = 4 };

ptrdiff_t cardan_rk4_tableau(real *nodes, real *weights, real *matrix)
{
    for (ptrdiff_t s = 0; s < STAGES; s++) {
        nodes[s] = s == 0 ? 0 : s == 3 ? 1 : 0.5;
        weights[s] = (s == 0 || s == 3 ? 1 : 2) / 6.0;
        for (ptrdiff_t j = 0; j < STAGES; j++)
            matrix[s * STAGES + j] = j == s - 1 ? nodes[s] : 0;
    }
    return STAGES;
}
