#include "StructureDistance.h"

#include "NodeBox.h"
#include "PositiveNumber.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// For places between those that are looked at.
constexpr double Between = 1.02;
} // namespace

Status StructureDistance::Make(std::shared_ptr<const ScalarField> field, double reach,
                               std::shared_ptr<const StructureDistance>& made)
{
  if (field == nullptr || field->ChannelCount() != 1 ||
      field->Interpolation() != FieldInterpolation::TricubicBSpline)
  {
    return Status::Failure("A guide needs distances to its structure as a cubic B-spline.");
  }
  if (!IsPositive(reach))
  {
    return Status::Failure("The reach of distances to a structure must be finite and positive.");
  }
  // std::make_shared cannot call the private constructor.
  std::shared_ptr<StructureDistance> next(new StructureDistance(std::move(field), reach));
  next->Survey();
  if (!(next->LargestSlope > 0.0))
  {
    return Status::Failure("No point of the grid of distances is within the reach of its "
                           "structure.");
  }
  made = std::move(next);
  return Status::Success();
}

std::optional<StructureDistance::Place>
StructureDistance::At(const Vector3& pointWorld) const noexcept
{
  const FieldGradientSample sample = this->Sampler.ValueAndGradientWorld(0, pointWorld);
  if (sample.Kind == SampleKind::Outside)
  {
    return std::nullopt;
  }
  return Place{sample.Value, sample.Gradient};
}

void StructureDistance::Survey()
{
  const std::array<int, 3>& size = this->Sampler.Field().Grid().Size();
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        this->SurveyAt(Vector3(i, j, k));
      }
    }
  }
}

void StructureDistance::SurveyAt(const Vector3& node)
{
  const FieldGrid& grid = this->Sampler.Field().Grid();
  const FieldGradientSample here = this->Sampler.ValueAndGradientIndex(0, node);
  if (!(std::abs(here.Value) <= this->Farthest))
  {
    return;
  }
  const auto slopeAt = [&](const Vector3& place)
  {
    const FieldGradientSample sample = this->Sampler.ValueAndGradientIndex(0, place);
    const Vector3 slope = grid.GradientWorld(sample.Gradient);
    this->LargestSlope = std::max(this->LargestSlope, Between * slope.norm());
    return slope;
  };
  const Vector3 slope = slopeAt(node);
  slopeAt(node + Vector3::Constant(0.5));
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 turned = slopeAt(node + 0.5 * Vector3::Unit(axis));
    this->LargestBend =
        std::max(this->LargestBend, (turned - slope).norm() / (0.5 * grid.Spacing()[axis]));
  }
}

Eigen::AlignedBox3d StructureDistance::BoundsWorld() const noexcept
{
  const FieldGrid& grid = this->Sampler.Field().Grid();
  return WorldBounds(
      grid, {Vector3::Zero(), Vector3(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1)});
}
} // namespace palpate
