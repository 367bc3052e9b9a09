#include "LabelStatistics.h"

#include "RunComponents.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <functional>
#include <map>

namespace palpate
{
namespace
{
// A layer's voxels behind one interface for the three types that layers have.
template <typename T>
struct LayerView
{
  explicit LayerView(vtkImageData* layer)
      : Values(static_cast<const T*>(layer->GetPointData()->GetScalars()->GetVoidPointer(0)))
  {
    layer->GetDimensions(this->Size.data());
  }

  const T* Row(int y, int z) const
  {
    return this->Values + (static_cast<std::ptrdiff_t>(z) * this->Size[1] + y) * this->Size[0];
  }

  const T* Values;
  std::array<int, 3> Size;
};

void Extend(LabelStatistics& statistics, int first, int end, int y, int z)
{
  auto& box = statistics.BoundsIndex;
  const bool isNew = statistics.Voxels == 0;
  const std::array<int, 3> low{{first, y, z}};
  const std::array<int, 3> high{{end - 1, y, z}};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] = isNew ? low[axis] : std::min(box[2 * axis], low[axis]);
    box[2 * axis + 1] = isNew ? high[axis] : std::max(box[2 * axis + 1], high[axis]);
  }
  statistics.Voxels += end - first;
}

// Voxel counts and boxes of the segments in a layer, by their values.
template <typename T>
void FindBoxes(const LayerView<T>& view, const std::map<int, LabelStatistics*>& byValue)
{
  for (int z = 0; z < view.Size[2]; ++z)
  {
    for (int y = 0; y < view.Size[1]; ++y)
    {
      const T* row = view.Row(y, z);
      for (int first = 0; first < view.Size[0];)
      {
        int end = first + 1;
        while (end < view.Size[0] && row[end] == row[first])
        {
          ++end;
        }
        const auto segment =
            row[first] == 0 ? byValue.end() : byValue.find(static_cast<int>(row[first]));
        if (segment != byValue.end())
        {
          Extend(*segment->second, first, end, y, z);
        }
        first = end;
      }
    }
  }
}

// The runs inside the box of the voxels that have the value, or of those that have not.
template <typename T>
RunSet CollectRuns(const LayerView<T>& view, const std::array<int, 6>& box, int value, bool inside)
{
  RunSet set;
  set.RowsPerSlice = box[3] - box[2] + 1;
  set.Slices = box[5] - box[4] + 1;
  set.RowStarts.push_back(0);
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      const T* row = view.Row(y, z);
      for (int x = box[0]; x <= box[1];)
      {
        const int first = x;
        const bool isInside = static_cast<int>(row[x]) == value;
        while (x <= box[1] && (static_cast<int>(row[x]) == value) == isInside)
        {
          ++x;
        }
        if (isInside == inside)
        {
          set.Runs.push_back({first, x});
        }
      }
      set.RowStarts.push_back(set.Runs.size());
    }
  }
  return set;
}

std::vector<vtkIdType> ComponentSizes(const RunSet& set, const std::vector<int>& components)
{
  std::vector<vtkIdType> sizes;
  for (std::size_t run = 0; run < components.size(); ++run)
  {
    const auto component = static_cast<std::size_t>(components[run]);
    sizes.resize(std::max(sizes.size(), component + 1), 0);
    sizes[component] += set.Runs[run].End - set.Runs[run].First;
  }
  return sizes;
}

