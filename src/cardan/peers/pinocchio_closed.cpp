// Pinocchio's constrained dynamics of trees with frames held together, in a loop over states.
#include "pinocchio.hpp"

#include <pinocchio/algorithm/constrained-dynamics.hpp>

typedef pin::RigidConstraintModelTpl<double, 0> Held;
typedef pin::RigidConstraintDataTpl<double, 0> HeldData;
typedef pin::ProximalSettingsTpl<double> Settings;

struct Closed {
  Model model;
  std::vector<Held, Eigen::aligned_allocator<Held>> held;
};

extern "C" void *peer_model(
  int n, const int *parents, const int *kinds, const double *axes, const double *axes2,
  const double *rotations, const double *positions, const double *mass, const double *com,
  const double *inertia, const double *gravity) {
  Closed *closed = new Closed;
  fill(
    &closed->model, n, parents, kinds, axes, axes2, rotations, positions, mass, com, inertia,
    gravity);
  return closed;
}

// Two frames held together, -1 being the ground; their axes too where `whole`.
extern "C" void peer_hold(
  void *self, int whole, const int *bodies, const double *rotations, const double *positions) {
  Closed *closed = static_cast<Closed *>(self);
  const pin::SE3 one{Matrix(rotations), Vector(positions)};
  const pin::SE3 other{Matrix(rotations + 9), Vector(positions + 3)};
  closed->held.push_back(Held(
    whole ? pin::CONTACT_6D : pin::CONTACT_3D, closed->model,
    static_cast<pin::JointIndex>(bodies[0] + 1), one,
    static_cast<pin::JointIndex>(bodies[1] + 1), other, pin::LOCAL));
}

extern "C" void peer_free(void *self) { delete static_cast<Closed *>(self); }

// the fewest of these steps that change nothing any more are made
static const int STEPS[] = {1, 2, 3, 5, 10, 30, 100};

// Seconds per call of forward dynamics. Independent rows need no proximal steps; dependent ones need
// a few, which its own criterion does not always see to be enough.
extern "C" double peer_loop(
  void *self, int, const double *q, const double *u, const double *x, double *out, int size,
  int count, int repeats) {
  const Closed &c = *static_cast<Closed *>(self);
  const Model &m = c.model;
  Data d(m);
  std::vector<HeldData, Eigen::aligned_allocator<HeldData>> datas;
  for (const Held &held : c.held) datas.push_back(HeldData(held));
  pin::initConstraintDynamics(m, d, c.held, datas);
  const auto Q = vectors(q, m.nq, count), V = vectors(u, m.nv, count), X = vectors(x, m.nv, count);
  Settings settings(1e-12, 1e-10, 100);
  const auto once = [&](int k) {
    return pin::constraintDynamics(m, d, Q[k], V[k], X[k], c.held, datas, settings)[0];
  };
  std::vector<Eigen::VectorXd> safe;
  for (int k = 0; k < count; ++k) {
    once(k);
    safe.push_back(d.ddq);
  }
  const auto agrees = [&](double tolerance) {
    for (int k = 0; k < count; ++k) {
      once(k);
      if (!((d.ddq - safe[k]).norm() <= tolerance * safe[k].norm())) return false;
    }
    return true;
  };
  settings = Settings(1e-12, 0.0, 1);
  if (!agrees(1e-9))
    for (const int steps : STEPS) {
      settings = Settings(1e-12, 1e-10, steps);
      if (agrees(1e-12)) break;
    }
  return timed(count, repeats, once, [&](int k) { Rows(out + k * size, m.nv, 1) = d.ddq; });
}
