#include "SceneField.h"

#include "FieldOfImage.h"
#include "FilterRun.h"
#include "LabelField.h"

#include "vtkImageData.h"

namespace palpate
{
namespace
{
// Throws what a status says; the builder answers a cancelled progress with a status too.
void Require(const Status& status, bool wasCancelled)
{
  if (wasCancelled)
  {
    throw Cancelled();
  }
  if (!status.IsOk())
  {
    throw FilterError(status.Message());
  }
}
} // namespace

std::shared_ptr<const ScalarField> MakeIsoField(vtkImageData* image,
                                                const std::vector<double>& isoValues,
                                                FieldInterpolation interpolation,
                                                const ProgressFunction& progress)
{
  bool wasCancelled = false;
  const auto report = [&](double part)
  {
    wasCancelled = wasCancelled || !progress(part, "field");
    return !wasCancelled;
  };
  std::shared_ptr<const ScalarField> field;
  Require(BuildFieldOfImage(image, isoValues, interpolation, report, field), wasCancelled);
  return field;
}

std::shared_ptr<const ScalarField> MakeSegmentField(const Segmentation& segmentation,
                                                    const std::vector<Segment>& structures,
                                                    FieldInterpolation interpolation,
                                                    double smoothing,
                                                    const ProgressFunction& progress)
{
  // Distances take most of the time.
  constexpr double DistancesPart = 0.8;
  const FieldGrid grid = GridOfImage(segmentation.Layers.front());
  FieldBuilder builder(grid);
  builder.SetInterpolation(interpolation);
  std::vector<LabelField> distances(structures.size());
  for (std::size_t s = 0; s < structures.size(); ++s)
  {
    const double part = DistancesPart * static_cast<double>(s);
    if (!progress(part / static_cast<double>(structures.size()), "distances"))
    {
      throw Cancelled();
    }
    vtkImageData* layer = segmentation.Layers[static_cast<std::size_t>(structures[s].Layer)];
    FieldSamples labels;
    Require(SamplesOfImage(layer, labels), false);
    Require(LabelField::Make(labels, grid, structures[s].Value, smoothing, distances[s]), false);
    builder.AddMaterial({builder.AddChannel(distances[s].Samples()), 0.0, FieldSense::AtLeast});
  }
  bool wasCancelled = false;
  const auto report = [&](double part)
  {
    wasCancelled = wasCancelled || !progress(DistancesPart + (1.0 - DistancesPart) * part, "field");
    return !wasCancelled;
  };
  std::shared_ptr<const ScalarField> field;
  Require(builder.Build(field, report), wasCancelled);
  return field;
}
} // namespace palpate
