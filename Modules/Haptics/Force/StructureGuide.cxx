#include "StructureGuide.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
StructureGuide::StructureGuide(const GuideSettings& settings,
                               std::shared_ptr<const StructureDistance> distance)
    : Field(std::move(distance)), Shape(settings.Shape), Level(settings.Distance),
      Law(settings, std::max(1.0, Field->Steepest()))
{
}

Status StructureGuide::Make(const GuideSettings& settings,
                            std::shared_ptr<const StructureDistance> distance,
                            std::shared_ptr<const StructureGuide>& made)
{
  const Status status = CheckGuide(settings);
  if (!status.IsOk())
  {
    return status;
  }
  if (!settings.HasStructure() || distance == nullptr)
  {
    return Status::Failure("A guide of points has no structure.");
  }
  if (!(std::abs(settings.Distance) + settings.Range <= distance->Reach()))
  {
    return Status::Failure("A guide acts farther from its structure than its distances reach.");
  }
  // std::make_shared cannot call the private constructor.
  made.reset(new StructureGuide(settings, std::move(distance)));
  return Status::Success();
}

double StructureGuide::Beyond(double distance) const noexcept
{
  const double beyond = distance - this->Level;
  const bool isFree = (this->Shape == GuideShape::Inside && beyond < 0.0) ||
                      (this->Shape == GuideShape::Outside && beyond > 0.0);
  return isFree ? 0.0 : beyond;
}

Vector3 StructureGuide::ForceWorld(const Vector3& originWorld) const noexcept
{
  const auto place = this->Field->At(originWorld);
  if (!place)
  {
    return Vector3::Zero();
  }
  const double beyond = this->Beyond(place->Distance);
  return -this->Law.PullAt(beyond * beyond) * beyond * place->GradientWorld;
}

double StructureGuide::PotentialAt(const Vector3& originWorld) const noexcept
{
  const auto place = this->Field->At(originWorld);
  const double beyond = place ? this->Beyond(place->Distance) : this->Law.Range();
  return this->Law.PotentialAt(beyond * beyond);
}

// The spring across the level, or the turn of a force where the distance bends.
double StructureGuide::Stiffness() const noexcept
{
  const double slope = this->Field->Steepest();
  return std::max(this->Law.Stiffness() * slope * slope,
                  this->Law.LargestForce() * this->Field->Bend());
}
} // namespace palpate
