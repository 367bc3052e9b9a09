#include "StiffnessImage.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
bool IsStiffness(double number)
{
  return number >= 0.0 && std::isfinite(number);
}
} // namespace

Status StiffnessImage::Make(std::shared_ptr<const ScalarField> image, int channel,
                            const StiffnessRange& range,
                            std::shared_ptr<const StiffnessImage>& made)
{
  if (!IsStiffness(range.FromStiffness) || !IsStiffness(range.ToStiffness))
  {
    return Status::Failure("The stiffnesses of an image must be finite and not negative.");
  }
  const double fade = image != nullptr ? FadeVoxels * image->Grid().Spacing().maxCoeff() : 0.0;
  std::optional<FeltImage> felt;
  Status status = FeltImage::Make(std::move(image), channel, range.FromIntensity, range.ToIntensity,
                                  fade, felt);
  if (status.IsOk())
  {
    // std::make_shared cannot call the private constructor.
    made.reset(new StiffnessImage(*felt, range));
  }
  return status;
}

// Means, so that the stated stiffnesses are exact at the stated intensities.
double StiffnessImage::StiffnessOf(const FeltImage::Place& place) const noexcept
{
  return this->Range.FromStiffness * (1.0 - place.Level) + this->Range.ToStiffness * place.Level;
}

double StiffnessImage::StiffnessAt(double own, const Vector3& pointWorld) const noexcept
{
  const FeltImage::Place place = this->Image.At(pointWorld);
  return own * (1.0 - place.Weight) + this->StiffnessOf(place) * place.Weight;
}

double StiffnessImage::LargestStiffness(double own) const noexcept
{
  return std::max({own, this->Range.FromStiffness, this->Range.ToStiffness});
}

Vector3 StiffnessImage::Force(const EffectTouch& touch) const noexcept
{
  if (!touch.Contact.IsTouching || touch.Contact.IsElastic)
  {
    return Vector3::Zero();
  }
  const FeltImage::Place place = this->Image.At(touch.SurfaceWorld);
  const double more = this->Range.ToStiffness - this->Range.FromStiffness;
  const Vector3 slopeWorld = place.Weight * more * place.LevelGradient +
                             (this->StiffnessOf(place) - touch.OwnStiffness) * place.WeightGradient;
  const Vector3 slope = touch.WorldPerDevice.transpose() * slopeWorld;
  const Vector3& normal = touch.Contact.Normal;
  const double depth = touch.Contact.Offset.dot(normal);
  return -0.5 * depth * depth * (slope - slope.dot(normal) * normal);
}
} // namespace palpate
