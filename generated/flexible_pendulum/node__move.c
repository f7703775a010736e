/*
 * node__move
 * q moved by the increment du along the speeds, and its tangent
 * passes: reassociate
 *
 * Sizes: out 43, work 0, w 0
 * Operations per call: 69 = 34 mul, 18 add, 11 sub, 4 stumpff, 2 div
 * Operations of prepare: none
 *
 * Input q (7): generalized coordinates
 *   q[0]  node.qw
 *   q[1]  node.qx
 *   q[2]  node.qy
 *   q[3]  node.qz
 *   q[4]  node.px [m]
 *   q[5]  node.py [m]
 *   q[6]  node.pz [m]
 *
 * Input du (6): finite increment along the speeds
 *   du[0]  node.u.x.step [rad]
 *   du[1]  node.u.y.step [rad]
 *   du[2]  node.u.z.step [rad]
 *   du[3]  node.u.px.step [m]
 *   du[4]  node.u.py.step [m]
 *   du[5]  node.u.pz.step [m]
 *
 * Output q (7)
 *   out[0]  node.qw
 *   out[1]  node.qx
 *   out[2]  node.qy
 *   out[3]  node.qz
 *   out[4]  node.px [m]
 *   out[5]  node.py [m]
 *   out[6]  node.pz [m]
 *
 * Output T (6 x 6): out[7 ... 42], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_node__move(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* q moved by the increment du along the speeds, and its tangent */
CARDAN_API int node__move(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const du = in->du;
    (void)work;

    /* zeros among the results; what stands between them follows */
    memset(out + 10, 0, 32 * sizeof(real));

    /* common */
    const real node_u_x_step = du[0]; /* rad */
    const real node_u_y_step = du[1]; /* rad */
    const real node_u_z_step = du[2]; /* rad */
    const real node_u_px_step = du[3]; /* m */
    const real node_u_py_step = du[4]; /* m */
    const real node_u_pz_step = du[5]; /* m */
    const real node_qw = q[0];
    const real node_qx = q[1];
    const real node_qy = q[2];
    const real node_qz = q[3];
    const real node_px = q[4]; /* m */
    const real node_py = q[5]; /* m */
    const real node_pz = q[6]; /* m */
    const real node_u_x_step_squared = node_u_x_step * node_u_x_step;
    const real node_u_y_step_squared = node_u_y_step * node_u_y_step;
    const real node_u_z_step_squared = node_u_z_step * node_u_z_step;
    const real T_node_u_x_node_u_x_part = node_u_x_step_squared + node_u_y_step_squared
        + node_u_z_step_squared;
    const real T_node_u_x_node_u_y_part = cardan_stumpff(2, T_node_u_x_node_u_x_part);
    const real T_node_u_x_node_u_y_part_2 = node_u_z_step * T_node_u_x_node_u_y_part;
    const real T_node_u_x_node_u_z_part = node_u_y_step * T_node_u_x_node_u_y_part;
    const real T_node_u_y_node_u_z_part = node_u_x_step * T_node_u_x_node_u_y_part;
    const real T_node_u_x_node_u_x_part_2 = cardan_stumpff(3, T_node_u_x_node_u_x_part);
    const real T_node_u_x_node_u_y_part_3 = node_u_x_step * node_u_y_step *
        T_node_u_x_node_u_x_part_2;
    const real T_node_u_x_node_u_z_part_2 = node_u_x_step * node_u_z_step *
        T_node_u_x_node_u_x_part_2;
    const real T_node_u_y_node_u_z_part_2 = node_u_y_step * node_u_z_step *
        T_node_u_x_node_u_x_part_2;
    const real q_node_qw_part = T_node_u_x_node_u_x_part / 4.0;
    const real q_node_qw_part_2 = cardan_stumpff(1, q_node_qw_part) / 2.0;
    const real q_node_qw_part_3 = node_u_x_step * q_node_qw_part_2;
    const real q_node_qw_part_4 = node_u_y_step * q_node_qw_part_2;
    const real q_node_qw_part_5 = node_u_z_step * q_node_qw_part_2;
    const real q_node_qw_part_6 = cardan_stumpff(0, q_node_qw_part);
    /* T: node.u.x,node.u.x */
    out[7] = 1.0 + (node_u_x_step_squared - T_node_u_x_node_u_x_part) * T_node_u_x_node_u_x_part_2;
    out[8] = T_node_u_x_node_u_y_part_2 + T_node_u_x_node_u_y_part_3; /* T: node.u.x,node.u.y */
    out[9] = T_node_u_x_node_u_z_part_2 - T_node_u_x_node_u_z_part; /* T: node.u.x,node.u.z */
    out[13] = T_node_u_x_node_u_y_part_3 - T_node_u_x_node_u_y_part_2; /* T: node.u.y,node.u.x */
    /* T: node.u.y,node.u.y */
    out[14] = 1.0 + (node_u_y_step_squared - T_node_u_x_node_u_x_part) * T_node_u_x_node_u_x_part_2;
    out[15] = T_node_u_y_node_u_z_part + T_node_u_y_node_u_z_part_2; /* T: node.u.y,node.u.z */
    out[19] = T_node_u_x_node_u_z_part + T_node_u_x_node_u_z_part_2; /* T: node.u.z,node.u.x */
    out[20] = T_node_u_y_node_u_z_part_2 - T_node_u_y_node_u_z_part; /* T: node.u.z,node.u.y */
    /* T: node.u.z,node.u.z */
    out[21] = 1.0 + (node_u_z_step_squared - T_node_u_x_node_u_x_part) * T_node_u_x_node_u_x_part_2;
    /* q: node.qw */
    out[0] = node_qw * q_node_qw_part_6 - node_qx * q_node_qw_part_3
        - (node_qy * q_node_qw_part_4 + node_qz * q_node_qw_part_5);
    /* q: node.qx */
    out[1] = node_qw * q_node_qw_part_3 + node_qx * q_node_qw_part_6
        + (node_qy * q_node_qw_part_5 - node_qz * q_node_qw_part_4);
    /* q: node.qy */
    out[2] = node_qw * q_node_qw_part_4 + node_qy * q_node_qw_part_6
        + (node_qz * q_node_qw_part_3 - node_qx * q_node_qw_part_5);
    /* q: node.qz */
    out[3] = node_qw * q_node_qw_part_5 + node_qz * q_node_qw_part_6
        + (node_qx * q_node_qw_part_4 - node_qy * q_node_qw_part_3);
    out[4] = node_u_px_step + node_px; /* q: node.px [m] */
    out[5] = node_u_py_step + node_py; /* q: node.py [m] */
    out[6] = node_u_pz_step + node_pz; /* q: node.pz [m] */

    /* results that are numbers or inputs */
    out[28] = CARDAN_REAL(1.0); /* T: node.u.px,node.u.px */
    out[35] = CARDAN_REAL(1.0); /* T: node.u.py,node.u.py */
    out[42] = CARDAN_REAL(1.0); /* T: node.u.pz,node.u.pz */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int node__move_sizes[] = {43, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0};
#endif
