#include "FeltImage.h"

#include "SmoothStep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
FeltImage::FeltImage(std::shared_ptr<const ScalarField> image, int channel, double from, double to,
                     double fade)
    : Sampler(std::move(image)), Channel(channel), From(from), To(to)
{
  const FieldGrid& grid = this->Grid();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double quarter = 0.25 * (grid.Size()[static_cast<std::size_t>(axis)] - 1);
    this->Fade[axis] = std::min(fade / grid.Spacing()[axis], quarter);
  }
}

Status FeltImage::Make(std::shared_ptr<const ScalarField> image, int channel, double from,
                       double to, double fade, std::optional<FeltImage>& made)
{
  if (image == nullptr || channel < 0 || channel >= image->ChannelCount())
  {
    return Status::Failure("There is no image to be felt.");
  }
  const double perUnit = 1.0 / (to - from);
  if (!std::isfinite(perUnit) || perUnit == 0.0)
  {
    return Status::Failure("The two intensities between which the image is felt are equal or not "
                           "finite: choose two different ones.");
  }
  if (!(fade > 0.0))
  {
    return Status::Failure("The image needs a border in which its force fades out.");
  }
  made = FeltImage(std::move(image), channel, from, to, fade);
  return Status::Success();
}

FeltImage::Place FeltImage::At(const Vector3& pointWorld) const noexcept
{
  const FieldGrid& grid = this->Grid();
  const Vector3 pointIndex = grid.PointIndex(pointWorld);
  const FieldGradientSample sample = this->Sampler.ValueAndGradientIndex(this->Channel, pointIndex);
  if (sample.Kind == SampleKind::Outside)
  {
    return {};
  }
  Place place;
  const double level = (sample.Value - this->From) / (this->To - this->From);
  place.Level = std::clamp(level, 0.0, 1.0);
  if (level > 0.0 && level < 1.0)
  {
    place.LevelGradient = grid.GradientWorld(sample.Gradient) / (this->To - this->From);
  }
  this->WeighAt(pointIndex, place);
  return std::isfinite(level) && place.LevelGradient.allFinite() ? place : Place();
}

// A product of smooth steps along the axes, whose gradients are 0 at both ends.
void FeltImage::WeighAt(const Vector3& pointIndex, Place& place) const noexcept
{
  double steps[3];
  double slopes[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double end = this->Grid().Size()[static_cast<std::size_t>(axis)] - 1;
    const double p = pointIndex[axis];
    const double t = std::clamp(std::min(p, end - p) / this->Fade[axis], 0.0, 1.0);
    steps[axis] = SmoothStep(t);
    slopes[axis] = (p < end - p ? 1.0 : -1.0) * SmoothStepSlope(t) / this->Fade[axis];
  }
  place.Weight = steps[0] * steps[1] * steps[2];
  place.WeightGradient =
      this->Grid().GradientWorld({slopes[0] * steps[1] * steps[2], steps[0] * slopes[1] * steps[2],
                                  steps[0] * steps[1] * slopes[2]});
}
} // namespace palpate
