#include "MaskCollection.h"

#include "Refusal.h"
#include "SegmentColor.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
template <typename T>
void FindRuns(const T* voxels, vtkIdType count, T value, std::vector<VoxelRun>& runs)
{
  const T* const end = voxels + count;
  for (const T* first = std::find(voxels, end, value); first != end;)
  {
    const T* const after = std::find_if(first, end, [value](T voxel) { return voxel != value; });
    runs.push_back({first - voxels, after - first});
    first = std::find(after, end, value);
  }
}

std::vector<VoxelRun> RunsOf(vtkImageData* layer, int value)
{
  vtkDataArray* voxels = layer->GetPointData()->GetScalars();
  std::vector<VoxelRun> runs;
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(FindRuns(static_cast<const VTK_TT*>(voxels->GetVoidPointer(0)),
                              voxels->GetNumberOfTuples(), static_cast<VTK_TT>(value), runs));
  }
  return runs;
}

std::int64_t CountOf(const std::vector<VoxelRun>& runs)
{
  std::int64_t count = 0;
  for (const VoxelRun& run : runs)
  {
    count += run.Count;
  }
  return count;
}

// For which a byte a voxel suffices; more take two.
constexpr int FewStructures = std::numeric_limits<unsigned char>::max();
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
    this->Layers.emplace(this->All.Source, grid, FewStructures,
                         std::numeric_limits<double>::infinity());
  }
  if (!IsSameGrid(*this->Grid, grid))
  {
    Refuse(segmentation.Source, "lies on another grid than the masks before it",
           "convert it on its own");
  }
  for (const std::string& note : segmentation.Notes)
  {
    if (std::find(this->All.Notes.begin(), this->All.Notes.end(), note) == this->All.Notes.end())
    {
      this->All.Notes.push_back(note);
    }
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
    const std::vector<VoxelRun> runs =
        RunsOf(segmentation.Layers[static_cast<std::size_t>(one.Layer)], one.Value);
    this->Compare(runs);
    segment.Layer = this->Layers->Add(segment.Label, runs);
    this->All.Segments.push_back(segment);
  }
}

// The next segment with those before it.
void MaskCollection::Compare(const std::vector<VoxelRun>& runs)
{
  const std::int64_t own = CountOf(runs);
  for (const auto& [label, shared] : this->Layers->Shared(runs))
  {
    const auto other = static_cast<std::size_t>(label - 1);
    this->Found.push_back(
        {other, this->Voxels.size(),
         2.0 * static_cast<double>(shared) / static_cast<double>(own + this->Voxels[other])});
  }
  this->Voxels.push_back(own);
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
