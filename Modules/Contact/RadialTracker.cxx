#include "RadialTracker.h"

#include <utility>

namespace palpate
{
RadialTracker::RadialTracker(std::shared_ptr<const TouchableRadialModel> surface, double toolRadius)
    : Surface(std::move(surface)), ToolRadius(toolRadius)
{
}

void RadialTracker::Release() noexcept
{
  this->Direction = Vector3::UnitZ();
}

const Contact& RadialTracker::Follow(const ToolPose& pose) noexcept
{
  this->Felt = Contact();
  if (!pose.IsUsable())
  {
    return this->Felt;
  }
  this->Felt.IsValid = true;
  this->Felt.ProxyWorld = pose.PositionWorld;
  const Vector3 offset = pose.PositionWorld - this->Surface->Model().CenterWorld();
  const double probeRadius = offset.stableNorm();
  if (probeRadius >= this->Surface->LargestRadius() + this->ToolRadius)
  {
    return this->Felt;
  }
  if (probeRadius > 0.0)
  {
    this->Direction = offset.stableNormalized();
  }
  const TouchableRadialModel::Place place = this->Surface->PlaceAt(this->Direction);
  const Vector3 proxy = place.PointWorld + this->ToolRadius * this->Direction;
  const double depth = (proxy - pose.PositionWorld).dot(this->Direction);
  if (depth > 0.0)
  {
    this->Felt.IsTouching = true;
    this->Felt.ProxyWorld = proxy;
    this->Felt.NormalWorld = place.Normal;
    this->Felt.Depth = depth;
  }
  return this->Felt;
}
} // namespace palpate
