/*
 * data_2__hellinger_reissner of flexible_pendulum
 * passes: reassociate
 *
 * Sizes: out 12, work 0, w 5
 * Operations per call: none
 * Operations of prepare: 52 = 24 mul, 11 div, 7 add, 4 exp, 4 sub, 1 max, 1 min
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Output data (12): out[0 ... 11]
 */
#include "cardan.h"

CARDAN_API void prepare_data_2__hellinger_reissner(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bar: section */
    const wreal bar_section_width = p[1]; /* m */
    const wreal bar_section_height = p[2]; /* m */
    const wreal bar_material_E = p[3]; /* Pa */
    const wreal bar_material_nu = p[4];
    const wreal one_plus_bar_material_nu = 1.0 + bar_material_nu;
    const wreal data_part_5 = bar_material_E / (2.0 * one_plus_bar_material_nu);
    const wreal bar_section_width_times_section_height = bar_section_width * bar_section_height;
    const wreal max_of_bar_section_width_and_bar_section_height = cardan_max(bar_section_width,
        bar_section_height);
    const wreal min_of_bar_section_width_and_bar_section_height = cardan_min(bar_section_width,
        bar_section_height);
    const wreal data_part_6 = 3.141592653589793 * max_of_bar_section_width_and_bar_section_height /
        min_of_bar_section_width_and_bar_section_height;
    const wreal data_part_7 = min_of_bar_section_width_and_bar_section_height *
        min_of_bar_section_width_and_bar_section_height *
        min_of_bar_section_width_and_bar_section_height *
        max_of_bar_section_width_and_bar_section_height / 3.0;
    const wreal data_part_8 = 1.0045237627951382 - 2.0 / (1.0 + cardan_exp(data_part_6))
        - 0.00011899803653239721 / (1.0 + cardan_exp(7.0 * data_part_6))
        - (0.00823045267489712 / (1.0 + cardan_exp(3.0 * data_part_6)) + 0.00064 / (1.0
        + cardan_exp(5.0 * data_part_6)));
    const wreal bar_material_E_times_section_width_times_section_height = bar_material_E *
        bar_section_width_times_section_height;
    const wreal data_part = 10.0 * one_plus_bar_material_nu / (12.0
        + 11.0 * bar_material_nu) * (data_part_5 * bar_section_width_times_section_height);
    const wreal data_part_2 = data_part_7 * (1.0
        - 0.6274106194662501 * min_of_bar_section_width_and_bar_section_height /
        max_of_bar_section_width_and_bar_section_height * data_part_8) * data_part_5;
    const wreal data_part_3 = bar_section_height * bar_section_height *
        bar_section_width_times_section_height / 12.0 * bar_material_E;
    const wreal data_part_4 = bar_section_width * bar_section_width *
        bar_section_width_times_section_height / 12.0 * bar_material_E;
    w[0] = bar_material_E_times_section_width_times_section_height;
    w[1] = data_part;
    w[2] = data_part_2;
    w[3] = data_part_3;
    w[4] = data_part_4;
}

#include "lanes.h"

CARDAN_API int data_2__hellinger_reissner(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[2]); /* data[0] */
    out[1] = CARDAN_REAL(w[3]); /* data[1] */
    out[2] = CARDAN_REAL(w[4]); /* data[2] */
    out[3] = CARDAN_REAL(w[0]); /* data[3] */
    out[4] = CARDAN_REAL(w[1]); /* data[4] */
    out[5] = CARDAN_REAL(w[1]); /* data[5] */
    out[6] = CARDAN_REAL(0.0); /* data[6] */
    out[7] = CARDAN_REAL(0.0); /* data[7] */
    out[8] = CARDAN_REAL(0.0); /* data[8] */
    out[9] = CARDAN_REAL(0.0); /* data[9] */
    out[10] = CARDAN_REAL(0.0); /* data[10] */
    out[11] = CARDAN_REAL(0.0); /* data[11] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int data_2__hellinger_reissner_sizes[] = {12, 0, 5, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
