#include "ForceInterpolation.h"

#include <algorithm>

namespace palpate
{
Vector3 ForceInterpolation::OffsetAt(const Plane& plane, const Vector3& probe) noexcept
{
  const double depth = plane.Normal.dot(plane.Proxy - probe);
  return plane.IsTouching && depth > 0.0 ? Vector3(depth * plane.Normal + plane.Tangential)
                                         : Vector3::Zero();
}

double ForceInterpolation::Remaining() const noexcept
{
  return this->Elapsed < this->Period ? 1.0 - this->Elapsed / this->Period : 0.0;
}

void ForceInterpolation::Renew(const Contact& result, const Vector3& modelProbe,
                               const Vector3& probe, double modelPeriod) noexcept
{
  const Vector3 before = OffsetAt(this->Newest, probe) + this->Remaining() * this->Difference;
  const Vector3 offset = result.ProxyWorld - modelProbe;
  this->Newest = {result.IsTouching, result.ProxyWorld, result.NormalWorld,
                  offset - offset.dot(result.NormalWorld) * result.NormalWorld};
  this->LastNormal = result.IsTouching ? result.NormalWorld : this->LastNormal;
  this->Difference = before - OffsetAt(this->Newest, probe);
  this->Elapsed = 0.0;
  this->Period = modelPeriod;
}

ContactOffset ForceInterpolation::Advance(const Vector3& probe, double passed) noexcept
{
  this->Elapsed += std::max(passed, 0.0);
  ContactOffset felt;
  felt.Offset = OffsetAt(this->Newest, probe) + this->Remaining() * this->Difference;
  felt.Normal = this->LastNormal;
  felt.IsTouching = !felt.Offset.isZero(0.0);
  return felt;
}
} // namespace palpate
