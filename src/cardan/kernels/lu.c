/* Dense linear systems that are factored once and solved often.
 *
 * Part of cardan. Caller owns all memory.
 * Source: G. H. Golub, C. F. Van Loan, Matrix Computations, section 3.4.
 */
#include "lu.h"
#include <float.h>
#include <math.h>

/* P A = L U in place of A (n, n) by rows, with row exchanges; order (n): the row taken at each step.
 *
 * Returns CARDAN_SINGULAR where a pivot is no more than rounding of the largest entry.
 */
int cardan_lu_factor(ptrdiff_t n, real *a, real *order)
{
    real largest = 0;

    for (ptrdiff_t i = 0; i < n * n; i++)
        largest = fmax(largest, fabs(a[i]));
    if (!(largest - largest == 0))
        return CARDAN_SINGULAR;
    for (ptrdiff_t k = 0; k < n; k++) {
        ptrdiff_t best = k;

        for (ptrdiff_t i = k + 1; i < n; i++)
            if (fabs(a[i * n + k]) > fabs(a[best * n + k]))
                best = i;
        order[k] = (real)best;
        if (!(fabs(a[best * n + k]) > DBL_EPSILON * largest))
            return CARDAN_SINGULAR;
        for (ptrdiff_t j = 0; j < n && best != k; j++) {
            const real held = a[k * n + j];
            a[k * n + j] = a[best * n + j];
            a[best * n + j] = held;
        }
        for (ptrdiff_t i = k + 1; i < n; i++) {
            const real factor = a[i * n + k] / a[k * n + k];
            a[i * n + k] = factor;
            if (factor == 0)
                continue;
            for (ptrdiff_t j = k + 1; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
        }
    }
    return CARDAN_OK;
}

/* b (n) becomes the solution of A x = b, by the factors of A. */
void cardan_lu_solve(ptrdiff_t n, const real *a, const real *order, real *b)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        const ptrdiff_t row = (ptrdiff_t)order[k];
        const real held = b[k];
        b[k] = b[row];
        b[row] = held;
    }
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t j = 0; j < i; j++)
            b[i] -= a[i * n + j] * b[j];
    for (ptrdiff_t i = n - 1; i >= 0; i--) {
        for (ptrdiff_t j = i + 1; j < n; j++)
            b[i] -= a[i * n + j] * b[j];
        b[i] /= a[i * n + i];
    }
}
