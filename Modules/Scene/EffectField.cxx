#include "EffectField.h"

#include "AxisWeights.h"
#include "FieldOfImage.h"
#include "FieldRun.h"
#include "NodeBox.h"
#include "OwnCopy.h"
#include "Refusal.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palpate
{
namespace
{
// Cuts the image to a box of its nodes.
void Crop(vtkImageData* image, const NodeBox& nodes)
{
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis + 1] = extent[2 * axis] + nodes.Last[axis];
    extent[2 * axis] += nodes.First[axis];
  }
  image->Crop(extent.data());
}
// Averages samples with a Gaussian; beyond the border the outermost ones are repeated.
std::vector<float> Smoothed(const FieldSamples& samples, const FieldGrid& grid, double deviation)
{
  std::vector<float> values(samples.Count());
  VisitScalars(samples.Data, samples.Type,
               [&values](const auto* data)
               {
                 std::transform(data, data + values.size(), values.begin(),
                                [](auto value) { return static_cast<float>(value); });
               });
  std::array<int, 3> size = grid.Size();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int count = size[axis];
    const double voxels = deviation / grid.Spacing()[static_cast<Eigen::Index>(axis)];
    values = AxisWeights({count, count, 0.0, 1.0, voxels}).Apply(values, size, axis);
  }
  return values;
}
} // namespace

std::shared_ptr<const ScalarField> FieldAround(const SceneEffectSource& source,
                                               const EffectFieldSettings& settings,
                                               const ProgressFunction& progress)
{
  const Volume& volume = *source.Image;
  const FieldGrid grid = GridOfImage(volume.Image);
  const Vector3 margin = Vector3::Constant(source.ToolReach + settings.Margin);
  const Eigen::AlignedBox3d& bounds = source.BoundsWorld;
  // One node more than needed, against rounding.
  const NodeBox nodes = NodesRound(grid, {bounds.min() - margin, bounds.max() + margin}, 1.0);
  if (!nodes.HasCells())
  {
    Refuse(volume.Source, "does not reach the structure on which it is to be felt",
           "choose an image of the same place");
  }
  const auto image = OwnCopy(volume.Image.Get());
  Crop(image, nodes);
  FieldSamples samples;
  Status status = SamplesOfImage(image, samples);
  const FieldGrid kept = PartOf(grid, nodes);
  std::vector<float> smoothed;
  if (status.IsOk() && settings.Smoothing > 0.0)
  {
    smoothed = Smoothed(samples, kept, settings.Smoothing);
    samples = SamplesOfGrid(smoothed.data(), kept);
  }
  FieldBuilder builder(kept);
  builder.AddChannel(samples);
  builder.KeepAll();
  builder.SetInterpolation(settings.Interpolation);
  std::shared_ptr<const ScalarField> field;
  if (status.IsOk())
  {
    status = RunBuilder(builder, settings.Stage, progress, field);
  }
  RequireInput(status, volume.Source.string());
  return field;
}
} // namespace palpate
