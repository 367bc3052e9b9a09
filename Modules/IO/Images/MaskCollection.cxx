#include "MaskCollection.h"

#include "Refusal.h"
#include "SegmentColor.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <limits>
#include <vector>

namespace palpate
{
namespace
{
// Up to rounding of their headers.
bool IsSameGrid(const ImageGrid& a, const ImageGrid& b)
{
  constexpr double Tolerance = 1e-3; // of a voxel
  const double voxel = a.Spacing.minCoeff();
  const double extent = Vector3(a.Size[0], a.Size[1], a.Size[2]).maxCoeff();
  return a.Size == b.Size && (a.OriginWorld - b.OriginWorld).norm() <= Tolerance * voxel &&
         (a.Spacing - b.Spacing).norm() * extent <= Tolerance * voxel &&
         (a.Direction - b.Direction).norm() * extent <= Tolerance;
}

std::vector<VoxelRun> RunsOf(vtkImageData* layer, int value)
{
  vtkDataArray* voxels = layer->GetPointData()->GetScalars();
  const vtkIdType count = voxels->GetNumberOfTuples();
  std::vector<VoxelRun> runs;
  for (vtkIdType start = 0; start < count;)
  {
    vtkIdType end = start;
    while (end < count && voxels->GetComponent(end, 0) == value)
    {
      ++end;
    }
    if (end > start)
    {
      runs.push_back({start, end - start});
    }
    start = end + 1;
  }
  return runs;
}

constexpr int MostStructures = std::numeric_limits<unsigned short>::max();
} // namespace

MaskCollection::MaskCollection(const std::filesystem::path& source)
{
  this->All.Source = source;
}

void MaskCollection::Add(const Segmentation& segmentation, const std::string& name)
{
  const ImageGrid grid = GridOf(segmentation.Layers.front());
  if (!this->Grid)
  {
    this->Grid = grid;
    this->All.IsOriented = segmentation.IsOriented;
    this->Layers.emplace(this->All.Source, grid, MostStructures,
                         std::numeric_limits<double>::infinity());
  }
  if (!IsSameGrid(*this->Grid, grid))
  {
    Refuse(segmentation.Source, "lies on another grid than the masks before it",
           "convert it on its own");
  }
  for (const Segment& one : segmentation.Segments)
  {
    Segment segment = one;
    segment.Label = segment.Value = static_cast<int>(this->All.Segments.size()) + 1;
    if (segment.Name.empty())
    {
      segment.Name =
          segmentation.Segments.size() == 1 ? name : name + " " + std::to_string(one.Label);
      segment.Color = DefaultSegmentColor(segment.Label);
    }
    segment.Layer = this->Layers->Add(
        segment.Label, RunsOf(segmentation.Layers[static_cast<std::size_t>(one.Layer)], one.Value));
    this->All.Segments.push_back(segment);
  }
}

Segmentation MaskCollection::Result()
{
  if (this->All.Segments.empty())
  {
    Refuse(this->All.Source, "has no mask that can be read", "use a folder of masks");
  }
  this->All.Layers = this->Layers->Images();
  return this->All;
}
} // namespace palpate