// Components of the voxels that are not the structure's and reach no face of its box: from a face
// of the box the way out is free.
std::vector<vtkIdType> CavitySizes(const RunSet& set, const std::array<int, 6>& box)
{
  const std::vector<int> components = LabelRunComponents(set, Neighborhood::FacesEdgesCorners);
  std::vector<vtkIdType> sizes = ComponentSizes(set, components);
  const std::size_t rows = set.RowStarts.size() - 1;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto y = static_cast<int>(row) % set.RowsPerSlice;
    const auto z = static_cast<int>(row) / set.RowsPerSlice;
    const bool outerRow = y == 0 || y == set.RowsPerSlice - 1 || z == 0 || z == set.Slices - 1;
    for (std::size_t run = set.RowStarts[row]; run < set.RowStarts[row + 1]; ++run)
    {
      if (outerRow || set.Runs[run].First == box[0] || set.Runs[run].End == box[1] + 1)
      {
        sizes[static_cast<std::size_t>(components[run])] = 0;
      }
    }
  }
  sizes.erase(std::remove(sizes.begin(), sizes.end(), 0), sizes.end());
  return sizes;
}

template <typename T>
void MeasureInBox(const LayerView<T>& view, int value, LabelStatistics& statistics)
{
  const auto& box = statistics.BoundsIndex;
  for (std::size_t face = 0; face < 6; ++face)
  {
    const int end = face % 2 == 0 ? 0 : view.Size[face / 2] - 1;
    statistics.TouchesFace[face] = box[face] == end;
  }
  const RunSet inside = CollectRuns(view, box, value, true);
  statistics.ComponentVoxels =
      ComponentSizes(inside, LabelRunComponents(inside, Neighborhood::Faces));
  statistics.CavityVoxels = CavitySizes(CollectRuns(view, box, value, false), box);
  std::sort(statistics.ComponentVoxels.begin(), statistics.ComponentVoxels.end(), std::greater<>());
  std::sort(statistics.CavityVoxels.begin(), statistics.CavityVoxels.end(), std::greater<>());
}

template <typename T>
void MeasureLayer(vtkImageData* layer, const std::map<int, LabelStatistics*>& byValue)
{
  const LayerView<T> view(layer);
  FindBoxes(view, byValue);
  const double* spacing = layer->GetSpacing();
  const double voxelMilliliters = spacing[0] * spacing[1] * spacing[2] / 1000.0;
  for (const auto& [value, statistics] : byValue)
  {
    if (statistics->Voxels == 0)
    {
      continue;
    }
    MeasureInBox(view, value, *statistics);
    statistics->Milliliters = voxelMilliliters * static_cast<double>(statistics->Voxels);
    for (const vtkIdType voxels : statistics->CavityVoxels)
    {
      statistics->CavityMilliliters += voxelMilliliters * static_cast<double>(voxels);
    }
  }
}
} // namespace

bool LabelStatistics::TouchesBorder() const
{
  return std::find(this->TouchesFace.begin(), this->TouchesFace.end(), true) !=
         this->TouchesFace.end();
}

std::string LabelStatistics::FacesText() const
{
  static constexpr std::array<const char*, 6> Names{{"x-", "x+", "y-", "y+", "z-", "z+"}};
  std::string text;
  for (std::size_t face = 0; face < 6; ++face)
  {
    text += this->TouchesFace[face] ? (text.empty() ? "" : " ") + std::string(Names[face]) : "";
  }
  return text;
}

std::vector<LabelStatistics> MeasureLabels(const Segmentation& segmentation)
{
  std::vector<LabelStatistics> all(segmentation.Segments.size());
  for (std::size_t layer = 0; layer < segmentation.Layers.size(); ++layer)
  {
    std::map<int, LabelStatistics*> byValue;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (segmentation.Segments[i].Layer == static_cast<int>(layer))
      {
        byValue.emplace(segmentation.Segments[i].Value, &all[i]);
      }
    }
    vtkImageData* image = segmentation.Layers[layer];
    switch (image->GetScalarType())
    {
    case VTK_UNSIGNED_CHAR:
      MeasureLayer<unsigned char>(image, byValue);
      break;
    case VTK_UNSIGNED_SHORT:
      MeasureLayer<unsigned short>(image, byValue);
      break;
    default:
      MeasureLayer<int>(image, byValue);
    }
  }
  return all;
}
} // namespace palpate
