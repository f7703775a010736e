// Pinocchio's algorithms for trees in a loop over states.
#include "pinocchio.hpp"

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

extern "C" void *peer_model(
  int n, const int *parents, const int *kinds, const double *axes, const double *axes2,
  const double *rotations, const double *positions, const double *mass, const double *com,
  const double *inertia, const double *gravity) {
  Model *model = new Model;
  fill(
    model, n, parents, kinds, axes, axes2, rotations, positions, mass, com, inertia, gravity);
  return model;
}

extern "C" void peer_free(void *model) { delete static_cast<Model *>(model); }

// one function at one state; its results stay in the data
static double once(
  const Model &m, Data &d, int function, const Eigen::VectorXd &q, const Eigen::VectorXd &v,
  const Eigen::VectorXd &x) {
  switch (function) {
  case FORWARD: return pin::aba(m, d, q, v, x)[0];
  case INVERSE: return pin::rnea(m, d, q, v, x)[0];
  case MASS: return pin::crba(m, d, q)(0, 0);
  default: pin::computeABADerivatives(m, d, q, v, x); return d.ddq_dq(0, 0);
  }
}

static void copy(const Model &m, const Data &d, int function, double *out) {
  const int n = m.nv;
  if (function == FORWARD) Rows(out, n, 1) = d.ddq;
  if (function == INVERSE) Rows(out, n, 1) = d.tau;
  if (function == MASS) Rows(out, n, n) = d.M.template selfadjointView<Eigen::Upper>();
  if (function == DERIVATIVES) {
    Rows(out, n, n) = d.ddq_dq;
    Rows(out + n * n, n, n) = d.ddq_dv;
  }
}

// Seconds per call; results of every state in rows of `size` numbers.
extern "C" double peer_loop(
  void *self, int function, const double *q, const double *u, const double *x, double *out,
  int size, int count, int repeats) {
  const Model &m = *static_cast<Model *>(self);
  Data d(m);
  const auto Q = vectors(q, m.nq, count), V = vectors(u, m.nv, count), X = vectors(x, m.nv, count);
  return timed(
    count, repeats, [&](int k) { return once(m, d, function, Q[k], V[k], X[k]); },
    [&](int k) { copy(m, d, function, out + k * size); });
}
