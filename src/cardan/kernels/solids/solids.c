/* Matrices of a solid of linear elastic finite elements.
 *
 * Part of cardan. Caller owns all memory; see solids.h for the arrays and sources.
 */
#include "solids.h"

enum { AXES = 3, STRESSES = 6 };

/* Gradients of the shape functions at a point of a cell; returns the volume per reference volume.
 *
 * The gradients solve J^T g = slope, J the matrix of the map from the reference cell. Nothing is
 * written where J is singular or turns the cell inside out.
 */
static double gradients(const cardan_solid *solid, ptrdiff_t c, ptrdiff_t point)
{
    const ptrdiff_t n = solid->nodes;
    const int32_t *cell = solid->cell + c * n;
    const double *slope = solid->slope + point * n * AXES;
    double j[AXES][AXES] = {{0.0}}, adjugate[AXES][AXES];

    /* J[r][k] = d x_r / d xi_k */
    for (ptrdiff_t a = 0; a < n; a++) {
        const double *x = solid->position + (ptrdiff_t)cell[a] * AXES;

        for (int r = 0; r < AXES; r++)
            for (int k = 0; k < AXES; k++)
                j[r][k] += x[r] * slope[a * AXES + k];
    }
    for (int k = 0; k < AXES; k++)
        for (int r = 0; r < AXES; r++) {
            const int k1 = (k + 1) % AXES, k2 = (k + 2) % AXES;
            const int r1 = (r + 1) % AXES, r2 = (r + 2) % AXES;

            adjugate[k][r] = j[r1][k1] * j[r2][k2] - j[r1][k2] * j[r2][k1];
        }
    const double volume =
        j[0][0] * adjugate[0][0] + j[1][0] * adjugate[0][1] + j[2][0] * adjugate[0][2];

    if (!(volume > 0.0))
        return 0.0;
    /* chain rule: g_r = sum over k of slope_k d xi_k / d x_r */
    for (ptrdiff_t a = 0; a < n; a++)
        for (int r = 0; r < AXES; r++) {
            double sum = 0.0;

            for (int k = 0; k < AXES; k++)
                sum += slope[a * AXES + k] * adjugate[k][r];
            solid->gradient[a * AXES + r] = sum / volume;
        }
    return volume;
}

/* Place of node b in row a; -1 if it is not there. The list of a row is ascending. */
static ptrdiff_t place(const cardan_solid *solid, ptrdiff_t a, int32_t b)
{
    ptrdiff_t low = solid->first[a], high = solid->first[a + 1];

    while (low < high) {
        const ptrdiff_t middle = low + (high - low) / 2;

        if (solid->column[middle] < b)
            low = middle + 1;
        else
            high = middle;
    }
    return low < solid->first[a + 1] && solid->column[low] == b ? low : -1;
}

/* Elasticity times the strains of unit displacements of a node with the gradient g: out is 6 x 3 */
static void stress_of_unit(const double *d, const double *g, double *out)
{
    for (int k = 0; k < STRESSES; k++) {
        const double *e = d + k * STRESSES;

        out[k * AXES] = e[0] * g[0] + e[4] * g[2] + e[5] * g[1];
        out[k * AXES + 1] = e[1] * g[1] + e[3] * g[2] + e[5] * g[0];
        out[k * AXES + 2] = e[2] * g[2] + e[3] * g[1] + e[4] * g[0];
    }
}

/* Add the matrix of a cell, whose part above the diagonal is in `block`, to the rows of the mesh.
 *
 * Blocks are size x size; mirrored numbers are equal to the last bit.
 */
static int scatter(cardan_solid *solid, ptrdiff_t c, int size, double *values)
{
    const ptrdiff_t n = solid->nodes, area = (ptrdiff_t)size * size;
    const int32_t *cell = solid->cell + c * n;

    for (ptrdiff_t a = 0; a < n; a++)
        for (ptrdiff_t b = a; b < n; b++) {
            const double *block = solid->block + (a * n + b) * area;
            const ptrdiff_t ab = place(solid, cell[a], cell[b]);
            const ptrdiff_t ba = place(solid, cell[b], cell[a]);

            if (ab < 0 || ba < 0) {
                solid->culprit = c;
                return CARDAN_SOLID_PATTERN;
            }
            for (int r = 0; r < size; r++)
                for (int k = 0; k < size; k++) {
                    const int upper = a == b && k < r;
                    const double entry = upper ? block[k * size + r] : block[r * size + k];

                    values[ab * area + r * size + k] += entry;
                    if (a != b)
                        values[ba * area + k * size + r] += entry;
                }
        }
    return 0;
}

