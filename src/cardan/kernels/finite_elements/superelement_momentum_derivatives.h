/*
 * superelement_momentum_derivatives.h: the same as superelement_derivatives.h of momenta and of the power.
 *
 * A sum of the angular momentum about the origin of the ground with weights a and of the momentum with
 * weights b is u'.M u for the rigid motion u' with the angular velocity a and the velocity b there. A
 * rotation of the node changes it as the velocities that it is told by change along the axes of the node,
 *
 *     dtheta.(p' x v + p x v' + n x w'),  p, n and p' the momenta of u and of u' along these axes,
 *
 * and its place, where v' = b + a x x, by dx.(p x a).
 */
#ifndef CARDAN_SUPERELEMENT_MOMENTUM_DERIVATIVES_H
#define CARDAN_SUPERELEMENT_MOMENTUM_DERIVATIVES_H

#include "superelement_derivatives.h"

CARDAN_INLINE int cardan_superelement_momentum_gradient(int n, int on_node, int drifts, int nr,
                                                        const double *constants, const cardan_in *in,
                                                        real *CARDAN_RESTRICT out,
                                                        real *CARDAN_RESTRICT work)
{
    const int N = n + 6 * on_node, m = n + 6, first = m - N;
    real *const q = work, *const u = q + m + 1, *const rigid = u + m, *const along = rigid + m;
    real *const momenta = along + m, *const back = momenta + 2 * m, *const scratch = back + 2 * m;
    real *const by_u = out + N + on_node;
    real *const by_p = cardan_superelement_remaining(nr, by_u + 2 * N), *const by_g = by_p + 3;
    const real *const a = in->v, *const b = in->v + 3;
    real v[3], v_rigid[3], force[3];
    cardan_frame_motion at;
    cardan_in there = *in, other;

    /* what is fixed to the ground, as if it were to a node at rest there */
    for (int k = 0; k < 7; ++k) q[k] = on_node ? in->q[k] : CARDAN_REAL(k == 0 ? 1.0 : 0.0);
    for (int k = 0; k < 6; ++k) u[k] = on_node ? in->u[k] : CARDAN_REAL(0.0);
    for (int i = 0; i < n; ++i) {
        q[7 + i] = in->q[7 * on_node + i];
        u[6 + i] = in->u[6 * on_node + i];
        rigid[6 + i] = CARDAN_REAL(0.0);
    }
    there.q = q;
    there.u = u;
    there.udot = rigid;
    cardan_frame_motion_of(&there, 1, 1, &at);
    cardan_3_times(at.node, 1, a, 1, rigid);
    for (int k = 0; k < 3; ++k) rigid[3 + k] = b[k];
    cardan_3_add_cross(a, q + 4, rigid + 3);
    /* momenta of both motions, and half of the slope of u'.M u by z */
    (void)cardan_superelement_generalized_momenta(n, 1, drifts, constants, &there, momenta, scratch);
    other = there;
    other.u = rigid;
    other.udot = u;
    (void)cardan_superelement_generalized_momenta(n, 1, drifts, constants, &other, back, scratch);

    cardan_3_times(at.node, 1, u + 3, 1, v);
    cardan_3_times(at.node, 1, rigid + 3, 1, v_rigid);
    cardan_3_times(at.node, 0, momenta + 3, 1, force);
    cardan_3_cross(back + 3, v, along);
    cardan_3_add_cross(momenta + 3, v_rigid, along);
    cardan_3_add_cross(momenta, rigid, along);
    cardan_3_cross(force, a, along + 3);
    for (int i = 0; i < n; ++i) along[6 + i] = momenta[m + 6 + i] * 2.0;
    cardan_by_coordinates(n, on_node, q, along + first, out);
    /* by the place of the frame, which has the velocity w x e */
    cardan_3_cross(back + 3, u, by_p);
    cardan_3_add_cross(momenta + 3, rigid, by_p);
    /* speeds of the node are told in ground axes */
    cardan_3_times(at.node, 0, back + 3, 1, force);
    for (int k = 0; k < 3; ++k) {
        back[3 + k] = force[k];
        by_g[k] = CARDAN_REAL(0.0);
    }
    for (int i = 0; i < N; ++i) {
        by_u[i] = back[first + i];
        by_u[N + i] = CARDAN_REAL(0.0);
    }
    return CARDAN_OK;
}

/* Of -z'.D z' with a weight. */
CARDAN_INLINE int cardan_superelement_power_gradient(int n, int on_node, int drifts, int nr,
                                                     const double *constants, const cardan_in *in,
                                                     real *CARDAN_RESTRICT out,
                                                     real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const int first = 6 * on_node, N = n + first, nq = N + on_node;
    real *const by_p = cardan_superelement_remaining(nr, out + nq + 2 * N);

    for (int i = 0; i < nq + 2 * N; ++i) out[i] = CARDAN_REAL(0.0);
    cardan_set_product(n, n, NULL, c.damping, in->u + first, work);
    for (int i = 0; i < n; ++i) out[nq + first + i] = work[i] * in->v[0] * -2.0;
    for (int k = 0; k < 6; ++k) by_p[k] = CARDAN_REAL(0.0);
    return CARDAN_OK;
}

/* The momenta along a direction. */
CARDAN_INLINE int cardan_superelement_momentum_change(int n, int on_node, int drifts, int nr,
                                                      const double *constants, const cardan_in *in,
                                                      real *CARDAN_RESTRICT out,
                                                      real *CARDAN_RESTRICT work)
{
    const int states = n + 7 * on_node + 2 * (n + 6 * on_node) + nr + 1;
    real weights[6];
    cardan_in there = *in;

    there.v = weights;
    for (int k = 0; k < 6; ++k) {
        for (int i = 0; i < 6; ++i) weights[i] = CARDAN_REAL(i == k ? 1.0 : 0.0);
        (void)cardan_superelement_momentum_gradient(n, on_node, drifts, nr, constants, &there, work,
                                                    work + states + 15);
        out[k] = cardan_superelement_along(states, work, in->v);
    }
    return CARDAN_OK;
}

CARDAN_INLINE int cardan_superelement_power_change(int n, int on_node, int drifts, int nr,
                                                   const double *constants, const cardan_in *in,
                                                   real *CARDAN_RESTRICT out,
                                                   real *CARDAN_RESTRICT work)
{
    const int states = n + 7 * on_node + 2 * (n + 6 * on_node) + nr + 1;
    const real weight[1] = {CARDAN_REAL(1.0)};
    cardan_in there = *in;

    there.v = weight;
    (void)cardan_superelement_power_gradient(n, on_node, drifts, nr, constants, &there, work,
                                             work + states + 15);
    out[0] = cardan_superelement_along(states, work, in->v);
    return CARDAN_OK;
}

#endif
