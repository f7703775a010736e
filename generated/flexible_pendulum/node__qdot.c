/*
 * node__qdot
 * qdot = N(q) u + n(t, q)
 * passes: reassociate, schedule
 *
 * Sizes: out 7, work 0, w 0
 * Operations per call: 24 = 15 mul, 5 add, 3 sub, 1 neg
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
 * Input u (6): generalized speeds
 *   u[0]  node.u.x [rad/s]
 *   u[1]  node.u.y [rad/s]
 *   u[2]  node.u.z [rad/s]
 *   u[3]  node.u.px [m/s]
 *   u[4]  node.u.py [m/s]
 *   u[5]  node.u.pz [m/s]
 *
 * Output qdot (7)
 *   out[0]  node.qwdot [1/s]
 *   out[1]  node.qxdot [1/s]
 *   out[2]  node.qydot [1/s]
 *   out[3]  node.qzdot [1/s]
 *   out[4]  node.pxdot [m/s]
 *   out[5]  node.pydot [m/s]
 *   out[6]  node.pzdot [m/s]
 */
#include "cardan.h"

CARDAN_API void prepare_node__qdot(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* qdot = N(q) u + n(t, q) */
CARDAN_API int node__qdot(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    (void)work;

    /* node: qdot */
    const real node_qw = q[0];
    const real node_qx = q[1];
    const real node_qy = q[2];
    const real node_qz = q[3];
    const real node_u_x = u[0]; /* rad/s */
    const real node_u_y = u[1]; /* rad/s */
    const real node_u_z = u[2]; /* rad/s */
    const real half_node_u_x = 0.5 * node_u_x;
    const real half_node_u_y = 0.5 * node_u_y;
    const real half_node_u_z = 0.5 * node_u_z;
    /* qdot: node.qwdot [1/s] */
    out[0] = -(node_qx * half_node_u_x + node_qy * half_node_u_y + node_qz * half_node_u_z);
    /* qdot: node.qxdot [1/s] */
    out[1] = node_qw * half_node_u_x - node_qz * half_node_u_y + node_qy * half_node_u_z;
    /* qdot: node.qydot [1/s] */
    out[2] = node_qz * half_node_u_x + node_qw * half_node_u_y - node_qx * half_node_u_z;
    /* qdot: node.qzdot [1/s] */
    out[3] = node_qw * half_node_u_z - node_qy * half_node_u_x + node_qx * half_node_u_y;

    /* results that are numbers or inputs */
    out[4] = u[3]; /* qdot: node.pxdot [m/s] */
    out[5] = u[4]; /* qdot: node.pydot [m/s] */
    out[6] = u[5]; /* qdot: node.pzdot [m/s] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int node__qdot_sizes[] = {7, 0, 0, 0, 7, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
