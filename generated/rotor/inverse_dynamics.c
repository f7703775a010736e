/*
 * inverse_dynamics of rotor
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 5, work 0, w 6
 * Operations per call: 88 = 48 mul, 23 add, 13 sub, 2 cos, 2 sin
 * Operations of prepare: 6 = 3 sub, 2 add, 1 mul
 *
 * Input q (5): generalized coordinates
 *   q[0]  x [m]
 *   q[1]  y [m]
 *   q[2]  tilt [rad]
 *   q[3]  lean [rad]
 *   q[4]  spin [rad]
 *
 * Input u (5): generalized speeds
 *   u[0]  x.u [m/s]
 *   u[1]  y.u [m/s]
 *   u[2]  tilt.u [rad/s]
 *   u[3]  lean.u [rad/s]
 *   u[4]  spin.u [rad/s]
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Input udot (5): derivatives of the speeds
 *   udot[0]  x.udot [m/s^2]
 *   udot[1]  y.udot [m/s^2]
 *   udot[2]  tilt.udot [rad/s^2]
 *   udot[3]  lean.udot [rad/s^2]
 *   udot[4]  spin.udot [rad/s^2]
 *
 * Output tau (5)
 *   out[0]  x.u.tau [N]
 *   out[1]  y.u.tau [N]
 *   out[2]  tilt.u.tau [N*m]
 *   out[3]  lean.u.tau [N*m]
 *   out[4]  spin.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* disk: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal disk_inertia_xx = p[3]; /* kg m^2 */
    const wreal disk_inertia_yy = p[4]; /* kg m^2 */
    const wreal disk_inertia_zz = p[5]; /* kg m^2 */
    const wreal disk_base_half_trace = 0.5 * (disk_inertia_xx + disk_inertia_zz + disk_inertia_yy);
    const wreal disk_base_second_moment_xx = disk_base_half_trace - disk_inertia_xx;
    const wreal disk_base_second_moment_yy = disk_base_half_trace - disk_inertia_yy;
    w[3] = disk_base_second_moment_xx;
    w[4] = disk_base_second_moment_yy;

    /* shaft: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal shaft_base_second_moment_zz = disk_base_half_trace - disk_inertia_zz;
    w[5] = shaft_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[0]; /* outer */
    w[1] = p[1]; /* inner */
    w[2] = p[2]; /* disk.mass [kg] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real lean_q = q[3]; /* rad */
    const real spin_q = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {lean_q, spin_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real lean_cos = cosine[0];
    const real lean_sin = sine[0];
    const real spin_cos = cosine[1];
    const real spin_sin = sine[1];

    /* shaft: omega, U, alpha */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    const real tilt_u = u[2]; /* rad/s */
    const real lean_u = u[3]; /* rad/s */
    const real tilt_udot = udot[2]; /* rad/s^2 */
    const real lean_udot = udot[3]; /* rad/s^2 */
    const real shaft_omega_x = tilt_u * lean_cos;
    const real shaft_omega_z = tilt_u * lean_sin;
    const real lean_u_times_shaft_omega_z = lean_u * shaft_omega_z;
    const real shaft_U_xz = lean_udot + shaft_omega_x * shaft_omega_z;
    const real shaft_alpha_x = tilt_udot * lean_cos - lean_u_times_shaft_omega_z;
    const real shaft_U_yz = lean_u_times_shaft_omega_z - shaft_alpha_x;
    const real shaft_alpha_z = lean_u * shaft_omega_x + tilt_udot * lean_sin;

    /* disk: omega, alpha, U, n, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real spin_u = u[4]; /* rad/s */
    const real spin_udot = udot[4]; /* rad/s^2 */
    const wreal disk_base_second_moment_xx = w[3];
    const wreal disk_base_second_moment_yy = w[4];
    const real disk_omega_x = shaft_omega_x * spin_cos + lean_u * spin_sin;
    const real disk_omega_y = lean_u * spin_cos - shaft_omega_x * spin_sin;
    const real disk_omega_z = spin_u + shaft_omega_z;
    const real disk_alpha_z = spin_udot + shaft_alpha_z;
    const real disk_alpha_x = spin_u * disk_omega_y + lean_udot * spin_sin
        + spin_cos * shaft_alpha_x;
    const real disk_alpha_y = lean_udot * spin_cos - spin_sin * shaft_alpha_x
        - spin_u * disk_omega_x;
    const real disk_omega_x_times_omega_y = disk_omega_x * disk_omega_y;
    const real disk_U_zx = disk_omega_x * disk_omega_z - disk_alpha_y;
    const real disk_U_zy = disk_alpha_x + disk_omega_y * disk_omega_z;
    const real disk_n_x = disk_base_second_moment_yy * disk_U_zy;
    const real disk_minus_n_y = disk_base_second_moment_xx * disk_U_zx;
    const real disk_U_xy = disk_omega_x_times_omega_y - disk_alpha_z;
    const real disk_U_yx = disk_alpha_z + disk_omega_x_times_omega_y;
    const real disk_n_z = disk_base_second_moment_xx * disk_U_yx
        - disk_base_second_moment_yy * disk_U_xy;
    out[4] = disk_n_z; /* tau: spin.u.tau [N*m] */

    /* b: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real x_udot = udot[0]; /* m/s^2 */
    const real y_udot = udot[1]; /* m/s^2 */
    const wreal disk_mass = w[2]; /* kg */
    const real b_f_x = disk_mass * x_udot;
    const real b_f_y = disk_mass * y_udot;

    /* x: tau */
    /* tau = S . [n; f] - force on the joint */
    const real x_q = q[0]; /* m */
    const real y_q = q[1]; /* m */
    const real x_u = u[0]; /* m/s */
    const wreal outer = w[0];
    const wreal inner = w[1];
    /* tau: x.u.tau [N] */
    out[0] = 20000.0 * lean_q + outer * x_u + (400000.0 * x_q + b_f_x) + inner * (x_u
        + y_q * spin_u);

    /* y: tau */
    /* tau = S . [n; f] - force on the joint */
    const real tilt_q = q[2]; /* rad */
    const real y_u = u[1]; /* m/s */
    /* tau: y.u.tau [N] */
    out[1] = b_f_y - 20000.0 * tilt_q + (400000.0 * y_q + outer * y_u) + inner * (y_u
        - x_q * spin_u);

    /* shaft: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal shaft_base_second_moment_zz = w[5];
    const real shaft_n_x = spin_cos * disk_n_x - shaft_base_second_moment_zz * shaft_U_yz
        + spin_sin * disk_minus_n_y;
    const real shaft_n_y = shaft_base_second_moment_zz * shaft_U_xz + spin_sin * disk_n_x
        - spin_cos * disk_minus_n_y;

    /* c: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real c_n_x = lean_cos * shaft_n_x + lean_sin * disk_n_z;

    /* lean: tau */
    /* tau = S . [n; f] - force on the joint */
    out[3] = 8000.0 * lean_q + 20000.0 * x_q + shaft_n_y; /* tau: lean.u.tau [N*m] */

    /* tilt: tau */
    /* tau = S . [n; f] - force on the joint */
    out[2] = 8000.0 * tilt_q - 20000.0 * y_q + c_n_x; /* tau: tilt.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {5, 0, 6, 0, 5, 5, 0, 0, 0, 6, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
