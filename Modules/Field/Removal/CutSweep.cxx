#include "CutSweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
CutSweep::CutSweep(CutTool tool, const CutPose& from, const CutPose& to, double step)
    : Tool(std::move(tool)), From(from.PositionWorld), Path(to.PositionWorld - from.PositionWorld),
      PathSquared(Path.squaredNorm())
{
  const Vector3 reach = Vector3::Constant(this->Tool.BoundingRadius());
  this->Bounds.extend(from.PositionWorld);
  this->Bounds.extend(to.PositionWorld);
  this->Bounds = {this->Bounds.min() - reach, this->Bounds.max() + reach};
  if (this->Tool.IsSphere())
  {
    return;
  }
  constexpr double MostSteps = 4096.0;
  const double turn = from.Orientation.angularDistance(to.Orientation);
  const double path = this->Path.norm() + turn * this->Tool.BoundingRadius();
  const double steps = std::clamp(std::ceil(path / step), 1.0, MostSteps);
  for (int n = 0; n <= static_cast<int>(steps); ++n)
  {
    const Eigen::Quaterniond turned = from.Orientation.slerp(n / steps, to.Orientation);
    this->Places.push_back(
        {this->From + n / steps * this->Path, turned.toRotationMatrix().transpose()});
  }
}

double CutSweep::Distance(const Vector3& pointWorld) const noexcept
{
  if (this->Tool.IsSphere())
  {
    const Vector3 offset = pointWorld - this->From;
    const double along = this->PathSquared > 0.0
                             ? std::clamp(offset.dot(this->Path) / this->PathSquared, 0.0, 1.0)
                             : 0.0;
    return this->Tool.Distance(offset - along * this->Path);
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Place& place : this->Places)
  {
    const Vector3 point = place.ToTool * (pointWorld - place.PositionWorld);
    nearest = std::min(nearest, this->Tool.Distance(point));
  }
  return nearest;
}
} // namespace palpate
