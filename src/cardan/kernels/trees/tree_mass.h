/*
 * tree_mass.h: the mass matrix of a tree by composite bodies.
 *
 * M_jk = S_j . I_k S_k for j on the way from k to the ground, with the inertia I_k of all bodies that
 * speed k moves: one product of a row with a path for every speed.
 * Source: M. Walker, D. Orin, J. Dyn. Sys. Meas. Control 104 (1982).
 */
#ifndef CARDAN_TREE_MASS_H
#define CARDAN_TREE_MASS_H

#include "tree.h"

/* numbers of a body here, and of a speed behind those of its body: the column S */
#define CARDAN_MASS_BODY 10
#define CARDAN_MASS_SPEED 6
#define CARDAN_MASS_STRIDE 16

/* rows of M with the inertia of rotors: entries of (speed, speed, place of the number) */
CARDAN_INLINE void cardan_tree_rotors(const cardan_tree *tree, int rotors, const int *rotor,
                                      const real *numbers, real *rows)
{
    for (int n = 0; n < rotors; ++n) {
        const int *const at = rotor + 3 * n;
        const int level = tree->speed[CARDAN_SPEED_ROW * at[1] + CARDAN_LEVEL];
        rows[tree->speed[CARDAN_SPEED_ROW * at[0] + CARDAN_PLACE] + level] += numbers[at[2]];
    }
}

/*
 * M (speeds, speeds) to out.
 *
 * serial: as of a tree. rotors: rows of (speed, speed, place) that
 * add to M. The numbers of the bodies begin at work + start, scratch at work + scratch.
 */
CARDAN_APART int cardan_tree_mass(int bodies, int speeds, int depth, int serial, int rotors,
                                  int start, int scratch, const int *table, const cardan_in *in,
                                  real *out, real *work)
{
    const cardan_tree tree = cardan_tree_of(bodies, speeds, depth, serial, table);
    const int *const rotor = tree.speed + CARDAN_SPEED_ROW * speeds;
    const real *const numbers = work + start;
    real *const sums = work + scratch, *const path = sums + CARDAN_MASS_STRIDE * bodies;
    real *const rows = path + 6 * depth;

    (void)in;
    cardan_tree_sums(&tree, CARDAN_MASS_BODY, CARDAN_MASS_STRIDE, numbers, sums);
    cardan_clear(6 * depth, path);
    for (int i = 0; i < bodies; ++i) {
        const int *const body = tree.body + CARDAN_BODY_ROW * i;
        const real *column = numbers + body[CARDAN_NUMBERS] + CARDAN_MASS_BODY;
        for (int k = body[CARDAN_FIRST]; k < body[CARDAN_FIRST] + body[CARDAN_COUNT]; ++k) {
            const int *const speed = tree.speed + CARDAN_SPEED_ROW * k;
            real momentum[6];
            cardan_path_enter(&tree, k, 6, column, path);
            cardan_momentum(sums + CARDAN_MASS_STRIDE * i, column, momentum);
            cardan_path_six(speed[CARDAN_LEVEL] + 1, depth, momentum, path,
                            rows + speed[CARDAN_PLACE]);
            column += CARDAN_MASS_SPEED;
        }
    }
    cardan_tree_rotors(&tree, rotors, rotor, numbers, rows);
    cardan_tree_square(&tree, rows, out);
    return CARDAN_OK;
}

#endif
