#include "DrillPhantom.h"

#include "AvailableMemory.h"
#include "FieldGrid.h"
#include "FieldOfImage.h"
#include "FilterRun.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "SceneFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Margin = 3.0; // mm of air all round
constexpr double BoneValue = 1500.0;
constexpr double AirValue = 2.0 * DrillPhantom::Iso - BoneValue;
constexpr double BytesPerVoxel = 2.0 * (sizeof(short) + 1.0); // and a copy during writing

// A grid with these axes that contains the block.
FieldGrid GridRoundBlock(const Vector3& spacing, const Matrix3& direction)
{
  const Vector3 half(DrillPhantom::HalfWidth, DrillPhantom::HalfWidth, DrillPhantom::HalfHeight);
  const Vector3 reach = direction.transpose().cwiseAbs() * half + Vector3::Constant(Margin);
  std::array<int, 3> size{};
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    const double count = std::ceil(2.0 * reach[a] / spacing[a]) + 1.0;
    voxels *= count;
    size[axis] = static_cast<int>(std::min(count, 1.0 * std::numeric_limits<int>::max()));
  }
  if (!(voxels * BytesPerVoxel < static_cast<double>(AvailableMemoryBytes())))
  {
    throw InputError(
        "a block with such small voxels needs more than the free memory; give a coarser --spacing");
  }
  const Vector3 last(size[0] - 1, size[1] - 1, size[2] - 1);
  return {size, -0.5 * (direction * spacing.cwiseProduct(last)), spacing, direction};
}

std::string HandText()
{
  // Unprotected, a sphere of 1.5 mm would cut down to the nerve's axis.
  return "time_s,x_mm,y_mm,z_mm\n0,-3,0,13\n1,-3,0,9.7\n3,-3,0,5.5\n6,9,0,5.5\n7,9,0,13\n";
}

SceneSettings SceneOf(const std::filesystem::path& volume, const std::filesystem::path& mask)
{
  SceneStructure bone;
  bone.Name = "bone";
  bone.File = volume;
  bone.Iso = DrillPhantom::Iso;
  bone.Drill.Wear = 0.5;
  bone.Drill.Drag = 0.002;
  bone.Drill.Vibration = 0.2;
  SceneStructure nerve;
  nerve.Name = "nerve";
  nerve.File = mask;
  nerve.IsTouchable = false;
  nerve.IsForbidden = true;
  nerve.AlarmDistance = 1.0;
  SceneSettings settings;
  settings.Structures = {bone, nerve};
  settings.Tool.Radius = 1.5;
  settings.Tool.Points = 0;
  settings.Placement.Scale = 1.0;
  return settings;
}
} // namespace

double DrillPhantom::BoneDistance(const Vector3& pointWorld)
{
  const Vector3 half(HalfWidth, HalfWidth, HalfHeight);
  const Vector3 beyond = pointWorld.cwiseAbs() - half;
  const double block = beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  return std::max(block, CanalRadius - std::hypot(pointWorld[0] - CanalX, pointWorld[1]));
}

double DrillPhantom::NerveDistance(const Vector3& pointWorld)
{
  return std::max(std::hypot(pointWorld[0] - NerveX, pointWorld[2] - NerveZ) - NerveRadius,
                  std::abs(pointWorld[1]) - HalfWidth);
}

DrillPhantom MakeDrillPhantom(const Vector3& spacing, const Matrix3& direction,
                              const ProgressFunction& progress)
{
  const FieldGrid grid = GridRoundBlock(spacing, direction);
  DrillPhantom phantom{EmptyImageOf(grid), EmptyImageOf(grid)};
  phantom.Ct->AllocateScalars(VTK_SHORT, 1);
  phantom.Nerve->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* value = static_cast<short*>(phantom.Ct->GetScalarPointer());
  auto* label = static_cast<unsigned char*>(phantom.Nerve->GetScalarPointer());
  const std::array<int, 3>& size = grid.Size();
  // Bone fraction of a voxel, as if the surface were flat.
  const double width = spacing.maxCoeff();
  for (int k = 0; k < size[2]; ++k)
  {
    if (!progress(static_cast<double>(k) / size[2], "making the phantom"))
    {
      throw Cancelled();
    }
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const Vector3 place = grid.PointWorld(Vector3(i, j, k));
        const double part = std::clamp(0.5 - DrillPhantom::BoneDistance(place) / width, 0.0, 1.0);
        *value++ = static_cast<short>(std::lround(AirValue + part * (BoneValue - AirValue)));
        *label++ = DrillPhantom::NerveDistance(place) < 0.0 ? 1 : 0;
      }
    }
  }
  return phantom;
}

void WriteDrillPhantom(const DrillPhantom& phantom, const std::filesystem::path& folder,
                       const std::string& ending)
{
  const std::filesystem::path volume = folder / ("volume." + ending);
  const std::filesystem::path mask = folder / ("mask." + ending);
  WriteImage(volume, phantom.Ct);
  WriteImage(mask, phantom.Nerve);
  WriteWholeFile(folder / "block.scene.json", SceneText(SceneOf(volume, mask), folder));
  WriteWholeFile(folder / "hand.csv", HandText());
  WriteWholeFile(folder / "strokes.json",
                 "{\"format\": \"palpate-drill\",\n \"actions\": [{\"time_s\": 0.9, \"do\": "
                 "\"start\"}, {\"time_s\": 6.5, \"do\": \"stop\"}]}\n");
}
} // namespace palpate
