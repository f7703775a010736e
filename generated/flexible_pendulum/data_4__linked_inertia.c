/*
 * data_4__linked_inertia of flexible_pendulum
 * passes: reassociate
 *
 * Sizes: out 10, work 0, w 7
 * Operations per call: none
 * Operations of prepare: 21 = 15 mul, 4 div, 2 add
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Output data (10): out[0 ... 9]
 */
#include "cardan.h"

CARDAN_API void prepare_data_4__linked_inertia(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bar: section */
    const wreal bar_section_width = p[1]; /* m */
    const wreal bar_section_height = p[2]; /* m */
    const wreal bar_material_E = p[3]; /* Pa */
    const wreal bar_material_nu = p[4];
    const wreal bar_material_rho = p[5]; /* kg/m^3 */
    const wreal one_plus_bar_material_nu = 1.0 + bar_material_nu;
    const wreal bar_section_width_times_section_height = bar_section_width * bar_section_height;
    const wreal data_part_6 = bar_section_height * bar_section_height *
        bar_section_width_times_section_height / 12.0;
    const wreal data_part_7 = bar_section_width * bar_section_width *
        bar_section_width_times_section_height / 12.0;
    const wreal data_part = 10.0 * one_plus_bar_material_nu / (12.0
        + 11.0 * bar_material_nu) * (bar_material_E / (2.0 * one_plus_bar_material_nu) *
        bar_section_width_times_section_height);
    const wreal data_part_2 = bar_material_E * data_part_6;
    const wreal data_part_3 = bar_material_E * data_part_7;
    const wreal bar_material_rho_times_section_width_times_section_height = bar_material_rho *
        bar_section_width_times_section_height;
    const wreal data_part_4 = bar_material_rho * data_part_6;
    const wreal data_part_5 = bar_material_rho * data_part_7;
    w[1] = data_part;
    w[2] = data_part_2;
    w[3] = data_part_3;
    w[4] = bar_material_rho_times_section_width_times_section_height;
    w[5] = data_part_4;
    w[6] = data_part_5;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

CARDAN_API int data_4__linked_inertia(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[4]); /* data[0] */
    out[1] = CARDAN_REAL(w[5]); /* data[1] */
    out[2] = CARDAN_REAL(w[6]); /* data[2] */
    out[3] = CARDAN_REAL(w[2]); /* data[3] */
    out[4] = CARDAN_REAL(w[3]); /* data[4] */
    out[5] = CARDAN_REAL(w[1]); /* data[5] */
    out[6] = CARDAN_REAL(w[1]); /* data[6] */
    out[7] = CARDAN_REAL(0.0); /* data[7] */
    out[8] = CARDAN_REAL(0.0); /* data[8] */
    out[9] = CARDAN_REAL(w[0]); /* data[9] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int data_4__linked_inertia_sizes[] = {10, 0, 7, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
