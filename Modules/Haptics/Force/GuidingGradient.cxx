#include "GuidingGradient.h"

#include "NodeBox.h"
#include "PositiveNumber.h"
#include "SmoothStep.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{
Status GuidingGradient::Make(std::shared_ptr<const ScalarField> image, int channel,
                             const GuidingSettings& settings,
                             std::shared_ptr<const GuidingGradient>& made)
{
  if (!IsPositive(settings.Energy) || !IsPositive(settings.LargestForce))
  {
    return Status::Failure("Energy and largest force of a guiding gradient must be finite and "
                           "positive.");
  }
  std::optional<FeltImage> felt;
  Status status = FeltImage::Make(std::move(image), channel, settings.FromIntensity,
                                  settings.ToIntensity, settings.Fade, felt);
  if (status.IsOk())
  {
    // std::make_shared cannot call the private constructor.
    std::shared_ptr<GuidingGradient> next(new GuidingGradient(*felt, settings.LargestForce));
    next->FitInto(settings.Energy);
    made = std::move(next);
  }
  return status;
}

// Of the smooth step, with its weight, per mm.
Vector3 GuidingGradient::SlopeAt(const Vector3& originWorld) const noexcept
{
  const FeltImage::Place place = this->Image.At(originWorld);
  return place.Weight * SmoothStepSlope(place.Level) * place.LevelGradient +
         SmoothStep(place.Level) * place.WeightGradient;
}

// Looks at nodes and at centres between them, where differences of the B-spline are largest.
void GuidingGradient::FitInto(double energy)
{
  // A tenth for places between those; ForceWorld limits what may still be above.
  constexpr double Between = 1.1;
  const FieldGrid& grid = this->Image.Grid();
  const Vector3 half = Vector3::Constant(0.5);
  const double distance = grid.VectorWorld(half).norm();
  double steepest = 0.0;
  double change = 0.0;
  const std::array<int, 3>& size = grid.Size();
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const Vector3 node(i, j, k);
        const Vector3 here = this->SlopeAt(grid.PointWorld(node));
        const Vector3 next = this->SlopeAt(grid.PointWorld(node + half));
        steepest = std::max({steepest, here.norm(), next.norm()});
        change = std::max(change, (next - here).norm() / distance);
      }
    }
  }
  const double allowed = this->LargestForce / (Between * steepest);
  this->Depth = allowed < energy ? allowed : energy; // infinite if nothing is steep
  this->Steepest = std::isfinite(change) ? this->Depth * change : 0.0;
}

double GuidingGradient::PotentialAt(const Vector3& originWorld) const noexcept
{
  const FeltImage::Place place = this->Image.At(originWorld);
  return -this->Depth * place.Weight * SmoothStep(place.Level);
}

Vector3 GuidingGradient::ForceWorld(const Vector3& originWorld) const noexcept
{
  const Vector3 force = this->Depth * this->SlopeAt(originWorld);
  const double length = force.norm();
  if (!std::isfinite(length))
  {
    return Vector3::Zero();
  }
  return length > this->LargestForce ? Vector3(this->LargestForce / length * force) : force;
}

Eigen::AlignedBox3d GuidingGradient::BoundsWorld() const noexcept
{
  const FieldGrid& grid = this->Image.Grid();
  const Vector3 last(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1);
  return WorldBounds(grid, {Vector3::Zero(), last});
}
} // namespace palpate
