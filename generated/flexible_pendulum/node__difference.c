/*
 * node__difference
 * du that moves q0 to q1
 * passes: reassociate
 *
 * Sizes: out 6, work 0, w 0
 * Operations per call: 62 = 29 mul, 15 add, 8 sub, 3 select, 2 lt, 1 abs, 1 atan2, 1 div, 1 neg,
 *     1 sqrt
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
 * Input q0 (7): coordinates at the start of the increment
 *   q0[0]  node.qw.0
 *   q0[1]  node.qx.0
 *   q0[2]  node.qy.0
 *   q0[3]  node.qz.0
 *   q0[4]  node.px.0 [m]
 *   q0[5]  node.py.0 [m]
 *   q0[6]  node.pz.0 [m]
 *
 * Output du (6)
 *   out[0]  node.u.x.step [rad]
 *   out[1]  node.u.y.step [rad]
 *   out[2]  node.u.z.step [rad]
 *   out[3]  node.u.px.step [m]
 *   out[4]  node.u.py.step [m]
 *   out[5]  node.u.pz.step [m]
 */
#include "cardan.h"

CARDAN_API void prepare_node__difference(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* du that moves q0 to q1 */
CARDAN_API int node__difference(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const q0 = in->q0;
    (void)work;

    /* common */
    const real node_qw = q[0];
    const real node_qx = q[1];
    const real node_qy = q[2];
    const real node_qz = q[3];
    const real node_px = q[4]; /* m */
    const real node_py = q[5]; /* m */
    const real node_pz = q[6]; /* m */
    const real node_qw_0 = q0[0];
    const real node_qx_0 = q0[1];
    const real node_qy_0 = q0[2];
    const real node_qz_0 = q0[3];
    const real node_px_0 = q0[4]; /* m */
    const real node_py_0 = q0[5]; /* m */
    const real node_pz_0 = q0[6]; /* m */
    const real du_node_u_x_step_part = node_qw * node_qw_0 + node_qx * node_qx_0
        + (node_qy * node_qy_0 + node_qz * node_qz_0);
    const real du_node_u_x_step_part_2 = node_qx * node_qw_0 - node_qw * node_qx_0
        + (node_qy * node_qz_0 - node_qz * node_qy_0);
    const real du_node_u_x_step_part_3 = node_qy * node_qw_0 + node_qz * node_qx_0
        - (node_qw * node_qy_0 + node_qx * node_qz_0);
    const real du_node_u_x_step_part_4 = node_qz * node_qw_0 - node_qy * node_qx_0
        + (node_qx * node_qy_0 - node_qw * node_qz_0);
    const real du_node_u_x_step_part_5 = du_node_u_x_step_part_2 * du_node_u_x_step_part_2
        + du_node_u_x_step_part_3 * du_node_u_x_step_part_3
        + du_node_u_x_step_part_4 * du_node_u_x_step_part_4;
    const real du_node_u_x_step_part_6 = cardan_lt(du_node_u_x_step_part_5, 0.001);
    const real du_node_u_x_step_part_7 = cardan_sqrt(cardan_select(du_node_u_x_step_part_6, 1.0,
        du_node_u_x_step_part_5));
    const real du_node_u_x_step_part_8 = 1.0
        + du_node_u_x_step_part_5 * (du_node_u_x_step_part_5 * (du_node_u_x_step_part_5 *
        (du_node_u_x_step_part_5 * (du_node_u_x_step_part_5 * (0.017352764423076924 *
        du_node_u_x_step_part_5 + 0.022372159090909092) + 0.030381944444444444)
        + 0.044642857142857144) + 0.075) + 0.16666666666666666);
    const real du_node_u_x_step_part_9 = 2.0 * cardan_select(du_node_u_x_step_part_6,
        du_node_u_x_step_part_8, cardan_atan2(du_node_u_x_step_part_7,
        cardan_abs(du_node_u_x_step_part)) / du_node_u_x_step_part_7);
    const real du_node_u_x_step_part_10 = cardan_select(cardan_lt(du_node_u_x_step_part, 0.0),
        -du_node_u_x_step_part_9, du_node_u_x_step_part_9);
    out[0] = du_node_u_x_step_part_2 * du_node_u_x_step_part_10; /* du: node.u.x.step [rad] */
    out[1] = du_node_u_x_step_part_3 * du_node_u_x_step_part_10; /* du: node.u.y.step [rad] */
    out[2] = du_node_u_x_step_part_4 * du_node_u_x_step_part_10; /* du: node.u.z.step [rad] */
    out[3] = node_px - node_px_0; /* du: node.u.px.step [m] */
    out[4] = node_py - node_py_0; /* du: node.u.py.step [m] */
    out[5] = node_pz - node_pz_0; /* du: node.u.pz.step [m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int node__difference_sizes[] = {6, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0};
#endif
