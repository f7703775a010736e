// Trees of Pinocchio from arrays, and the loop that is timed, header-only: its fastest build.
//
// Only the joints that a benchmark hands over are in the collection, which compiles in a part of
// the time of all joints and runs no slower.
#include <string>
#include <time.h>

#include <pinocchio/multibody.hpp>

namespace pin = pinocchio;

template<typename S, int O>
struct Joints {
  typedef S Scalar;
  static constexpr int Options = O;
  typedef pin::JointModelRevoluteTpl<S, O, 0> RX;
  typedef pin::JointModelRevoluteTpl<S, O, 1> RY;
  typedef pin::JointModelRevoluteTpl<S, O, 2> RZ;
  typedef pin::JointModelRevoluteUnalignedTpl<S, O> R;
  typedef pin::JointModelPrismaticTpl<S, O, 0> PX;
  typedef pin::JointModelPrismaticTpl<S, O, 1> PY;
  typedef pin::JointModelPrismaticTpl<S, O, 2> PZ;
  typedef pin::JointModelPrismaticUnalignedTpl<S, O> P;
  typedef pin::JointModelSphericalTpl<S, O> Spherical;
  typedef pin::JointModelFreeFlyerTpl<S, O> Free;
  typedef pin::JointModelUniversalTpl<S, O> Universal;
  // the headers speak of these two by name
  typedef pin::JointModelMimicTpl<S, O, ::Joints> JointModelMimic;
  typedef pin::JointDataMimicTpl<S, O, ::Joints> JointDataMimic;
  typedef boost::variant<
    RX, RY, RZ, R, PX, PY, PZ, P, Spherical, Free, Universal,
    boost::recursive_wrapper<JointModelMimic>>
    JointModelVariant;
  typedef boost::variant<
    typename RX::JointDataDerived, typename RY::JointDataDerived, typename RZ::JointDataDerived,
    typename R::JointDataDerived, typename PX::JointDataDerived, typename PY::JointDataDerived,
    typename PZ::JointDataDerived, typename P::JointDataDerived,
    typename Spherical::JointDataDerived, typename Free::JointDataDerived,
    typename Universal::JointDataDerived,
    boost::recursive_wrapper<JointDataMimic>>
    JointDataVariant;
};

typedef Joints<double, 0> J;
typedef pin::ModelTpl<double, 0, Joints> Model;
typedef pin::DataTpl<double, 0, Joints> Data;
typedef Eigen::Map<const Eigen::Vector3d> Vector;
typedef Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> Matrix;
typedef Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> Rows;

enum { REVOLUTE, PRISMATIC, SPHERICAL, FREE, UNIVERSAL };
enum { FORWARD, INVERSE, MASS, DERIVATIVES };

// a joint about or along a coordinate axis has a type of its own
static pin::JointModelTpl<double, 0, Joints> joint(int kind, const double *a, const double *b) {
  if (kind == FREE) return J::Free();
  if (kind == UNIVERSAL) return J::Universal(Eigen::Vector3d(Vector(a)), Eigen::Vector3d(Vector(b)));
  if (kind == SPHERICAL) return J::Spherical();
  const int along = a[0] == 1 ? 0 : a[1] == 1 ? 1 : a[2] == 1 ? 2 : 3;
  const bool turns = kind == REVOLUTE;
  if (along == 0) return turns ? pin::JointModelTpl<double, 0, Joints>(J::RX()) : J::PX();
  if (along == 1) return turns ? pin::JointModelTpl<double, 0, Joints>(J::RY()) : J::PY();
  if (along == 2) return turns ? pin::JointModelTpl<double, 0, Joints>(J::RZ()) : J::PZ();
  if (turns) return J::R(Eigen::Vector3d(Vector(a)));
  return J::P(Eigen::Vector3d(Vector(a)));
}

static void fill(
  Model *model, int n, const int *parents, const int *kinds, const double *axes,
  const double *axes2, const double *rotations, const double *positions, const double *mass,
  const double *com, const double *inertia, const double *gravity) {
  model->gravity.linear() = Vector(gravity);
  for (int i = 0; i < n; ++i) {
    const pin::SE3 place(Matrix(rotations + 9 * i), Vector(positions + 3 * i));
    const pin::Inertia own(mass[i], Vector(com + 3 * i), Matrix(inertia + 9 * i));
    const auto id = model->addJoint(
      static_cast<pin::JointIndex>(parents[i] + 1), joint(kinds[i], axes + 3 * i, axes2 + 3 * i), place,
      "joint" + std::to_string(i));
    model->appendBodyToJoint(id, own, pin::SE3::Identity());
  }
}

// Seconds per call of `once(k)` at every state k; `copy(k)` stores the results of the first round.
template<typename Once, typename Copy>
static double timed(int count, int repeats, const Once &once, const Copy &copy) {
  for (int k = 0; k < count; ++k) {
    once(k);
    copy(k);
  }
  volatile double sink = 0.0;
  timespec start, stop;
  clock_gettime(CLOCK_MONOTONIC, &start);
  for (int r = 0; r < repeats; ++r)
    for (int k = 0; k < count; ++k) sink = sink + once(k);
  clock_gettime(CLOCK_MONOTONIC, &stop);
  const double passed = static_cast<double>(stop.tv_sec - start.tv_sec)
                        + 1e-9 * static_cast<double>(stop.tv_nsec - start.tv_nsec);
  return passed / repeats / count;
}

// the states as Eigen's vectors
static std::vector<Eigen::VectorXd> vectors(const double *rows, int size, int count) {
  std::vector<Eigen::VectorXd> found;
  for (int k = 0; k < count; ++k)
    found.push_back(Eigen::Map<const Eigen::VectorXd>(rows + k * size, size));
  return found;
}
