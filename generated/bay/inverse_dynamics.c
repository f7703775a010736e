/*
 * inverse_dynamics of bay
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate
 *
 * Sizes: out 2, work 0, w 50
 * Operations per call: 564 = 312 mul, 89 add, 74 sub, 24 select, 21 div, 15 lt, 12 max, 9 sqrt,
 *     6 neg, 1 cos, 1 sin
 * Operations of prepare: 12 = 7 mul, 3 add, 2 sub
 *
 * Input q (2): generalized coordinates
 *   q[0]  height [m]
 *   q[1]  twist [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  height.u [m/s]
 *   u[1]  twist.u [rad/s]
 *
 * Input p (55): parameters, read by prepare_ only
 *
 * Input udot (2): derivatives of the speeds
 *   udot[0]  height.udot [m/s^2]
 *   udot[1]  twist.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  height.u.tau [N]
 *   out[1]  twist.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* top: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal top_inertia_xx = p[20]; /* kg m^2 */
    const wreal top_inertia_yy = p[21]; /* kg m^2 */
    const wreal top_inertia_zz = p[22]; /* kg m^2 */
    const wreal top_base_half_trace = 0.5 * (top_inertia_xx + top_inertia_zz + top_inertia_yy);
    const wreal top_base_second_moment_xx = top_base_half_trace - top_inertia_xx;
    const wreal top_base_second_moment_yy = top_base_half_trace - top_inertia_yy;
    const wreal top_base_second_moment_xx_plus_base_second_moment_yy = top_base_second_moment_xx
        + top_base_second_moment_yy;
    w[49] = top_base_second_moment_xx_plus_base_second_moment_yy;

    /* cable0 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable0_EA = p[1]; /* N */
    const wreal cable0_damping = p[3]; /* s */
    const wreal cable0_EA_times_damping = cable0_EA * cable0_damping;
    w[43] = cable0_EA_times_damping;

    /* counter0: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter0_EA = p[4]; /* N */
    const wreal counter0_damping = p[6]; /* s */
    const wreal counter0_EA_times_damping = counter0_EA * counter0_damping;
    w[44] = counter0_EA_times_damping;

    /* cable1 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable1_EA = p[7]; /* N */
    const wreal cable1_damping = p[9]; /* s */
    const wreal cable1_EA_times_damping = cable1_EA * cable1_damping;
    w[45] = cable1_EA_times_damping;

    /* counter1: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter1_EA = p[10]; /* N */
    const wreal counter1_damping = p[12]; /* s */
    const wreal counter1_EA_times_damping = counter1_EA * counter1_damping;
    w[46] = counter1_EA_times_damping;

    /* cable2 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable2_EA = p[13]; /* N */
    const wreal cable2_damping = p[15]; /* s */
    const wreal cable2_EA_times_damping = cable2_EA * cable2_damping;
    w[47] = cable2_EA_times_damping;

    /* counter2: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter2_EA = p[16]; /* N */
    const wreal counter2_damping = p[18]; /* s */
    const wreal counter2_EA_times_damping = counter2_EA * counter2_damping;
    w[48] = counter2_EA_times_damping;

    /* parameters as they are */
    w[0] = p[0]; /* load [N] */
    w[1] = p[1]; /* cable0.EA [N] */
    w[2] = p[2]; /* cable0.length [m] */
    w[3] = p[4]; /* counter0.EA [N] */
    w[4] = p[5]; /* counter0.length [m] */
    w[5] = p[7]; /* cable1.EA [N] */
    w[6] = p[8]; /* cable1.length [m] */
    w[7] = p[10]; /* counter1.EA [N] */
    w[8] = p[11]; /* counter1.length [m] */
    w[9] = p[13]; /* cable2.EA [N] */
    w[10] = p[14]; /* cable2.length [m] */
    w[11] = p[16]; /* counter2.EA [N] */
    w[12] = p[17]; /* counter2.length [m] */
    w[13] = p[19]; /* top.mass [kg] */
    w[14] = p[23]; /* bar0.stiffness [N/m] */
    w[15] = p[24]; /* bar0.damping [N*s/m] */
    w[16] = p[25]; /* bar0.rest_length [m] */
    w[17] = p[26]; /* bar0.a.position.x [m] */
    w[18] = p[27]; /* bar0.b.position.x [m] */
    w[19] = p[28]; /* bar1.stiffness [N/m] */
    w[20] = p[29]; /* bar1.damping [N*s/m] */
    w[21] = p[30]; /* bar1.rest_length [m] */
    w[22] = p[31]; /* bar1.a.position.x [m] */
    w[23] = p[32]; /* bar1.a.position.y [m] */
    w[24] = p[33]; /* bar1.b.position.x [m] */
    w[25] = p[34]; /* bar1.b.position.y [m] */
    w[26] = p[35]; /* bar2.stiffness [N/m] */
    w[27] = p[36]; /* bar2.damping [N*s/m] */
    w[28] = p[37]; /* bar2.rest_length [m] */
    w[29] = p[38]; /* bar2.a.position.x [m] */
    w[30] = p[39]; /* bar2.a.position.y [m] */
    w[31] = p[40]; /* bar2.b.position.x [m] */
    w[32] = p[41]; /* bar2.b.position.y [m] */
    w[33] = p[45]; /* cable0.b.position.x [m] */
    w[34] = p[46]; /* cable0.b.position.y [m] */
    w[35] = p[47]; /* counter0.b.position.x [m] */
    w[36] = p[48]; /* counter0.b.position.y [m] */
    w[37] = p[49]; /* cable1.b.position.x [m] */
    w[38] = p[50]; /* cable1.b.position.y [m] */
    w[39] = p[51]; /* counter1.b.position.x [m] */
    w[40] = p[52]; /* cable2.b.position.x [m] */
    w[41] = p[53]; /* counter2.b.position.x [m] */
    w[42] = p[54]; /* counter2.b.position.y [m] */
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

    /* twist: R */
    /* R = R_fixed R_joint(q) */
    const real twist_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {twist_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real twist_cos = cosine[0];
    const real twist_sin = sine[0];

    /* bar0: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real twist_u = u[1]; /* rad/s */
    const wreal bar0_a_position_x = w[17]; /* m */
    const wreal bar0_b_position_x = w[18]; /* m */
    const real bar0_spring_damper_span_y = bar0_b_position_x * twist_sin;
    const real bar0_spring_damper_span_x = bar0_b_position_x * twist_cos - bar0_a_position_x;
    const real twist_u_times_bar0_b_position_x = twist_u * bar0_b_position_x;

    /* shared by several: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real height_q = q[0]; /* m */
    const real height_squared = height_q * height_q;

    /* bar0: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real height_u = u[0]; /* m/s */
    const wreal bar0_stiffness = w[14]; /* N/m */
    const wreal bar0_damping = w[15]; /* N*s/m */
    const wreal bar0_rest_length = w[16]; /* m */
    const real bar0_spring_damper_distance = cardan_sqrt(bar0_spring_damper_span_y *
        bar0_spring_damper_span_y + height_squared
        + bar0_spring_damper_span_x * bar0_spring_damper_span_x);
    const real bar0_spring_damper_apart = cardan_lt(0.0, bar0_spring_damper_distance);
    const real bar0_spring_damper_inverse_distance = cardan_select(bar0_spring_damper_apart, 1.0,
        0.0) / cardan_select(bar0_spring_damper_apart, bar0_spring_damper_distance, 1.0);
    const real bar0_spring_damper_direction_x = bar0_spring_damper_span_x *
        bar0_spring_damper_inverse_distance;
    const real bar0_spring_damper_direction_y = bar0_spring_damper_span_y *
        bar0_spring_damper_inverse_distance;
    const real bar0_spring_damper_direction_z = height_q * bar0_spring_damper_inverse_distance;
    const real bar0_force_on_bar0_a_x_part = bar0_stiffness * (bar0_spring_damper_distance
        - bar0_rest_length);
    const real bar0_force_on_bar0_a_x_part_2 = bar0_damping * (twist_cos *
        twist_u_times_bar0_b_position_x * bar0_spring_damper_direction_y
        - twist_sin * twist_u_times_bar0_b_position_x * bar0_spring_damper_direction_x
        + height_u * bar0_spring_damper_direction_z);
    const real top_n_z_part = bar0_b_position_x * (bar0_spring_damper_direction_x *
        bar0_force_on_bar0_a_x_part_2 * twist_sin
        - bar0_spring_damper_direction_y * bar0_force_on_bar0_a_x_part_2 * twist_cos);

    /* bar1: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal bar1_stiffness = w[19]; /* N/m */
    const wreal bar1_damping = w[20]; /* N*s/m */
    const wreal bar1_rest_length = w[21]; /* m */
    const wreal bar1_a_position_x = w[22]; /* m */
    const wreal bar1_a_position_y = w[23]; /* m */
    const wreal bar1_b_position_x = w[24]; /* m */
    const wreal bar1_b_position_y = w[25]; /* m */
    const real bar1_spring_damper_span_x = bar1_b_position_x * twist_cos - bar1_a_position_x
        - bar1_b_position_y * twist_sin;
    const real bar1_spring_damper_span_y = bar1_b_position_x * twist_sin - bar1_a_position_y
        + bar1_b_position_y * twist_cos;
    const real bar1_spring_damper_distance = cardan_sqrt(height_squared
        + bar1_spring_damper_span_x * bar1_spring_damper_span_x
        + bar1_spring_damper_span_y * bar1_spring_damper_span_y);
    const real bar1_spring_damper_apart = cardan_lt(0.0, bar1_spring_damper_distance);
    const real bar1_spring_damper_inverse_distance = cardan_select(bar1_spring_damper_apart, 1.0,
        0.0) / cardan_select(bar1_spring_damper_apart, bar1_spring_damper_distance, 1.0);
    const real bar1_spring_damper_direction_x = bar1_spring_damper_span_x *
        bar1_spring_damper_inverse_distance;
    const real bar1_spring_damper_direction_y = bar1_spring_damper_span_y *
        bar1_spring_damper_inverse_distance;
    const real bar1_spring_damper_direction_z = height_q * bar1_spring_damper_inverse_distance;
    const real bar1_force_on_bar1_a_x_part = bar1_stiffness * (bar1_spring_damper_distance
        - bar1_rest_length);
    const real bar1_force_on_bar1_a_x = bar1_spring_damper_direction_x *
        bar1_force_on_bar1_a_x_part;
    const real bar1_force_on_bar1_a_y = bar1_spring_damper_direction_y *
        bar1_force_on_bar1_a_x_part;
    const real twist_u_times_bar1_b_position_y = twist_u * bar1_b_position_y;
    const real twist_u_times_bar1_b_position_x = twist_u * bar1_b_position_x;
    const real bar1_force_on_bar1_a_x_part_2 = bar1_spring_damper_direction_y * (twist_cos *
        twist_u_times_bar1_b_position_x - twist_sin * twist_u_times_bar1_b_position_y)
        - bar1_spring_damper_direction_x * (twist_cos * twist_u_times_bar1_b_position_y
        + twist_sin * twist_u_times_bar1_b_position_x);
    const real bar1_force_on_bar1_a_x_part_3 = bar1_damping * (height_u *
        bar1_spring_damper_direction_z + bar1_force_on_bar1_a_x_part_2);
    const real bar1_force_on_bar1_a_x_2 = bar1_spring_damper_direction_x *
        bar1_force_on_bar1_a_x_part_3;
    const real bar1_force_on_bar1_a_y_2 = bar1_spring_damper_direction_y *
        bar1_force_on_bar1_a_x_part_3;

    /* bar2: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal bar2_stiffness = w[26]; /* N/m */
    const wreal bar2_damping = w[27]; /* N*s/m */
    const wreal bar2_rest_length = w[28]; /* m */
    const wreal bar2_a_position_x = w[29]; /* m */
    const wreal bar2_a_position_y = w[30]; /* m */
    const wreal bar2_b_position_x = w[31]; /* m */
    const wreal bar2_b_position_y = w[32]; /* m */
    const real bar2_spring_damper_span_x = bar2_b_position_x * twist_cos - bar2_a_position_x
        - bar2_b_position_y * twist_sin;
    const real bar2_spring_damper_span_y = bar2_b_position_x * twist_sin - bar2_a_position_y
        + bar2_b_position_y * twist_cos;
    const real bar2_spring_damper_distance = cardan_sqrt(height_squared
        + bar2_spring_damper_span_x * bar2_spring_damper_span_x
        + bar2_spring_damper_span_y * bar2_spring_damper_span_y);
    const real bar2_spring_damper_apart = cardan_lt(0.0, bar2_spring_damper_distance);
    const real bar2_spring_damper_inverse_distance = cardan_select(bar2_spring_damper_apart, 1.0,
        0.0) / cardan_select(bar2_spring_damper_apart, bar2_spring_damper_distance, 1.0);
    const real bar2_spring_damper_direction_x = bar2_spring_damper_span_x *
        bar2_spring_damper_inverse_distance;
    const real bar2_spring_damper_direction_y = bar2_spring_damper_span_y *
        bar2_spring_damper_inverse_distance;
    const real bar2_spring_damper_direction_z = height_q * bar2_spring_damper_inverse_distance;
    const real bar2_force_on_bar2_a_x_part = bar2_stiffness * (bar2_spring_damper_distance
        - bar2_rest_length);
    const real bar2_force_on_bar2_a_x = bar2_spring_damper_direction_x *
        bar2_force_on_bar2_a_x_part;
    const real bar2_force_on_bar2_a_y = bar2_spring_damper_direction_y *
        bar2_force_on_bar2_a_x_part;
    const real twist_u_times_bar2_b_position_y = twist_u * bar2_b_position_y;
    const real twist_u_times_bar2_b_position_x = twist_u * bar2_b_position_x;
    const real bar2_force_on_bar2_a_x_part_2 = bar2_spring_damper_direction_y * (twist_cos *
        twist_u_times_bar2_b_position_x - twist_sin * twist_u_times_bar2_b_position_y)
        - bar2_spring_damper_direction_x * (twist_cos * twist_u_times_bar2_b_position_y
        + twist_sin * twist_u_times_bar2_b_position_x);
    const real bar2_force_on_bar2_a_x_part_3 = bar2_damping * (height_u *
        bar2_spring_damper_direction_z + bar2_force_on_bar2_a_x_part_2);
    const real bar2_force_on_bar2_a_x_2 = bar2_spring_damper_direction_x *
        bar2_force_on_bar2_a_x_part_3;
    const real bar2_force_on_bar2_a_y_2 = bar2_spring_damper_direction_y *
        bar2_force_on_bar2_a_x_part_3;

    /* cable0 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable0_EA = w[1]; /* N */
    const wreal cable0_length = w[2]; /* m */
    const wreal cable0_b_position_x = w[33]; /* m */
    const wreal cable0_b_position_y = w[34]; /* m */
    const wreal cable0_EA_times_damping = w[43];
    const real cable0_cable_span_y = cable0_b_position_x * twist_sin
        + cable0_b_position_y * twist_cos;
    const real cable0_cable_span_x = cable0_b_position_x * twist_cos - bar0_a_position_x
        - cable0_b_position_y * twist_sin;
    const real cable0_cable_distance = cardan_sqrt(height_squared
        + cable0_cable_span_y * cable0_cable_span_y + cable0_cable_span_x * cable0_cable_span_x);
    const real cable0_cable_apart = cardan_lt(0.0, cable0_cable_distance);
    const real cable0_cable_inverse_distance = cardan_select(cable0_cable_apart, 1.0,
        0.0) / cardan_select(cable0_cable_apart, cable0_cable_distance, 1.0);
    const real cable0_cable_direction_x = cable0_cable_span_x * cable0_cable_inverse_distance;
    const real cable0_cable_direction_y = cable0_cable_span_y * cable0_cable_inverse_distance;
    const real cable0_cable_direction_z = height_q * cable0_cable_inverse_distance;
    const real cable0_force_on_bar0_a_x_part = cable0_EA * cardan_max(0.0,
        cable0_cable_distance / cable0_length - 1.0);
    const real cable0_force_on_bar0_a_x = cable0_cable_direction_x * cable0_force_on_bar0_a_x_part;
    const real cable0_force_on_bar0_a_y = cable0_cable_direction_y * cable0_force_on_bar0_a_x_part;
    const real twist_u_times_cable0_b_position_y = twist_u * cable0_b_position_y;
    const real twist_u_times_cable0_b_position_x = twist_u * cable0_b_position_x;
    const real cable0_force_on_bar0_a_x_part_2 = cable0_cable_direction_y * (twist_cos *
        twist_u_times_cable0_b_position_x - twist_sin * twist_u_times_cable0_b_position_y)
        - cable0_cable_direction_x * (twist_cos * twist_u_times_cable0_b_position_y
        + twist_sin * twist_u_times_cable0_b_position_x);
    const real cable0_force_on_bar0_a_x_part_3 = cardan_select(cardan_lt(0.0,
        cable0_force_on_bar0_a_x_part), cardan_max((height_u * cable0_cable_direction_z
        + cable0_force_on_bar0_a_x_part_2) / cable0_length * cable0_EA_times_damping,
        -cable0_force_on_bar0_a_x_part), 0.0);
    const real cable0_force_on_bar0_a_x_2 = cable0_cable_direction_x *
        cable0_force_on_bar0_a_x_part_3;
    const real cable0_force_on_bar0_a_y_2 = cable0_cable_direction_y *
        cable0_force_on_bar0_a_x_part_3;

    /* counter0: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter0_EA = w[3]; /* N */
    const wreal counter0_length = w[4]; /* m */
    const wreal counter0_b_position_x = w[35]; /* m */
    const wreal counter0_b_position_y = w[36]; /* m */
    const wreal counter0_EA_times_damping = w[44];
    const real counter0_cable_span_y = counter0_b_position_x * twist_sin
        + counter0_b_position_y * twist_cos;
    const real counter0_cable_span_x = counter0_b_position_x * twist_cos - bar0_a_position_x
        - counter0_b_position_y * twist_sin;
    const real counter0_cable_distance = cardan_sqrt(height_squared
        + counter0_cable_span_y * counter0_cable_span_y
        + counter0_cable_span_x * counter0_cable_span_x);
    const real counter0_cable_apart = cardan_lt(0.0, counter0_cable_distance);
    const real counter0_cable_inverse_distance = cardan_select(counter0_cable_apart, 1.0,
        0.0) / cardan_select(counter0_cable_apart, counter0_cable_distance, 1.0);
    const real counter0_cable_direction_x = counter0_cable_span_x * counter0_cable_inverse_distance;
    const real counter0_cable_direction_y = counter0_cable_span_y * counter0_cable_inverse_distance;
    const real counter0_cable_direction_z = height_q * counter0_cable_inverse_distance;
    const real counter0_force_on_bar0_a_x_part = counter0_EA * cardan_max(0.0,
        counter0_cable_distance / counter0_length - 1.0);
    const real counter0_force_on_bar0_a_x = counter0_cable_direction_x *
        counter0_force_on_bar0_a_x_part;
    const real counter0_force_on_bar0_a_y = counter0_cable_direction_y *
        counter0_force_on_bar0_a_x_part;
    const real twist_u_times_counter0_b_position_y = twist_u * counter0_b_position_y;
    const real twist_u_times_counter0_b_position_x = twist_u * counter0_b_position_x;
    const real counter0_force_on_bar0_a_x_part_2 = counter0_cable_direction_y * (twist_cos *
        twist_u_times_counter0_b_position_x - twist_sin * twist_u_times_counter0_b_position_y)
        - counter0_cable_direction_x * (twist_cos * twist_u_times_counter0_b_position_y
        + twist_sin * twist_u_times_counter0_b_position_x);
    const real counter0_force_on_bar0_a_x_part_3 = cardan_select(cardan_lt(0.0,
        counter0_force_on_bar0_a_x_part), cardan_max((height_u * counter0_cable_direction_z
        + counter0_force_on_bar0_a_x_part_2) / counter0_length * counter0_EA_times_damping,
        -counter0_force_on_bar0_a_x_part), 0.0);
    const real counter0_force_on_bar0_a_x_2 = counter0_cable_direction_x *
        counter0_force_on_bar0_a_x_part_3;
    const real counter0_force_on_bar0_a_y_2 = counter0_cable_direction_y *
        counter0_force_on_bar0_a_x_part_3;

    /* cable1 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable1_EA = w[5]; /* N */
    const wreal cable1_length = w[6]; /* m */
    const wreal cable1_b_position_x = w[37]; /* m */
    const wreal cable1_b_position_y = w[38]; /* m */
    const wreal cable1_EA_times_damping = w[45];
    const real cable1_cable_span_x = cable1_b_position_x * twist_cos - bar1_a_position_x
        - cable1_b_position_y * twist_sin;
    const real cable1_cable_span_y = cable1_b_position_x * twist_sin - bar1_a_position_y
        + cable1_b_position_y * twist_cos;
    const real cable1_cable_distance = cardan_sqrt(height_squared
        + cable1_cable_span_x * cable1_cable_span_x + cable1_cable_span_y * cable1_cable_span_y);
    const real cable1_cable_apart = cardan_lt(0.0, cable1_cable_distance);
    const real cable1_cable_inverse_distance = cardan_select(cable1_cable_apart, 1.0,
        0.0) / cardan_select(cable1_cable_apart, cable1_cable_distance, 1.0);
    const real cable1_cable_direction_x = cable1_cable_span_x * cable1_cable_inverse_distance;
    const real cable1_cable_direction_y = cable1_cable_span_y * cable1_cable_inverse_distance;
    const real cable1_cable_direction_z = height_q * cable1_cable_inverse_distance;
    const real cable1_force_on_bar1_a_x_part = cable1_EA * cardan_max(0.0,
        cable1_cable_distance / cable1_length - 1.0);
    const real cable1_force_on_bar1_a_x = cable1_cable_direction_x * cable1_force_on_bar1_a_x_part;
    const real cable1_force_on_bar1_a_y = cable1_cable_direction_y * cable1_force_on_bar1_a_x_part;
    const real twist_u_times_cable1_b_position_y = twist_u * cable1_b_position_y;
    const real twist_u_times_cable1_b_position_x = twist_u * cable1_b_position_x;
    const real cable1_force_on_bar1_a_x_part_2 = cable1_cable_direction_y * (twist_cos *
        twist_u_times_cable1_b_position_x - twist_sin * twist_u_times_cable1_b_position_y)
        - cable1_cable_direction_x * (twist_cos * twist_u_times_cable1_b_position_y
        + twist_sin * twist_u_times_cable1_b_position_x);
    const real cable1_force_on_bar1_a_x_part_3 = cardan_select(cardan_lt(0.0,
        cable1_force_on_bar1_a_x_part), cardan_max((height_u * cable1_cable_direction_z
        + cable1_force_on_bar1_a_x_part_2) / cable1_length * cable1_EA_times_damping,
        -cable1_force_on_bar1_a_x_part), 0.0);
    const real cable1_force_on_bar1_a_x_2 = cable1_cable_direction_x *
        cable1_force_on_bar1_a_x_part_3;
    const real cable1_force_on_bar1_a_y_2 = cable1_cable_direction_y *
        cable1_force_on_bar1_a_x_part_3;

    /* counter1: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter1_EA = w[7]; /* N */
    const wreal counter1_length = w[8]; /* m */
    const wreal counter1_b_position_x = w[39]; /* m */
    const wreal counter1_EA_times_damping = w[46];
    const real counter1_cable_span_x = counter1_b_position_x * twist_cos - bar1_a_position_x;
    const real counter1_cable_span_y = counter1_b_position_x * twist_sin - bar1_a_position_y;
    const real counter1_cable_distance = cardan_sqrt(height_squared
        + counter1_cable_span_x * counter1_cable_span_x
        + counter1_cable_span_y * counter1_cable_span_y);
    const real counter1_cable_apart = cardan_lt(0.0, counter1_cable_distance);
    const real counter1_cable_inverse_distance = cardan_select(counter1_cable_apart, 1.0,
        0.0) / cardan_select(counter1_cable_apart, counter1_cable_distance, 1.0);
    const real counter1_cable_direction_x = counter1_cable_span_x * counter1_cable_inverse_distance;
    const real counter1_cable_direction_y = counter1_cable_span_y * counter1_cable_inverse_distance;
    const real counter1_cable_direction_z = height_q * counter1_cable_inverse_distance;
    const real counter1_force_on_bar1_a_x_part = counter1_EA * cardan_max(0.0,
        counter1_cable_distance / counter1_length - 1.0);
    const real twist_u_times_counter1_b_position_x = twist_u * counter1_b_position_x;
    const real counter1_force_on_bar1_a_x_part_2 = (twist_cos * twist_u_times_counter1_b_position_x
        * counter1_cable_direction_y
        - twist_sin * twist_u_times_counter1_b_position_x * counter1_cable_direction_x
        + height_u * counter1_cable_direction_z) / counter1_length * counter1_EA_times_damping;
    const real counter1_force_on_bar1_a_x_part_3 = cardan_select(cardan_lt(0.0,
        counter1_force_on_bar1_a_x_part), cardan_max(counter1_force_on_bar1_a_x_part_2,
        -counter1_force_on_bar1_a_x_part), 0.0);
    const real top_n_z_part_2 = counter1_b_position_x * (counter1_cable_direction_x *
        counter1_force_on_bar1_a_x_part * twist_sin
        - counter1_cable_direction_y * counter1_force_on_bar1_a_x_part * twist_cos);
    const real top_n_z_part_3 = counter1_b_position_x * (counter1_cable_direction_x *
        counter1_force_on_bar1_a_x_part_3 * twist_sin
        - counter1_cable_direction_y * counter1_force_on_bar1_a_x_part_3 * twist_cos);

    /* cable2 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable2_EA = w[9]; /* N */
    const wreal cable2_length = w[10]; /* m */
    const wreal cable2_b_position_x = w[40]; /* m */
    const wreal cable2_EA_times_damping = w[47];
    const real cable2_cable_span_x = cable2_b_position_x * twist_cos - bar2_a_position_x;
    const real cable2_cable_span_y = cable2_b_position_x * twist_sin - bar2_a_position_y;
    const real cable2_cable_distance = cardan_sqrt(height_squared
        + cable2_cable_span_x * cable2_cable_span_x + cable2_cable_span_y * cable2_cable_span_y);
    const real cable2_cable_apart = cardan_lt(0.0, cable2_cable_distance);
    const real cable2_cable_inverse_distance = cardan_select(cable2_cable_apart, 1.0,
        0.0) / cardan_select(cable2_cable_apart, cable2_cable_distance, 1.0);
    const real cable2_cable_direction_x = cable2_cable_span_x * cable2_cable_inverse_distance;
    const real cable2_cable_direction_y = cable2_cable_span_y * cable2_cable_inverse_distance;
    const real cable2_cable_direction_z = height_q * cable2_cable_inverse_distance;
    const real cable2_force_on_bar2_a_x_part = cable2_EA * cardan_max(0.0,
        cable2_cable_distance / cable2_length - 1.0);
    const real twist_u_times_cable2_b_position_x = twist_u * cable2_b_position_x;
    const real cable2_force_on_bar2_a_x_part_2 = (twist_cos * twist_u_times_cable2_b_position_x *
        cable2_cable_direction_y
        - twist_sin * twist_u_times_cable2_b_position_x * cable2_cable_direction_x
        + height_u * cable2_cable_direction_z) / cable2_length * cable2_EA_times_damping;
    const real cable2_force_on_bar2_a_x_part_3 = cardan_select(cardan_lt(0.0,
        cable2_force_on_bar2_a_x_part), cardan_max(cable2_force_on_bar2_a_x_part_2,
        -cable2_force_on_bar2_a_x_part), 0.0);

    /* counter2: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal load = w[0]; /* N */
    const wreal counter2_EA = w[11]; /* N */
    const wreal counter2_length = w[12]; /* m */
    const wreal counter2_b_position_x = w[41]; /* m */
    const wreal counter2_b_position_y = w[42]; /* m */
    const wreal counter2_EA_times_damping = w[48];
    const real counter2_cable_span_x = counter2_b_position_x * twist_cos - bar2_a_position_x
        - counter2_b_position_y * twist_sin;
    const real counter2_cable_span_y = counter2_b_position_x * twist_sin - bar2_a_position_y
        + counter2_b_position_y * twist_cos;
    const real counter2_cable_distance = cardan_sqrt(height_squared
        + counter2_cable_span_x * counter2_cable_span_x
        + counter2_cable_span_y * counter2_cable_span_y);
    const real counter2_cable_apart = cardan_lt(0.0, counter2_cable_distance);
    const real counter2_cable_inverse_distance = cardan_select(counter2_cable_apart, 1.0,
        0.0) / cardan_select(counter2_cable_apart, counter2_cable_distance, 1.0);
    const real counter2_cable_direction_x = counter2_cable_span_x * counter2_cable_inverse_distance;
    const real counter2_cable_direction_y = counter2_cable_span_y * counter2_cable_inverse_distance;
    const real counter2_cable_direction_z = height_q * counter2_cable_inverse_distance;
    const real counter2_force_on_bar2_a_x_part = counter2_EA * cardan_max(0.0,
        counter2_cable_distance / counter2_length - 1.0);
    const real counter2_force_on_bar2_a_x = counter2_cable_direction_x *
        counter2_force_on_bar2_a_x_part;
    const real counter2_force_on_bar2_a_y = counter2_cable_direction_y *
        counter2_force_on_bar2_a_x_part;
    const real twist_u_times_counter2_b_position_y = twist_u * counter2_b_position_y;
    const real twist_u_times_counter2_b_position_x = twist_u * counter2_b_position_x;
    const real counter2_force_on_bar2_a_x_part_2 = counter2_cable_direction_y * (twist_cos *
        twist_u_times_counter2_b_position_x - twist_sin * twist_u_times_counter2_b_position_y)
        - counter2_cable_direction_x * (twist_cos * twist_u_times_counter2_b_position_y
        + twist_sin * twist_u_times_counter2_b_position_x);
    const real counter2_force_on_bar2_a_x_part_3 = cardan_select(cardan_lt(0.0,
        counter2_force_on_bar2_a_x_part), cardan_max((height_u * counter2_cable_direction_z
        + counter2_force_on_bar2_a_x_part_2) / counter2_length * counter2_EA_times_damping,
        -counter2_force_on_bar2_a_x_part), 0.0);
    const real counter2_force_on_bar2_a_x_2 = counter2_cable_direction_x *
        counter2_force_on_bar2_a_x_part_3;
    const real counter2_force_on_bar2_a_y_2 = counter2_cable_direction_y *
        counter2_force_on_bar2_a_x_part_3;
    const real top_f_z_part = cable0_cable_direction_z * cable0_force_on_bar0_a_x_part
        + counter0_cable_direction_z * counter0_force_on_bar0_a_x_part
        + counter2_cable_direction_z * counter2_force_on_bar2_a_x_part;
    const real top_f_z_part_2 = counter1_cable_direction_z * counter1_force_on_bar1_a_x_part
        + cable2_cable_direction_z * cable2_force_on_bar2_a_x_part + (load
        + bar0_spring_damper_direction_z * bar0_force_on_bar0_a_x_part
        + bar1_spring_damper_direction_z * bar1_force_on_bar1_a_x_part);
    const real top_f_z_part_3 = bar2_spring_damper_direction_z * bar2_force_on_bar2_a_x_part
        + cable1_cable_direction_z * cable1_force_on_bar1_a_x_part + top_f_z_part
        + (bar0_spring_damper_direction_z * bar0_force_on_bar0_a_x_part_2 + top_f_z_part_2);
    const real top_f_z_part_4 = bar1_spring_damper_direction_z * bar1_force_on_bar1_a_x_part_3
        + bar2_spring_damper_direction_z * bar2_force_on_bar2_a_x_part_3 + top_f_z_part_3
        + cable2_cable_direction_z * cable2_force_on_bar2_a_x_part_3
        + cable1_cable_direction_z * cable1_force_on_bar1_a_x_part_3;

    /* top: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real twist_udot = udot[1]; /* rad/s^2 */
    const wreal top_base_second_moment_xx_plus_base_second_moment_yy = w[49];
    const real top_f_z = counter0_cable_direction_z * counter0_force_on_bar0_a_x_part_3
        + counter1_cable_direction_z * counter1_force_on_bar1_a_x_part_3
        + (cable0_cable_direction_z * cable0_force_on_bar0_a_x_part_3
        + counter2_cable_direction_z * counter2_force_on_bar2_a_x_part_3) + top_f_z_part_4;
    const real top_n_z_part_4 = twist_udot * top_base_second_moment_xx_plus_base_second_moment_yy
        - bar0_b_position_x * (bar0_spring_damper_direction_x * bar0_force_on_bar0_a_x_part *
        twist_sin - bar0_spring_damper_direction_y * bar0_force_on_bar0_a_x_part * twist_cos);
    const real top_n_z_part_5 = cable0_b_position_x * (twist_sin * cable0_force_on_bar0_a_x
        - twist_cos * cable0_force_on_bar0_a_y)
        + cable0_b_position_y * (twist_cos * cable0_force_on_bar0_a_x
        + twist_sin * cable0_force_on_bar0_a_y);
    const real top_n_z_part_6 = counter0_b_position_x * (twist_sin * counter0_force_on_bar0_a_x
        - twist_cos * counter0_force_on_bar0_a_y)
        + counter0_b_position_y * (twist_cos * counter0_force_on_bar0_a_x
        + twist_sin * counter0_force_on_bar0_a_y);
    const real top_n_z_part_7 = bar1_b_position_y * (twist_cos * bar1_force_on_bar1_a_x
        + twist_sin * bar1_force_on_bar1_a_y)
        + bar2_b_position_x * (twist_sin * bar2_force_on_bar2_a_x
        - twist_cos * bar2_force_on_bar2_a_y);
    const real top_n_z_part_8 = cable1_b_position_y * (twist_cos * cable1_force_on_bar1_a_x
        + twist_sin * cable1_force_on_bar1_a_y)
        + counter2_b_position_x * (twist_sin * counter2_force_on_bar2_a_x
        - twist_cos * counter2_force_on_bar2_a_y);
    const real top_n_z_part_9 = top_n_z_part_2
        + cable2_b_position_x * (cable2_cable_direction_x * cable2_force_on_bar2_a_x_part *
        twist_sin - cable2_cable_direction_y * cable2_force_on_bar2_a_x_part * twist_cos)
        + top_n_z_part_6;
    const real top_n_z_part_10 = bar2_b_position_y * (twist_cos * bar2_force_on_bar2_a_x
        + twist_sin * bar2_force_on_bar2_a_y)
        + cable1_b_position_x * (twist_sin * cable1_force_on_bar1_a_x
        - twist_cos * cable1_force_on_bar1_a_y) + top_n_z_part_8;
    const real top_n_z_part_11 = counter2_b_position_y * (twist_cos * counter2_force_on_bar2_a_x
        + twist_sin * counter2_force_on_bar2_a_y) + top_n_z_part_5 + top_n_z_part_9
        + top_n_z_part_10;
    const real top_n_z_part_12 = bar1_b_position_x * (twist_sin * bar1_force_on_bar1_a_x_2
        - twist_cos * bar1_force_on_bar1_a_y_2)
        + bar1_b_position_y * (twist_cos * bar1_force_on_bar1_a_x_2
        + twist_sin * bar1_force_on_bar1_a_y_2);
    const real top_n_z_part_13 = bar2_b_position_x * (twist_sin * bar2_force_on_bar2_a_x_2
        - twist_cos * bar2_force_on_bar2_a_y_2)
        + bar2_b_position_y * (twist_cos * bar2_force_on_bar2_a_x_2
        + twist_sin * bar2_force_on_bar2_a_y_2);
    const real top_n_z_part_14 = top_n_z_part_4
        - bar1_b_position_x * (twist_sin * bar1_force_on_bar1_a_x
        - twist_cos * bar1_force_on_bar1_a_y) - top_n_z_part_7 - top_n_z_part - top_n_z_part_11
        - top_n_z_part_12 - top_n_z_part_13;
    const real top_n_z_part_15 = cable0_b_position_y * (twist_cos * cable0_force_on_bar0_a_x_2
        + twist_sin * cable0_force_on_bar0_a_y_2)
        + counter0_b_position_x * (twist_sin * counter0_force_on_bar0_a_x_2
        - twist_cos * counter0_force_on_bar0_a_y_2);
    const real top_n_z_part_16 = cable1_b_position_x * (twist_sin * cable1_force_on_bar1_a_x_2
        - twist_cos * cable1_force_on_bar1_a_y_2)
        + cable2_b_position_x * (cable2_cable_direction_x * cable2_force_on_bar2_a_x_part_3 *
        twist_sin - cable2_cable_direction_y * cable2_force_on_bar2_a_x_part_3 * twist_cos);
    const real top_n_z_part_17 = top_n_z_part_14
        - cable0_b_position_x * (twist_sin * cable0_force_on_bar0_a_x_2
        - twist_cos * cable0_force_on_bar0_a_y_2)
        - counter2_b_position_y * (twist_cos * counter2_force_on_bar2_a_x_2
        + twist_sin * counter2_force_on_bar2_a_y_2);
    const real top_n_z_part_18 = cable1_b_position_y * (twist_cos * cable1_force_on_bar1_a_x_2
        + twist_sin * cable1_force_on_bar1_a_y_2)
        + counter2_b_position_x * (twist_sin * counter2_force_on_bar2_a_x_2
        - twist_cos * counter2_force_on_bar2_a_y_2) + top_n_z_part_16;
    /* tau: twist.u.tau [N*m] */
    out[1] = top_n_z_part_17 - (counter0_b_position_y * (twist_cos * counter0_force_on_bar0_a_x_2
        + twist_sin * counter0_force_on_bar0_a_y_2) + top_n_z_part_3 + top_n_z_part_15)
        - top_n_z_part_18;

    /* carriage: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real height_udot = udot[0]; /* m/s^2 */
    const wreal top_mass = w[13]; /* kg */
    out[0] = top_f_z + top_mass * height_udot; /* tau: height.u.tau [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 50, 0, 2, 2, 0, 0, 0, 55, 0, 2, 0, 0, 0, 0, 0, 0, 0};
#endif
