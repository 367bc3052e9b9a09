#include "SceneRegion.h"

#include "DecimalText.h"
#include "FieldOfImage.h"
#include "LabelsOnGrid.h"
#include "Progress.h"
#include "Refusal.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Larger values are cut off: within the range of a field's arithmetic.
constexpr double LargestMargin = 1e30;

// One label of a map on the volume's grid.
struct Mask
{
  vtkSmartPointer<vtkImageData> Labels; // null: everywhere
  double Value = 0.0;

  bool Contains(vtkIdType voxel) const
  {
    return this->Labels == nullptr ||
           this->Labels->GetPointData()->GetScalars()->GetComponent(voxel, 0) == this->Value;
  }
};

Mask MaskOf(const SceneStructure& structure, const Volume& volume, const Segmentation* segmentation)
{
  if (segmentation == nullptr)
  {
    return {};
  }
  const Segment& segment = segmentation->Find(structure.WithinLabel);
  const auto layer = static_cast<std::size_t>(segment.Layer);
  return {LabelsOnGrid(segmentation->Layers[layer], volume.Image),
          static_cast<double>(segment.Value)};
}

// The distance of a value from the nearer end of a range, negative outside of it.
double MarginOf(double value, double lower, double upper)
{
  const double margin = std::min(value - lower, upper - value);
  return std::isnan(margin) ? -1.0 : std::clamp(margin, -LargestMargin, LargestMargin);
}

// Opposite to the neighbours' inside, which lie at about the same distance from the range.
float Outside(double margin)
{
  constexpr float Least = std::numeric_limits<float>::min();
  return -std::max(static_cast<float>(std::abs(margin)), Least);
}

std::string RangeText(const SceneStructure& structure)
{
  return structure.IsoUpper ? "from " + SignificantText(*structure.Iso) + " to " +
                                  SignificantText(*structure.IsoUpper)
                            : "of at least " + SignificantText(*structure.Iso);
}

// A region without a surface.
[[noreturn]] void RefuseRegion(const SceneStructure& structure, const Volume& volume,
                               const std::string& which)
{
  double range[2] = {};
  volume.Image->GetScalarRange(range);
  const std::string where = structure.WithinFile.empty()
                                ? std::string()
                                : " within label " + structure.WithinLabel + " of " +
                                      structure.WithinFile.filename().string();
  Refuse(structure.File,
         "has " + which + " with a value " + RangeText(structure) + where +
             ": its values run from " + SignificantText(range[0]) + " to " +
             SignificantText(range[1]),
         "choose another range");
}
} // namespace

Volume MakeRegion(const SceneStructure& structure, const Volume& volume,
                  const Segmentation* segmentation, const ProgressFunction& progress)
{
  const auto goOn = [&progress](double fraction) { ReportProgress(progress, fraction, "region"); };
  goOn(0.0);
  const Mask mask = MaskOf(structure, volume, segmentation);
  const double upper = structure.IsoUpper.value_or(std::numeric_limits<double>::infinity());
  Volume region;
  region.Source = volume.Source;
  region.IsOriented = volume.IsOriented;
  region.Image = EmptyImageOf(GridOfImage(volume.Image));
  region.Image->AllocateScalars(VTK_FLOAT, 1);
  auto* margins = static_cast<float*>(region.Image->GetScalarPointer());
  vtkDataArray* values = volume.Image->GetPointData()->GetScalars();
  const vtkIdType count = values->GetNumberOfTuples();
  constexpr vtkIdType Part = 1 << 20; // voxels between two reports of progress
  vtkIdType inside = 0;
  for (vtkIdType voxel = 0; voxel < count; ++voxel)
  {
    if (voxel % Part == 0)
    {
      goOn(static_cast<double>(voxel) / static_cast<double>(count));
    }
    const double margin = MarginOf(values->GetComponent(voxel, 0), *structure.Iso, upper);
    margins[voxel] = mask.Contains(voxel) ? static_cast<float>(margin) : Outside(margin);
    inside += margins[voxel] >= 0.0F ? 1 : 0;
  }
  if (inside == 0 || inside == count)
  {
    RefuseRegion(structure, volume, inside == 0 ? "no voxel" : "only voxels");
  }
  return region;
}

vtkSmartPointer<vtkImageData> LabelsOfRegion(vtkImageData* region)
{
  vtkSmartPointer<vtkImageData> labels = EmptyImageOf(GridOfImage(region));
  labels->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const auto* margins = static_cast<const float*>(region->GetScalarPointer());
  std::transform(margins, margins + region->GetNumberOfPoints(),
                 static_cast<unsigned char*>(labels->GetScalarPointer()),
                 [](float margin) { return margin >= 0.0F ? 1 : 0; });
  return labels;
}
} // namespace palpate
