#include "HeldFit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
Vector3 MiddleOf(const IndexedMesh& mesh, const std::array<int, 3>& triangle)
{
  return (mesh.Points[triangle[0]] + mesh.Points[triangle[1]] + mesh.Points[triangle[2]]) / 3.0;
}

Status CheckSettings(const HeldFitSettings& settings)
{
  const bool isValid = settings.Stiffness > 0.0 && std::isfinite(settings.Stiffness) &&
                       settings.Reach > 0.0 && std::isfinite(settings.Reach) && settings.Points > 0;
  return isValid ? Status::Success()
                 : Status::Failure("needs a stiffness, a reach and points above zero");
}
} // namespace

HeldFitSettings HeldFitSettings::ForHand(const IndexedMesh& fixed)
{
  constexpr int FeltPoints = 64;        // a tick of a device takes 0.1 to 0.2 ms for them
  constexpr double MostForce = 1.5;     // N
  constexpr double MostStiffness = 1.0; // N/mm
  constexpr double MostReach = 15.0;    // mm
  constexpr double LeastReach = 1.0;    // mm
  Eigen::AlignedBox3d box;
  for (const Vector3& point : fixed.Points)
  {
    box.extend(point);
  }
  HeldFitSettings settings;
  settings.Points = FeltPoints;
  const double half = box.isEmpty() ? LeastReach : 0.5 * box.sizes().minCoeff();
  settings.Reach = std::clamp(0.5 * half, LeastReach, MostReach);
  settings.Stiffness =
      std::min(MostStiffness, MostForce / (HeldFit::LargestOfPoint * settings.Reach));
  return settings;
}

std::vector<Vector3> PointsOfEqualArea(const IndexedMesh& mesh, int count)
{
  double area = 0.0;
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    area += AreaVector(mesh, triangle).norm();
  }
  std::vector<Vector3> points;
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return points;
  }
  const double share = area / count;
  double passed = 0.5 * share; // so that the last one is not on the end
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    passed += AreaVector(mesh, triangle).norm();
    // A triangle that is larger than a share counts that many times.
    for (; passed >= share; passed -= share)
    {
      points.push_back(MiddleOf(mesh, triangle));
    }
  }
  return points;
}

Status HeldFit::Make(const IndexedMesh& moving, const IndexedMesh& fixed,
                     const HeldFitSettings& settings, HeldFit& made)
{
  if (Status status = CheckSettings(settings); !status.IsOk())
  {
    return status;
  }
  HeldFit fit;
  fit.Settings = settings;
  fit.Samples = PointsOfEqualArea(moving, settings.Points);
  if (fit.Samples.empty())
  {
    return Status::Failure("holds a surface without area");
  }
  if (Status status = NearestOnMesh::Make(fixed, fit.Fixed); !status.IsOk())
  {
    return status;
  }
  for (const Vector3& point : fit.Samples)
  {
    fit.Middle += point / static_cast<double>(fit.Samples.size());
  }
  for (const Vector3& point : fixed.Points)
  {
    fit.Bounds.extend(point);
  }
  made = std::move(fit);
  return Status::Success();
}

HeldForce HeldFit::At(const Eigen::Affine3d& pose) const noexcept
{
  const double square = this->Settings.Reach * this->Settings.Reach;
  const Vector3 pivot = pose * this->Middle;
  HeldForce sum;
  for (const Vector3& sample : this->Samples)
  {
    const Vector3 place = pose * sample;
    const Vector3 away = place - this->Fixed.Find(place).Point;
    const double left = std::max(0.0, 1.0 - away.squaredNorm() / square);
    const Vector3 force = -left * left * away;
    sum.Energy += square / 6.0 * (1.0 - left * left * left);
    sum.Force += force;
    sum.Torque += (place - pivot).cross(force);
  }
  const double each = this->Settings.Stiffness / static_cast<double>(this->Samples.size());
  sum.Energy *= each;
  sum.Force *= each;
  sum.Torque *= each;
  return sum;
}
} // namespace palpate