/* Start a cell: its matrix above the diagonal is zero. */
static void cleared(const cardan_solid *solid, ptrdiff_t area)
{
    memset(solid->block, 0, sizeof(double) * (size_t)(solid->nodes * solid->nodes * area));
}

/* A cell whose map from the reference cell folds over. */
static int folded(cardan_solid *solid, ptrdiff_t c)
{
    solid->culprit = c;
    return CARDAN_SOLID_FOLDED;
}

int cardan_solid_stiffness(cardan_solid *solid, double *values)
{
    const ptrdiff_t n = solid->nodes, area = AXES * AXES;
    int status = 0;

    for (ptrdiff_t c = 0; c < solid->cells && status == 0; c++) {
        cleared(solid, area);
        for (ptrdiff_t point = 0; point < solid->points; point++) {
            const double volume = gradients(solid, c, point) * solid->weight[point];

            if (!(volume > 0.0))
                return folded(solid, c);
            for (ptrdiff_t a = 0; a < n; a++)
                stress_of_unit(solid->elasticity, solid->gradient + a * AXES,
                               solid->product + a * AXES * STRESSES);
            /* B_a^T D B_b for a <= b; B has three numbers in each column */
            for (ptrdiff_t a = 0; a < n; a++) {
                const double x = volume * solid->gradient[a * AXES];
                const double y = volume * solid->gradient[a * AXES + 1];
                const double z = volume * solid->gradient[a * AXES + 2];

                for (ptrdiff_t b = a; b < n; b++) {
                    const double *s = solid->product + b * AXES * STRESSES;
                    double *block = solid->block + (a * n + b) * area;

                    for (int k = 0; k < AXES; k++) {
                        block[k] += x * s[k] + z * s[12 + k] + y * s[15 + k];
                        block[3 + k] += y * s[3 + k] + z * s[9 + k] + x * s[15 + k];
                        block[6 + k] += z * s[6 + k] + y * s[9 + k] + x * s[12 + k];
                    }
                }
            }
        }
        status = scatter(solid, c, AXES, values);
    }
    return status;
}

int cardan_solid_mass(cardan_solid *solid, double *values, int lumped)
{
    const ptrdiff_t n = solid->nodes;
    int status = 0;

    for (ptrdiff_t c = 0; c < solid->cells && status == 0; c++) {
        double total = 0.0, diagonal = 0.0;

        cleared(solid, 1);
        for (ptrdiff_t point = 0; point < solid->points; point++) {
            const double *shape = solid->shape + point * n;
            const double mass =
                gradients(solid, c, point) * solid->weight[point] * solid->density;

            if (!(mass >= 0.0) || (mass == 0.0 && solid->density > 0.0))
                return folded(solid, c);
            total += mass;
            for (ptrdiff_t a = 0; a < n; a++)
                for (ptrdiff_t b = a; b < n; b++)
                    solid->block[a * n + b] += mass * shape[a] * shape[b];
        }
        if (lumped) {
            /* the mass of the cell in proportion to the diagonal, which is positive */
            for (ptrdiff_t a = 0; a < n; a++)
                diagonal += solid->block[a * n + a];
            for (ptrdiff_t a = 0; a < n; a++)
                for (ptrdiff_t b = a; b < n; b++)
                    solid->block[a * n + b] *= a == b && diagonal > 0.0 ? total / diagonal : 0.0;
        }
        status = scatter(solid, c, 1, values);
    }
    return status;
}

int cardan_solid_geometric(cardan_solid *solid, const double *stress, double *values)
{
    const ptrdiff_t n = solid->nodes;
    int status = 0;

    for (ptrdiff_t c = 0; c < solid->cells && status == 0; c++) {
        cleared(solid, 1);
        for (ptrdiff_t point = 0; point < solid->points; point++) {
            const double *s = stress + (c * solid->points + point) * STRESSES;
            const double volume = gradients(solid, c, point) * solid->weight[point];

            if (!(volume > 0.0))
                return folded(solid, c);
            /* grad N_a . stress . grad N_b */
            for (ptrdiff_t a = 0; a < n; a++) {
                const double *g = solid->gradient + a * AXES;
                const double x = volume * (s[0] * g[0] + s[5] * g[1] + s[4] * g[2]);
                const double y = volume * (s[5] * g[0] + s[1] * g[1] + s[3] * g[2]);
                const double z = volume * (s[4] * g[0] + s[3] * g[1] + s[2] * g[2]);

                for (ptrdiff_t b = a; b < n; b++) {
                    const double *h = solid->gradient + b * AXES;

                    solid->block[a * n + b] += x * h[0] + y * h[1] + z * h[2];
                }
            }
        }
        status = scatter(solid, c, 1, values);
    }
    return status;
}

