#include "ToolShell.h"

#include <algorithm>
#include <numeric>

namespace palpate
{
ToolShell::ToolShell(const ToolShape& tool)
    : ToolPoints(tool.Points()), ToolNormals(tool.Normals()), Offsets(ToolPoints),
      Inward(ToolNormals), PointsWorld(ToolPoints), Inside(ToolPoints.size(), 0)
{
}

bool ToolShell::Turn(const Eigen::Quaterniond& orientation) noexcept
{
  if (orientation.coeffs() == this->Orientation.coeffs())
  {
    return false;
  }
  this->Orientation = orientation;
  const Matrix3 rotation = orientation.toRotationMatrix();
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    this->Offsets[i] = rotation * this->ToolPoints[i];
    this->Inward[i] = rotation * this->ToolNormals[i];
  }
  return true;
}

int ToolShell::CountInside(const FieldSolid& solid, const Vector3& positionWorld) noexcept
{
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    this->PointsWorld[i] = positionWorld + this->Offsets[i];
  }
  solid.AreInside(this->PointsWorld.data(), this->Count(), this->Inside.data());
  return std::accumulate(this->Inside.begin(), this->Inside.end(), 0);
}

double ToolShell::PartToEntry(const FieldSolid& solid, const Vector3& positionWorld,
                              const Vector3& path) const noexcept
{
  double part = 1.0;
  for (const Vector3& offset : this->Offsets)
  {
    part = std::min(part, solid.PartToEntry(positionWorld + offset, path));
  }
  return part;
}
} // namespace palpate
