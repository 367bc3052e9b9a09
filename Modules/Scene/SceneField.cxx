#include "SceneField.h"

#include "CaseText.h"
#include "DecimalText.h"
#include "FieldOfImage.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "LabelField.h"
#include "LabelsOnGrid.h"
#include "NodeBox.h"
#include "VoxelMinimum.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
// Throws a failed status; the builder also returns a status if progress cancels.
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

// Throws an error about a structure, unless the reason is empty.
void Require(const Segmentation& segmentation, const Segment& structure, const std::string& reason,
             const std::string& hint)
{
  if (!reason.empty())
  {
    throw FilterError(WithHint(CaseMessage(segmentation.Source, structure, reason), hint));
  }
}

// Fraction of the time that distances to labels take.
constexpr double DistancesPart = 0.8;

// Runs a function that makes a field and returns a status; its progress starts at `done`.
template <typename Make>
std::shared_ptr<const ScalarField> Build(const Make& make, double done,
                                         const ProgressFunction& progress)
{
  bool wasCancelled = false;
  const auto report = [&](double part)
  {
    wasCancelled = wasCancelled || !progress(done + (1.0 - done) * part, "field");
    return !wasCancelled;
  };
  std::shared_ptr<const ScalarField> field;
  const Status status = make(report, field);
  Require(status, wasCancelled);
  return field;
}

std::shared_ptr<const ScalarField> Build(const FieldBuilder& builder,
                                         const ProgressFunction& progress)
{
  return Build([&](const auto& report, auto& field) { return builder.Build(field, report); },
               DistancesPart, progress);
}

// The region of known distances, with a margin such that the border's influence on B-spline
// coefficients, 0.27 to the power of the number of nodes between, is below the rounding of floats.
NodeBox BoxOf(const std::vector<LabelField>& distances, const FieldGrid& whole,
              FieldInterpolation interpolation)
{
  const int rim = interpolation == FieldInterpolation::Trilinear ? 0 : 14;
  NodeBox box{whole.Size(), {-1, -1, -1}};
  for (const LabelField& distance : distances)
  {
    const FieldSamples samples = distance.Samples();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int first = samples.StartIndex[axis] - rim;
      const int last = samples.StartIndex[axis] + samples.Size[axis] - 1 + rim;
      box.First[axis] = std::max(0, std::min(box.First[axis], first));
      box.Last[axis] = std::min(whole.Size()[axis] - 1, std::max(box.Last[axis], last));
    }
  }
  return box;
}

// The distances of structures, on the grid of the images that `layerOf` returns for their layers.
template <typename LayerOf>
std::vector<LabelField> DistancesOf(const std::vector<Segment>& structures, const LayerOf& layerOf,
                                    double smoothing, const ProgressFunction& progress)
{
  std::vector<LabelField> distances(structures.size());
  for (std::size_t s = 0; s < structures.size(); ++s)
  {
    const double part = DistancesPart * static_cast<double>(s);
    ReportProgress(progress, part / static_cast<double>(structures.size()), "distances");
    const vtkSmartPointer<vtkImageData> layer = layerOf(structures[s].Layer);
    FieldSamples labels;
    Require(SamplesOfImage(layer, labels), false);
    Require(
        LabelField::Make(labels, GridOfImage(layer), structures[s].Value, smoothing, distances[s]),
        false);
  }
  return distances;
}
} // namespace

std::shared_ptr<const ScalarField> MakeIsoField(vtkImageData* image,
                                                const std::vector<double>& isoValues,
                                                const FieldForm& form,
                                                const ProgressFunction& progress)
{
  return Build([&](const auto& report, auto& field)
               { return BuildFieldOfImage(image, isoValues, form, report, field); },
               0.0, progress);
}

std::shared_ptr<const ScalarField> MakeIsoFieldWithin(vtkImageData* image, double isoValue,
                                                      const Segmentation& segmentation,
                                                      const std::vector<Segment>& structures,
                                                      const FieldForm& form, double smoothing,
                                                      const ProgressFunction& progress)
{
  std::vector<vtkSmartPointer<vtkImageData>> matched(segmentation.Layers.size());
  const auto layerOf = [&](int number)
  {
    const auto layer = static_cast<std::size_t>(number);
    if (!matched[layer])
    {
      matched[layer] = LabelsOnGrid(segmentation.Layers[layer], image);
    }
    return matched[layer];
  };
  const std::vector<LabelField> distances = DistancesOf(structures, layerOf, smoothing, progress);
  FieldSamples samples;
  Require(SamplesOfImage(image, samples), false);
  FieldBuilder builder(GridOfImage(image));
  builder.SetForm(form);
  const int channel = builder.AddChannel(samples);
  for (const LabelField& distance : distances)
  {
    builder.AddMaterial({channel, isoValue, FieldSense::AtLeast},
                        {builder.AddChannel(distance.Samples()), 0.0, FieldSense::AtLeast});
  }
  return Build(builder, progress);
}

std::shared_ptr<const ScalarField> MakeSegmentField(const Segmentation& segmentation,
                                                    const std::vector<Segment>& structures,
                                                    const FieldForm& form, double smoothing,
                                                    const ProgressFunction& progress)
{
  for (const Segment& structure : structures)
  {
    Require(segmentation, structure, TooFewVoxels(segmentation, structure), ChooseAnother);
  }
  const auto layerOf = [&](int layer)
  { return segmentation.Layers[static_cast<std::size_t>(layer)]; };
  const std::vector<LabelField> distances = DistancesOf(structures, layerOf, smoothing, progress);
  const FieldGrid whole = GridOfImage(segmentation.Layers.front());
  const NodeBox box = BoxOf(distances, whole, form.Interpolation);
  FieldBuilder builder(PartOf(whole, box));
  FieldForm smoothed = form;
  smoothed.Smoothing = smoothing;
  for (const LabelField& distance : distances)
  {
    smoothed.Smoothing = std::min(smoothed.Smoothing, distance.Smoothing());
  }
  builder.SetForm(smoothed);
  for (const LabelField& distance : distances)
  {
    FieldSamples samples = distance.Samples();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      samples.StartIndex[axis] -= box.First[axis];
    }
    builder.AddMaterial({builder.AddChannel(samples), 0.0, FieldSense::AtLeast});
  }
  return Build(builder, progress);
}
} // namespace palpate
