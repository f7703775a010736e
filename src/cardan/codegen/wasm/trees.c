/* Kernels over a tree, which generated functions of long ones call.
 *
 * Part of cardan. Pages in which a model runs need none of them.
 */
#include "tree_derivatives.h"
#include "tree_mass.h"

#define EXPORT(name) __attribute__((export_name(#name)))

EXPORT(cardan_tree_mass)
int exported_tree_mass(int bodies, int speeds, int depth, int serial, int rotors, int start,
                       int scratch, const int *table, const cardan_in *in, double *out, double *work)
{
    return cardan_tree_mass(bodies, speeds, depth, serial, rotors, start, scratch, table, in, out,
                            work);
}

EXPORT(cardan_tree_derivatives)
int exported_tree_derivatives(int bodies, int speeds, int depth, int room, int serial, int branches,
                              int forward, int columns, int outputs, int changes, int rotors,
                              int start, int scratch, const int *table, const cardan_in *in,
                              double *out, double *work)
{
    return cardan_tree_derivatives(bodies, speeds, depth, room, serial, branches, forward, columns,
                                   outputs, changes, rotors, start, scratch, table, in, out, work);
}
