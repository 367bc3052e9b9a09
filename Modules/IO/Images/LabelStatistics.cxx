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
// Of all structures whose runs are collected in one pass, some 100 MB. A larger structure has its
// own pass.
constexpr std::size_t MostRunsTogether = std::size_t{1} << 22;

// A layer's voxels behind one interface for the three types of layers.
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

// The runs of equal values other than 0, row by row.
template <typename T, typename Visit>
void ForEachRun(const LayerView<T>& view, const Visit& visit)
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
        if (row[first] != 0)
        {
          visit(static_cast<int>(row[first]), RowRun{first, end}, y, z);
        }
        first = end;
      }
    }
  }
}

void MeasureRuns(const RunSet& set, const std::array<int, 3>& size, LabelStatistics& statistics)
{
  for (std::size_t face = 0; face < 6; ++face)
  {
    const int end = face % 2 == 0 ? 0 : size[face / 2] - 1;
    statistics.TouchesFace[face] = statistics.BoundsIndex[face] == end;
  }
  statistics.ComponentVoxels = ComponentVoxels(set, LabelRunComponents(set, Neighborhood::Faces));
  for (const long long voxels : FindCavities(set).CavityVoxels)
  {
    if (voxels > 0)
    {
      statistics.CavityVoxels.push_back(voxels);
    }
  }
  std::sort(statistics.ComponentVoxels.begin(), statistics.ComponentVoxels.end(), std::greater<>());
  std::sort(statistics.CavityVoxels.begin(), statistics.CavityVoxels.end(), std::greater<>());
}

struct Structure
{
  LabelStatistics* Statistics = nullptr;
  std::size_t RunCount = 0;
  bool IsCollected = false;
  RunSet Runs;
};

using Structures = std::map<int, Structure>;

// Voxel counts, boxes and numbers of runs.
template <typename T>
void CountRuns(const LayerView<T>& view, Structures& structures)
{
  ForEachRun(view,
             [&](int value, const RowRun& run, int y, int z)
             {
               const auto found = structures.find(value);
               if (found != structures.end())
               {
                 Extend(*found->second.Statistics, run.First, run.End, y, z);
                 ++found->second.RunCount;
               }
             });
}

template <typename T>
void CollectRuns(const LayerView<T>& view, Structures& structures)
{
  ForEachRun(view,
             [&](int value, const RowRun& run, int y, int z)
             {
               const auto found = structures.find(value);
               if (found != structures.end() && found->second.IsCollected)
               {
                 found->second.Runs.Add(run, y, z);
               }
             });
}

// Selects structures from `next` on while their runs fit into one pass. Returns the first that does
// not fit.
Structures::iterator TakeTogether(Structures& structures, Structures::iterator next)
{
  std::size_t runs = 0;
  do
  {
    runs += next->second.RunCount;
    next->second.IsCollected = true;
    ++next;
  } while (next != structures.end() && runs + next->second.RunCount <= MostRunsTogether);
  return next;
}

template <typename T>
void MeasureLayer(vtkImageData* layer, Structures& structures)
{
  const LayerView<T> view(layer);
  CountRuns(view, structures);
  const double* spacing = layer->GetSpacing();
  const double voxelMilliliters = spacing[0] * spacing[1] * spacing[2] / 1000.0;
  for (auto next = structures.begin(); next != structures.end();)
  {
    const auto first = next;
    next = TakeTogether(structures, next);
    CollectRuns(view, structures);
    for (auto each = first; each != next; ++each)
    {
      auto& [statistics, runCount, isCollected, runs] = each->second;
      if (runCount > 0)
      {
        MeasureRuns(runs, view.Size, *statistics);
      }
      statistics->Milliliters = voxelMilliliters * static_cast<double>(statistics->Voxels);
      for (const vtkIdType voxels : statistics->CavityVoxels)
      {
        statistics->CavityMilliliters += voxelMilliliters * static_cast<double>(voxels);
      }
      runs = {};
      isCollected = false;
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
    Structures structures;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (segmentation.Segments[i].Layer == static_cast<int>(layer))
      {
        structures.emplace(segmentation.Segments[i].Value, Structure{&all[i], 0, false, {}});
      }
    }
    vtkImageData* image = segmentation.Layers[layer];
    switch (image->GetScalarType())
    {
    case VTK_UNSIGNED_CHAR:
      MeasureLayer<unsigned char>(image, structures);
      break;
    case VTK_UNSIGNED_SHORT:
      MeasureLayer<unsigned short>(image, structures);
      break;
    default:
      MeasureLayer<int>(image, structures);
    }
  }
  return all;
}
} // namespace palpate
