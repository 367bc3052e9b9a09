#include "PixelRays.h"

namespace palpate
{
PixelRays::PixelRays(const Eigen::Matrix4d& worldToClip, int width, int height)
    : Columns(width), Rows(height), ToClip(worldToClip), ToWorld(worldToClip.inverse())
{
  this->Usable = width > 0 && height > 0 && this->ToWorld.allFinite();
}

FieldRay PixelRays::At(double x, double y) const noexcept
{
  const double across = 2.0 * x / this->Columns - 1.0;
  const double up = 2.0 * y / this->Rows - 1.0;
  const Eigen::Vector4d near =
      this->ToWorld.col(0) * across + this->ToWorld.col(1) * up + this->ToWorld.col(3);
  const Eigen::Vector4d far = near + this->ToWorld.col(2);
  const Vector3 start = 1.0 / near[3] * near.head<3>();
  return {start, 1.0 / far[3] * far.head<3>() - start};
}

double PixelRays::Depth(const Vector3& pointWorld) const noexcept
{
  // The z and w coordinates, which determine the depth.
  const auto coordinate = [&](Eigen::Index row)
  {
    return this->ToClip(row, 0) * pointWorld[0] + this->ToClip(row, 1) * pointWorld[1] +
           this->ToClip(row, 2) * pointWorld[2] + this->ToClip(row, 3);
  };
  return coordinate(2) / coordinate(3);
}

double PixelRays::ParameterAtDepth(const FieldRay& ray, double depth) const noexcept
{
  // Depth is a quotient of two linear functions of t; it is 0 at t = 0 and 1 at t = 1.
  const double nearW = this->ToClip.row(3).dot(ray.Origin.homogeneous());
  const double farW = this->ToClip.row(3).dot((ray.Origin + ray.Direction).homogeneous());
  return depth * nearW / (farW + depth * (nearW - farW));
}
} // namespace palpate
