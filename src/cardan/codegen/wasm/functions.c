/* functions.wasm: what generated functions call, and memory for them to work on.
 *
 * Part of cardan. Everything else of the kernels: kernels.c.
 */
#include "cardan.h"
#include "dependent.h"
#include "solve.h"

#define EXPORT(name) __attribute__((export_name(#name)))

#define OF_ONE(F) \
    F(tan) F(asin) F(acos) F(atan) F(exp) F(log) F(sinh) F(cosh) F(tanh) F(asinh) F(acosh) F(atanh)
#define DEFINE_ONE(name) \
    EXPORT(cardan_##name) double exported_##name(double x) { return cardan_##name(x); }
OF_ONE(DEFINE_ONE)

EXPORT(cardan_atan2) double exported_atan2(double y, double x) { return cardan_atan2(y, x); }
EXPORT(cardan_pow) double exported_pow(double x, double y) { return cardan_pow(x, y); }
EXPORT(cardan_sincos) void exported_sincos(int n, const double *x, double *sine, double *cosine)
{
    cardan_sincos(n, x, sine, cosine);
}

EXPORT(cardan_stumpff) double exported_stumpff(int k, double x) { return cardan_stumpff(k, x); }
EXPORT(cardan_piecewise)
double exported_piecewise(int pieces, int order, const double *breaks, const double *coefficients,
                          int derivative, double x)
{
    return cardan_piecewise(pieces, order, breaks, coefficients, derivative, x);
}

#define SOLVERS(F) F(spd) F(symmetric_indefinite) F(rank_revealing) F(semidefinite) F(basic)
#define DEFINE_SOLVER(kind)                                                                        \
    EXPORT(cardan_solve_##kind)                                                                    \
    int exported_solve_##kind(int n, int m, double *a, double *b, double *scratch)                 \
    {                                                                                              \
        return cardan_solve_##kind(n, m, a, b, scratch);                                           \
    }
SOLVERS(DEFINE_SOLVER)
