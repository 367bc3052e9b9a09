#include "StructureGaps.h"

#include "DecimalText.h"
#include "SliceStack.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace palpate
{
namespace
{
// The slices with voxels, ascending and each once.
std::vector<int> FilledSlices(const ImageGrid& grid, const std::vector<VoxelRun>& runs)
{
  const std::int64_t sliceVoxels = static_cast<std::int64_t>(grid.Size[0]) * grid.Size[1];
  std::vector<int> slices;
  for (const VoxelRun& run : runs)
  {
    slices.push_back(static_cast<int>(run.First / sliceVoxels));
  }
  std::sort(slices.begin(), slices.end());
  slices.erase(std::unique(slices.begin(), slices.end()), slices.end());
  return slices;
}

std::string PlaceOfSlice(const ImageGrid& grid, int slice)
{
  const Vector3 axis = grid.Direction.col(2);
  return PlaceAlong(axis, grid.OriginWorld + slice * grid.Spacing[2] * axis);
}
} // namespace

std::string GapNote(const Segment& structure, const ImageGrid& grid,
                    const std::vector<VoxelRun>& runs)
{
  constexpr int MostNamed = 3;
  const std::vector<int> slices = FilledSlices(grid, runs);
  std::string places;
  int gaps = 0;
  std::int64_t missing = 0;
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    const int first = slices[i - 1] + 1;
    const int last = slices[i] - 1;
    if (last < first)
    {
      continue;
    }
    missing += last - first + 1;
    if (++gaps <= MostNamed)
    {
      places += (places.empty() ? "" : ", ") + PlaceOfSlice(grid, first) +
                (last > first ? " to " + PlaceOfSlice(grid, last) : std::string());
    }
  }
  if (gaps == 0)
  {
    return {};
  }
  places += gaps > MostNamed ? " and " + std::to_string(gaps - MostNamed) + " more gaps" : "";
  return "Structure " + std::to_string(structure.Label) +
         (structure.Name.empty() ? "" : " '" + structure.Name + "'") + " lacks " +
         CountText(missing, "slice", "slices") + " between its first and its last (" + places +
         "): it is empty there.";
}
} // namespace palpate
