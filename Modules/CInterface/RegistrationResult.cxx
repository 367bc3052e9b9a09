#include "RegistrationResult.h"

#include "BodyMotion.h"
#include "ComparedHandle.h"
#include "ErrorText.h"
#include "LandmarkRegistration.h"
#include "SurfaceRegistration.h"
#include "palpate_shape.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
using MapMatrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

constexpr double NoError = std::numeric_limits<double>::quiet_NaN();

std::vector<Vector3> PointsOf(const double* numbers, std::size_t count)
{
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(VectorOf(numbers + 3 * i));
  }
  return points;
}

bool IsKind(int kind, palpate_error* error)
{
  const bool isKind = kind >= 0 && kind <= 2;
  if (!isKind)
  {
    SetError(error, "the kind of a registration is 0, 1 or 2");
  }
  return isKind;
}

// Messages of registrations are predicates.
int ToldOfRegistration(const Status& status, palpate_error* error)
{
  return Told(status.IsOk() ? status : Status::Failure("the registration " + status.Message()),
              error);
}
// Leaves `from` if no start is given.
bool IsStart(const double* start, Eigen::Affine3d& from, palpate_error* error)
{
  if (start != nullptr)
  {
    from.matrix() = Eigen::Map<const MapMatrix>(start);
  }
  const bool isMap =
      from.matrix().allFinite() && from.matrix().row(3) == Eigen::RowVector4d(0, 0, 0, 1);
  if (!isMap)
  {
    SetError(error, "the start is no matrix of a map, whose last row is 0, 0, 0, 1");
  }
  return isMap;
}

int RegisterOnto(const std::vector<Vector3>& points, const palpate_compared& surface,
                 const Eigen::Affine3d& from, RegistrationKind kind, double noise,
                 palpate_registration& found, palpate_error* error)
{
  SurfaceRegistration made;
  const Status status = RegisterToSurface(points, surface.Body.Surface(), from,
                                          {kind, noise, StepsFromAfar}, {}, made);
  if (ToldOfRegistration(status, error) == 0)
  {
    return 0;
  }
  found = RegistrationOf(made.Map, kind, made.Rms, made.Error);
  found.median = made.Median;
  found.has_converged = made.HasConverged ? 1 : 0;
  return 1;
}
} // namespace

palpate_registration RegistrationOf(const Eigen::Affine3d& map, RegistrationKind kind, double rms,
                                    const PredictedPoseError& predicted)
{
  palpate_registration found{};
  Eigen::Map<MapMatrix>(found.map) = map.matrix();
  found.rms = rms;
  const bool isPredicted = kind != RegistrationKind::Affine;
  found.turn_error = isPredicted ? predicted.Turn : NoError;
  found.shift_error = isPredicted ? predicted.Shift : NoError;
  found.median = NoError;
  found.has_converged = 1;
  return found;
}
} // namespace palpate

using namespace palpate;

int palpate_register_landmarks(const double* moving, const double* fixed, size_t count, int kind,
                               double noise, palpate_registration* found, double* residuals,
                               double* weights, palpate_error* error)
{
  return Guarded(error,
                 {{moving, "moving", count},
                  {fixed, "fixed", count},
                  {found, "found"},
                  {residuals, "residuals", count},
                  {weights, "weights", count}},
                 [&]
                 {
                   if (!IsKind(kind, error))
                   {
                     return 0;
                   }
                   const auto of = static_cast<RegistrationKind>(kind);
                   LandmarkRegistration made;
                   const Status status = RegisterLandmarks(PointsOf(moving, count),
                                                           PointsOf(fixed, count), of, noise, made);
                   if (ToldOfRegistration(status, error) == 0)
                   {
                     return 0;
                   }
                   *found = RegistrationOf(made.Map, of, made.Rms, made.Error);
                   std::copy(made.Residuals.begin(), made.Residuals.end(), residuals);
                   std::copy(made.Weights.begin(), made.Weights.end(), weights);
                   return 1;
                 });
}

int palpate_register_points(const double* points, size_t count, const palpate_compared* surface,
                            int kind, double noise, const double start[16],
                            palpate_registration* found, palpate_error* error)
{
  return Guarded(error, {{points, "points", count}, {surface, "surface"}, {found, "found"}},
                 [&]
                 {
                   Eigen::Affine3d from = Eigen::Affine3d::Identity();
                   return IsKind(kind, error) && IsStart(start, from, error)
                              ? RegisterOnto(PointsOf(points, count), *surface, from,
                                             static_cast<RegistrationKind>(kind), noise, *found,
                                             error)
                              : 0;
                 });
}

int palpate_register_bodies(const palpate_compared* moving, const palpate_compared* fixed, int kind,
                            double noise, const double start[16], palpate_registration* found,
                            palpate_error* error)
{
  return Guarded(error, {{moving, "moving"}, {fixed, "fixed"}, {found, "found"}},
                 [&]
                 {
                   Eigen::Affine3d from(
                       Eigen::Translation3d(fixed->Body.Centroid() - moving->Body.Centroid()));
                   return IsKind(kind, error) && IsStart(start, from, error)
                              ? RegisterOnto(SomePoints(moving->Body.Surface()), *fixed, from,
                                             static_cast<RegistrationKind>(kind), noise, *found,
                                             error)
                              : 0;
                 });
}
