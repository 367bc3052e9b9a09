#include "LabelParts.h"

#include "DecimalText.h"
#include "ImageIndexToWorld.h"
#include "LabelMask.h"
#include "MappedSurface.h"
#include "MaskComponents.h"
#include "VoxelMinimum.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
{
// How far a mask's voxels reach from the patient's right to the left, mm.
std::pair<double, double> WidthOf(const VoxelMask& mask, const IndexToWorld& toWorld)
{
  std::pair<double, double> width{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
  std::size_t at = 0;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        if (mask.Inside[at++] != 0)
        {
          const double x = toWorld(Vector3(i + mask.StartIndex[0], j + mask.StartIndex[1],
                                           k + mask.StartIndex[2]))
                               .x();
          width = {std::min(width.first, x), std::max(width.second, x)};
        }
      }
    }
  }
  return width;
}

// "left" and "right" of two parts, empty if they do not lie beside each other.
std::vector<std::string> SidesOf(const Segmentation& segmentation, const Segment& structure)
{
  vtkImageData* image = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  const IndexToWorld toWorld = IndexToWorldOf(image);
  const auto first = WidthOf(CopyComponent(image, structure.Value, 1, 1), toWorld);
  const auto second = WidthOf(CopyComponent(image, structure.Value, 2, 1), toWorld);
  // The world is patient LPS: x grows to the left.
  return first.second < second.first   ? std::vector<std::string>{"right", "left"}
         : second.second < first.first ? std::vector<std::string>{"left", "right"}
                                       : std::vector<std::string>{};
}
} // namespace

std::vector<StructureToFit> PartsOf(const Segmentation& segmentation, const Segment& structure,
                                    const FitSettings& settings, std::string& leftOut)
{
  vtkImageData* image = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  const VoxelMask mask = CopyLabelMask(image, structure.Value, 1).Mask;
  const std::vector<long long> voxels = MaskComponents(mask).VoxelCounts();
  const auto all = static_cast<double>(std::accumulate(voxels.begin(), voxels.end(), 0LL));
  const auto count = std::count_if(voxels.begin(), voxels.end(),
                                   [&](long long part)
                                   {
                                     const auto size = static_cast<double>(part);
                                     return size >= TopologySettings().SmallPart * all &&
                                            TooFewVoxels(size * mask.VoxelVolume(), image).empty();
                                   });
  FitSettings alone = settings;
  alone.Component = 1;
  alone.IsAlone = true;
  if (const auto small = static_cast<std::int64_t>(voxels.size()) - count; small > 0 && count > 0)
  {
    leftOut = CountText(small, "part", "parts") + " of less than " +
              FixedText(100.0 * TopologySettings().SmallPart, 1) +
              " % of the label, or of too few voxels, left out";
  }
  if (count < 2)
  {
    return {{structure, alone}};
  }
  const std::vector<std::string> sides = count == 2 && segmentation.IsOriented
                                             ? SidesOf(segmentation, structure)
                                             : std::vector<std::string>();
  std::vector<StructureToFit> parts(static_cast<std::size_t>(count), {structure, alone});
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const std::string name = sides.empty() ? "part " + std::to_string(part + 1) : sides[part];
    parts[part].Settings.Component = static_cast<int>(part) + 1;
    parts[part].Structure.Name = structure.Name.empty() ? name : name + " " + structure.Name;
  }
  return parts;
}
} // namespace palpate
