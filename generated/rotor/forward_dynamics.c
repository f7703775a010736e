/*
 * forward_dynamics of rotor
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 5, work 0, w 12
 * Operations per call: 111 = 62 mul, 22 sub, 21 add, 2 cos, 2 div, 2 sin
 * Operations of prepare: 11 = 5 sub, 3 add, 2 div, 1 mul
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
 * Input tau (5): applied generalized forces
 *   tau[0]  x.u.tau [N]
 *   tau[1]  y.u.tau [N]
 *   tau[2]  tilt.u.tau [N*m]
 *   tau[3]  lean.u.tau [N*m]
 *   tau[4]  spin.u.tau [N*m]
 *
 * Output udot (5)
 *   out[0]  x.udot [m/s^2]
 *   out[1]  y.udot [m/s^2]
 *   out[2]  tilt.udot [rad/s^2]
 *   out[3]  lean.udot [rad/s^2]
 *   out[4]  spin.udot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* disk: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal disk_inertia_xx = p[3]; /* kg m^2 */
    const wreal disk_inertia_yy = p[4]; /* kg m^2 */
    const wreal disk_inertia_zz = p[5]; /* kg m^2 */
    const wreal disk_base_inertia_yy = disk_inertia_yy - disk_inertia_xx;
    const wreal disk_base_half_trace = 0.5 * (disk_inertia_xx + disk_inertia_zz + disk_inertia_yy);
    const wreal disk_base_second_moment_xx = disk_base_half_trace - disk_inertia_xx;
    const wreal disk_base_second_moment_yy = disk_base_half_trace - disk_inertia_yy;
    w[4] = disk_base_inertia_yy;
    w[5] = disk_base_second_moment_xx;
    w[6] = disk_base_second_moment_yy;

    /* shaft: base, inertia, composite */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal shaft_base_second_moment_zz = disk_base_half_trace - disk_inertia_zz;
    const wreal disk_inertia_xx_plus_base_inertia_yy = disk_inertia_xx + disk_base_inertia_yy;
    const wreal shaft_composite_inertia_zz = disk_inertia_zz - disk_inertia_xx;
    w[7] = shaft_base_second_moment_zz;
    w[8] = disk_inertia_xx_plus_base_inertia_yy;
    w[9] = shaft_composite_inertia_zz;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal disk_mass = p[2]; /* kg */
    const wreal M_factor_D_inverse_spin = 1.0 / disk_inertia_zz;
    const wreal M_factor_D_inverse_x = 1.0 / disk_mass;
    w[10] = M_factor_D_inverse_spin;
    w[11] = M_factor_D_inverse_x;

    /* parameters as they are */
    w[0] = p[0]; /* outer */
    w[1] = p[1]; /* inner */
    w[2] = p[3]; /* disk.inertia.xx [kg m^2] */
    w[3] = p[5]; /* disk.inertia.zz [kg m^2] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real lean_q = q[3]; /* rad */
    const real spin_q = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {spin_q, lean_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real spin_cos = cosine[0];
    const real spin_sin = sine[0];
    const real lean_cos = cosine[1];
    const real lean_sin = sine[1];

    /* x: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real x_q = q[0]; /* m */
    const real y_q = q[1]; /* m */
    const real x_u_tau = tau[0]; /* N */
    const real x_u = u[0]; /* m/s */
    const real spin_u = u[4]; /* rad/s */
    const wreal outer = w[0];
    const wreal inner = w[1];
    const wreal M_factor_D_inverse_x = w[11];
    const real x_tau = 20000.0 * lean_q + outer * x_u + 400000.0 * x_q + inner * (x_u
        + y_q * spin_u);
    const real x_drive = x_u_tau - x_tau;
    out[0] = x_drive * M_factor_D_inverse_x; /* udot: x.udot [m/s^2] */

    /* shaft: inertia, composite, omega, U, alpha */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    const real tilt_u = u[2]; /* rad/s */
    const real lean_u = u[3]; /* rad/s */
    const wreal disk_base_inertia_yy = w[4];
    const wreal disk_inertia_xx_plus_base_inertia_yy = w[8];
    const real shaft_minus_inertia_shear = disk_base_inertia_yy * spin_sin;
    const real shaft_composite_inertia_xx = spin_sin * shaft_minus_inertia_shear;
    const real shaft_composite_inertia_yy = disk_inertia_xx_plus_base_inertia_yy
        - shaft_composite_inertia_xx;
    const real shaft_omega_x = tilt_u * lean_cos;
    const real shaft_omega_z = tilt_u * lean_sin;
    const real shaft_minus_alpha_x = lean_u * shaft_omega_z;
    const real shaft_alpha_z = lean_u * shaft_omega_x;
    const real shaft_U_xz = shaft_omega_x * shaft_omega_z;
    const real shaft_U_yz = shaft_minus_alpha_x + shaft_minus_alpha_x;

    /* shared by several: inertia */
    const real c_minus_composite_inertia_xy = spin_cos * shaft_minus_inertia_shear * lean_cos;

    /* c: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal disk_inertia_xx = w[2]; /* kg m^2 */
    const wreal shaft_composite_inertia_zz = w[9];
    const real c_composite_inertia_xx = disk_inertia_xx + shaft_composite_inertia_xx
        + lean_sin * (shaft_composite_inertia_zz - shaft_composite_inertia_xx) * lean_sin;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal disk_inertia_zz = w[3]; /* kg m^2 */
    const wreal M_factor_D_inverse_spin = w[10];
    const real M_spin_tilt = disk_inertia_zz * lean_sin;
    const real M_factor_L_spin_tilt = M_spin_tilt * M_factor_D_inverse_spin;
    const real M_factor_D_inverse_lean = 1.0 / shaft_composite_inertia_yy;
    const real M_minus_factor_L_lean_tilt = c_minus_composite_inertia_xy * M_factor_D_inverse_lean;

    /* disk: omega, alpha, U, n, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal disk_base_second_moment_xx = w[5];
    const wreal disk_base_second_moment_yy = w[6];
    const real disk_omega_x = spin_cos * shaft_omega_x + lean_u * spin_sin;
    const real disk_omega_y = lean_u * spin_cos - spin_sin * shaft_omega_x;
    const real disk_omega_z = spin_u + shaft_omega_z;
    const real disk_alpha_x = spin_u * disk_omega_y - spin_cos * shaft_minus_alpha_x;
    const real disk_alpha_y = spin_sin * shaft_minus_alpha_x - spin_u * disk_omega_x;
    const real disk_omega_x_times_omega_y = disk_omega_x * disk_omega_y;
    const real disk_U_xy = disk_omega_x_times_omega_y - shaft_alpha_z;
    const real disk_U_yx = shaft_alpha_z + disk_omega_x_times_omega_y;
    const real disk_U_zx = disk_omega_x * disk_omega_z - disk_alpha_y;
    const real disk_U_zy = disk_alpha_x + disk_omega_y * disk_omega_z;
    const real disk_n_x = disk_base_second_moment_yy * disk_U_zy;
    const real disk_minus_n_y = disk_base_second_moment_xx * disk_U_zx;
    const real disk_n_z = disk_base_second_moment_xx * disk_U_yx
        - disk_base_second_moment_yy * disk_U_xy;

    /* shaft: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal shaft_base_second_moment_zz = w[7];
    const real shaft_n_x = spin_cos * disk_n_x - shaft_base_second_moment_zz * shaft_U_yz
        + spin_sin * disk_minus_n_y;
    const real shaft_n_y = shaft_base_second_moment_zz * shaft_U_xz + spin_sin * disk_n_x
        - spin_cos * disk_minus_n_y;

    /* c: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real c_n_x = lean_cos * shaft_n_x + lean_sin * disk_n_z;

    /* lean: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real lean_u_tau = tau[3]; /* N*m */
    const real lean_tau = 8000.0 * lean_q + 20000.0 * x_q + shaft_n_y;
    const real lean_drive = lean_u_tau - lean_tau;

    /* tilt: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real tilt_q = q[2]; /* rad */
    const real tilt_u_tau = tau[2]; /* N*m */
    const real tilt_tau = 8000.0 * tilt_q - 20000.0 * y_q + c_n_x;
    const real tilt_drive = tilt_u_tau - tilt_tau;

    /* y: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real y_u_tau = tau[1]; /* N */
    const real y_u = u[1]; /* m/s */
    const real y_drive = 20000.0 * tilt_q + y_u_tau - (400000.0 * y_q + outer * y_u)
        - inner * (y_u - x_q * spin_u);
    out[1] = y_drive * M_factor_D_inverse_x; /* udot: y.udot [m/s^2] */

    /* spin: drive */
    /* drive = tau + f - h */
    const real spin_u_tau = tau[4]; /* N*m */
    const real spin_drive = spin_u_tau - disk_n_z;

    /* tilt: udot */
    /* udot = M⁻¹ drive */
    const real tilt_udot = 1.0 / (c_composite_inertia_xx - M_spin_tilt * M_factor_L_spin_tilt
        - c_minus_composite_inertia_xy * M_minus_factor_L_lean_tilt) * (lean_drive *
        M_minus_factor_L_lean_tilt - spin_drive * M_factor_L_spin_tilt + tilt_drive);
    out[2] = tilt_udot; /* udot: tilt.udot [rad/s^2] */

    /* lean: udot */
    /* udot = M⁻¹ drive */
    /* udot: lean.udot [rad/s^2] */
    out[3] = lean_drive * M_factor_D_inverse_lean + M_minus_factor_L_lean_tilt * tilt_udot;

    /* spin: udot */
    /* udot = M⁻¹ drive */
    /* udot: spin.udot [rad/s^2] */
    out[4] = spin_drive * M_factor_D_inverse_spin - M_factor_L_spin_tilt * tilt_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {5, 0, 12, 0, 5, 5, 0, 0, 0, 6, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0};
#endif
