/* Calls a function of an element for many elements, as a loop over a mesh does. */
#include "cardan.h"

int elements(int (*function)(const cardan_in *, real *, real *), const real *q, const real *u,
             const real *udot, const real *z, const wreal *w, int nq, int nu, int nw, int count,
             int times, real *out, real *work);

int elements(int (*function)(const cardan_in *, real *, real *), const real *q, const real *u,
             const real *udot, const real *z, const wreal *w, int nq, int nu, int nw, int count,
             int times, real *out, real *work)
{
    int status = 0;
    for (int n = 0; n < times * count; ++n) {
        const int k = n % count;
        const cardan_in in = {.q = q + k * nq,
                              .u = u + k * nu,
                              .udot = udot + k * nu,
                              .du = udot + k * nu,
                              .z = z + k * 6,
                              .w = w + k * nw};
        status |= function(&in, out, work);
    }
    return status;
}