int cardan_solid_stress(cardan_solid *solid, const double *displacement, double *stress)
{
    const ptrdiff_t n = solid->nodes;

    for (ptrdiff_t c = 0; c < solid->cells; c++)
        for (ptrdiff_t point = 0; point < solid->points; point++) {
            double strain[STRESSES] = {0.0};
            double *out = stress + (c * solid->points + point) * STRESSES;

            if (!(gradients(solid, c, point) > 0.0))
                return folded(solid, c);
            for (ptrdiff_t a = 0; a < n; a++) {
                const double *g = solid->gradient + a * AXES;
                const double *u = displacement + (ptrdiff_t)solid->cell[c * n + a] * AXES;

                for (int k = 0; k < AXES; k++) {
                    const int k1 = (k + 1) % AXES, k2 = (k + 2) % AXES;

                    /* the shear strain with the number of the axis that is normal to its plane */
                    strain[k] += g[k] * u[k];
                    strain[AXES + k] += g[k1] * u[k2] + g[k2] * u[k1];
                }
            }
            for (int r = 0; r < STRESSES; r++) {
                out[r] = 0.0;
                for (int k = 0; k < STRESSES; k++)
                    out[r] += solid->elasticity[r * STRESSES + k] * strain[k];
            }
        }
    return 0;
}

int cardan_solid_force(cardan_solid *solid, const double *stress, double *force)
{
    const ptrdiff_t n = solid->nodes;

    for (ptrdiff_t c = 0; c < solid->cells; c++)
        for (ptrdiff_t point = 0; point < solid->points; point++) {
            const double *s = stress + (c * solid->points + point) * STRESSES;
            const double volume = gradients(solid, c, point) * solid->weight[point];

            if (!(volume > 0.0))
                return folded(solid, c);
            /* B_a^T times the stress */
            for (ptrdiff_t a = 0; a < n; a++) {
                const double *g = solid->gradient + a * AXES;
                double *f = force + (ptrdiff_t)solid->cell[c * n + a] * AXES;

                f[0] += volume * (s[0] * g[0] + s[5] * g[1] + s[4] * g[2]);
                f[1] += volume * (s[5] * g[0] + s[1] * g[1] + s[3] * g[2]);
                f[2] += volume * (s[4] * g[0] + s[3] * g[1] + s[2] * g[2]);
            }
        }
    return 0;
}

int cardan_solid_recovery(cardan_solid *solid, const double *extrapolation, const int32_t *row,
                          const double *share, double *values)
{
    const ptrdiff_t n = solid->nodes, area = STRESSES * AXES;

    for (ptrdiff_t c = 0; c < solid->cells; c++) {
        const int32_t *cell = solid->cell + c * n;
        int listed = 0;

        for (ptrdiff_t a = 0; a < n; a++)
            listed |= row[cell[a]] >= 0;
        for (ptrdiff_t point = 0; listed && point < solid->points; point++) {
            if (!(gradients(solid, c, point) > 0.0))
                return folded(solid, c);
            for (ptrdiff_t b = 0; b < n; b++)
                stress_of_unit(solid->elasticity, solid->gradient + b * AXES,
                               solid->product + b * area);
            /* the share of this point in the stress at each node with a row */
            for (ptrdiff_t a = 0; a < n; a++) {
                const double weight = extrapolation[a * solid->points + point] * share[cell[a]];

                for (ptrdiff_t b = 0; row[cell[a]] >= 0 && b < n; b++) {
                    const double *s = solid->product + b * area;
                    const ptrdiff_t at = place(solid, row[cell[a]], cell[b]);

                    if (at < 0) {
                        solid->culprit = c;
                        return CARDAN_SOLID_PATTERN;
                    }
                    for (ptrdiff_t k = 0; k < area; k++)
                        values[at * area + k] += weight * s[k];
                }
            }
        }
    }
    return 0;
}
