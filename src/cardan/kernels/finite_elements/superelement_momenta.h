/*
 * superelement_momenta.h: momenta of a superelement, for methods that keep them step by step.
 */
#ifndef CARDAN_SUPERELEMENT_MOMENTA_H
#define CARDAN_SUPERELEMENT_MOMENTA_H

#include "superelement.h"

/* Momenta along the axes of the node, then those of z; then, for the speeds u and u' (in udot), the
 * derivative of u'.M u / 2 by z. */
CARDAN_INLINE int cardan_superelement_generalized_momenta(int n, int on_node, int drifts,
                                                          const double *constants, const cardan_in *in,
                                                          real *CARDAN_RESTRICT out,
                                                          real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const real *const z = in->q + 7 * on_node, *const rate = in->u + 6 * on_node;
    const real *const rate_2 = in->udot + 6 * on_node;
    real *const along = out + 6 * on_node, *const slope = along + n + 6 * on_node;

    cardan_set_product(n, n, NULL, c.modal, rate, along);
    cardan_clear(n, slope);
    if (!on_node) return CARDAN_OK;

    real *const H = work, *const bent = work + 3 * n, *const mixed = work + 9 * n;
    real s[3], J[6], pairs[6], across[3], p[3], m[3];
    cardan_frame_motion at, other;
    cardan_in second = *in;

    second.u = in->udot;
    cardan_frame_motion_of(in, on_node, 1, &at);
    cardan_frame_motion_of(&second, on_node, 1, &other);
    cardan_superelement_shape(&c, z, rate, s, H, J, bent, NULL, NULL);
    /* p = m v + w x s + P z', of the frame H w + s x v + J w, along z P^T v + H^T w + M z' */
    for (int k = 0; k < 3; ++k) p[k] = c.mass[0] * at.v[k];
    cardan_dots(3, n, H, rate, m);
    cardan_rows(0, 3, n, H, at.w, along);
    cardan_superelement_flow(&c, rate, p);
    cardan_3_add_cross(at.w, s, p);
    cardan_3_add_cross(s, at.v, m);
    cardan_3_add_symmetric(J, at.w, m);
    cardan_add_product(3, n, c.momentum, at.v, along);
    /* by z: (v x w' + v' x w).P z / 2 + w.J w' / 2 + z.A_k (w_k z'' + w_k' z') / 2, where ' is of u' */
    cardan_3_cross(at.v, other.w, across);
    cardan_3_add_cross(other.v, at.w, across);
    for (int k = 0; k < 3; ++k) across[k] *= 0.5;
    cardan_add_product(3, n, c.momentum, across, slope);
    for (int k = 0; k < 6; ++k) pairs[k] = CARDAN_REAL(0.0);
    for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) pairs[CARDAN_PAIR[k][l]] += at.w[k] * other.w[l];
        for (int i = 0; i < n; ++i)
            mixed[i] = (rate_2[i] * at.w[k] + rate[i] * other.w[k]) * 0.5;
        cardan_add_product(n, n, c.spin_back + k * n * n, mixed, slope);
    }
    cardan_rows(0, 6, n, bent, pairs, slope);
    if (c.drift) {
        real G[9], more[3];

        cardan_superelement_drift(&c, z, G);
        cardan_3_times(G, 0, at.w, 1, more);
        for (int k = 0; k < 3; ++k) p[k] += more[k];
        cardan_3_times(G, 1, at.v, 1, more);
        for (int k = 0; k < 3; ++k) m[k] += more[k];
        cardan_superelement_add_drift(&c, at.v, other.w, 0.5, slope);
        cardan_superelement_add_drift(&c, other.v, at.w, 0.5, slope);
    }
    cardan_3_times(at.local, 0, p, 1, out + 3);
    cardan_3_times(at.local, 0, m, 1, out);
    cardan_3_add_cross(at.p, out + 3, out);
    for (int k = 0; k < 6; ++k) out[6 + n + k] = CARDAN_REAL(0.0);
    return CARDAN_OK;
}

#endif
