// Pinocchio's articulated-body algorithm in a loop over states, header-only: its fastest build.
// usage: pinocchio_aba MODEL COUNT REPEATS; MODEL as saved by Model.saveToText; prints seconds per
// call.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <vector>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/serialization.hpp>

int main(int argc, char **argv) {
  if (argc != 4) return 2;
  pinocchio::Model model;
  pinocchio::serialization::loadFromText(model, argv[1]);
  pinocchio::Data data(model);
  const int count = std::atoi(argv[2]), repeats = std::atoi(argv[3]);

  // random states inside a fixed box, the same for every repeat
  std::srand(9);
  std::vector<Eigen::VectorXd> q, v;
  for (int k = 0; k < count; ++k) {
    q.push_back(pinocchio::integrate(model, pinocchio::neutral(model),
                                     Eigen::VectorXd(1.5 * Eigen::VectorXd::Random(model.nv))));
    v.push_back(Eigen::VectorXd::Random(model.nv));
  }
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);

  double best = 1e9, sum = 0.0;
  for (int trial = 0; trial < 5; ++trial) {
    const auto start = std::chrono::steady_clock::now();
    for (int r = 0; r < repeats; ++r)
      for (int k = 0; k < count; ++k) sum += pinocchio::aba(model, data, q[k], v[k], rest)[0];
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    best = std::min(best, passed.count() / repeats / count);
  }
  std::cout << best << ' ' << sum << '\n';
  return 0;
}
