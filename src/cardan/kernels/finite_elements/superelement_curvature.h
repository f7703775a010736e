/*
 * superelement_curvature.h: changes of the gradients of superelement_derivatives.h
 * and superelement_momentum_derivatives.h.
 *
 * in->v has the weights, then a direction of q as it is stored, u, udot, inputs, time and data. The
 * results are those of the gradient, whose functions are polynomials: they compute with complex numbers
 * here, see complex_numbers.h, one state after the other. A quaternion is to have the length 1, and its
 * direction to be along it; the length itself counts for nothing, as in the gradient.
 */
#ifndef CARDAN_SUPERELEMENT_CURVATURE_H
#define CARDAN_SUPERELEMENT_CURVATURE_H

#include "superelement_momentum_derivatives.h"
#include "real_numbers.h"

typedef int cardan_complex_gradient(int n, int on_node, int drifts, int nr, const double *constants,
                                    const cardan_complex_in *in, cardan_complex *CARDAN_RESTRICT out,
                                    cardan_complex *CARDAN_RESTRICT work);

/* count numbers of a state with their direction, NULL for none; returns where what follows begins */
CARDAN_INLINE cardan_complex *cardan_join_all(int count, const real *x, const real *along, int lane,
                                              cardan_complex *out)
{
    (void)lane;
    for (int k = 0; k < count; ++k)
        cardan_join(CARDAN_ENTRY(x[k], lane), along ? CARDAN_ENTRY(along[k], lane) : 0.0, out + k);
    return out + count;
}

CARDAN_INLINE int cardan_superelement_curvature(cardan_complex_gradient *gradient, int weights, int n,
                                                int on_node, int drifts, int nr,
                                                const double *constants, const cardan_in *in,
                                                real *CARDAN_RESTRICT out, real *CARDAN_RESTRICT work)
{
    const int N = n + 6 * on_node, nq = N + on_node, data = nq + 2 * N + nr + 1, count = data + 15;
    const real *const along = in->v + weights;
    cardan_complex *const first = (cardan_complex *)(void *)work;
    int status = CARDAN_OK;

    for (int lane = 0; lane < CARDAN_LANES; ++lane) {
        cardan_complex *to = first, *result;
        cardan_complex_in there;

        there.q = to;
        to = cardan_join_all(nq, in->q, along, lane, to);
        there.u = to;
        to = cardan_join_all(N, in->u, along + nq, lane, to);
        there.udot = to;
        /* energies do not depend on accelerations */
        if (in->udot) to = cardan_join_all(N, in->udot, along + nq + N, lane, to);
        there.v = to;
        to = cardan_join_all(weights, in->v, NULL, lane, to);
        there.w = to;
        /* nothing is known of how the frame is turned on its node */
        for (int k = 0; k < 15; ++k)
            cardan_join(CARDAN_WENTRY(in->w[k], lane),
                        k < 9 ? 0.0 : CARDAN_ENTRY(along[data + k], lane), to + k);
        result = to + 15;
        status |= gradient(n, on_node, drifts, nr, constants, &there, result, result + count);
        for (int k = 0; k < count; ++k) CARDAN_ENTRY(out[k], lane) = cardan_along(result + k);
    }
    return status;
}

CARDAN_INLINE int cardan_superelement_dynamics_curvature(int n, int on_node, int drifts, int nr,
                                                         const double *constants, const cardan_in *in,
                                                         real *CARDAN_RESTRICT out,
                                                         real *CARDAN_RESTRICT work)
{
    return cardan_superelement_curvature(cardan_superelement_dynamics_gradient, n + 6 * on_node, n,
                                         on_node, drifts, nr, constants, in, out, work);
}

CARDAN_INLINE int cardan_superelement_energy_curvature(int n, int on_node, int drifts, int nr,
                                                       const double *constants, const cardan_in *in,
                                                       real *CARDAN_RESTRICT out,
                                                       real *CARDAN_RESTRICT work)
{
    return cardan_superelement_curvature(cardan_superelement_energy_gradient, 2, n, on_node, drifts, nr,
                                         constants, in, out, work);
}

CARDAN_INLINE int cardan_superelement_impulse_curvature(int n, int on_node, int drifts, int nr,
                                                       const double *constants, const cardan_in *in,
                                                       real *CARDAN_RESTRICT out,
                                                       real *CARDAN_RESTRICT work)
{
    return cardan_superelement_curvature(cardan_superelement_impulse_gradient, n + 6 * on_node, n, on_node,
                                         drifts, nr, constants, in, out, work);
}

CARDAN_INLINE int cardan_superelement_momentum_curvature(int n, int on_node, int drifts, int nr,
                                                       const double *constants, const cardan_in *in,
                                                       real *CARDAN_RESTRICT out,
                                                       real *CARDAN_RESTRICT work)
{
    return cardan_superelement_curvature(cardan_superelement_momentum_gradient, 6, n, on_node,
                                         drifts, nr, constants, in, out, work);
}

CARDAN_INLINE int cardan_superelement_power_curvature(int n, int on_node, int drifts, int nr,
                                                       const double *constants, const cardan_in *in,
                                                       real *CARDAN_RESTRICT out,
                                                       real *CARDAN_RESTRICT work)
{
    return cardan_superelement_curvature(cardan_superelement_power_gradient, 1, n, on_node,
                                         drifts, nr, constants, in, out, work);
}

#endif
