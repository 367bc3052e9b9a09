#include "GuideDistance.h"

#include "AxisWeights.h"
#include "FieldRun.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"
#include "NearestOnMesh.h"
#include "Progress.h"
#include "ProtectedSurface.h"
#include "Refusal.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double Coarsest = 8.0;  // of the wanted step
constexpr double Deviation = 1.0; // steps
// Beyond the reach: there, distances are cut off, which the Gaussian and the B-spline spread.
constexpr double SpreadMargin = 6.0; // steps
constexpr const char* Stage = "guide";

VoxelCenters GridAround(const Eigen::AlignedBox3d& box, double reach, double step)
{
  VoxelCenters grid;
  const Vector3 margin = Vector3::Constant(reach + (SpreadMargin + 1.0) * step);
  const Vector3 size = box.sizes() + 2.0 * margin;
  grid.Origin = box.min() - margin;
  grid.Axes = step * Matrix3::Identity();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = 1 + static_cast<int>(std::ceil(size[static_cast<Eigen::Index>(axis)] / step));
  }
  return grid;
}

double NodesOf(const VoxelCenters& grid)
{
  return 1.0 * grid.Size[0] * grid.Size[1] * grid.Size[2];
}

// With the wanted step, or the one at which there are few enough nodes.
VoxelCenters ChosenGrid(const SceneStructure& structure, const Eigen::AlignedBox3d& box,
                        const GuideReach& reach)
{
  const double most = Coarsest * reach.Step;
  double step = reach.Step;
  VoxelCenters grid = GridAround(box, reach.Reach, step);
  while (NodesOf(grid) > MostGuideNodes && step <= most)
  {
    step *= 1.05;
    grid = GridAround(box, reach.Reach, step);
  }
  if (step > most)
  {
    Refuse(structure.File,
           "has a structure too large for a guide of so short a range: " + TitleOf(structure),
           "give the guide a longer range");
  }
  return grid;
}

class DistanceSamples
{
public:
  DistanceSamples(const IndexedMesh& mesh, const VoxelCenters& grid, double band)
      : Grid(grid), Band(band)
  {
    const bool isConsistent = DescribeTopology(mesh).IsConsistent();
    RequireInput(FindInside(mesh, grid, isConsistent, this->Inside));
    RequireInput(NearestOnMesh::Make(mesh, this->Surface));
    this->Values.resize(this->Inside.size());
  }

  std::vector<float> Make(const ProgressFunction& progress)
  {
    for (int k = 0; k < this->Grid.Size[2]; ++k)
    {
      ReportProgress(progress, 1.0 * k / this->Grid.Size[2], Stage);
      for (int j = 0; j < this->Grid.Size[1]; ++j)
      {
        this->MakeRow(j, k);
      }
    }
    return std::move(this->Values);
  }

private:
  // Far from the surface, skips the nodes that are beyond the band too.
  void MakeRow(int j, int k)
  {
    const double step = this->Grid.Axes(0, 0);
    const auto rows = static_cast<std::size_t>(k) * static_cast<std::size_t>(this->Grid.Size[1]);
    const auto length = static_cast<std::size_t>(this->Grid.Size[0]);
    const std::size_t start = (rows + static_cast<std::size_t>(j)) * length;
    std::size_t i = 0;
    while (i < length)
    {
      const Vector3 at = this->Grid.Origin + step * Vector3(static_cast<double>(i), j, k);
      const NearestOnMesh::Result found = this->Surface.FindFrom(at, this->Start);
      this->Start = found.Triangle;
      const double free = std::max(0.0, found.Distance - this->Band) / step;
      const std::size_t end = std::min(length, i + 1 + static_cast<std::size_t>(free));
      const auto distance = static_cast<float>(std::min(found.Distance, this->Band));
      for (; i < end; ++i)
      {
        this->Values[start + i] = this->Inside[start + i] != 0 ? -distance : distance;
      }
    }
  }

  const VoxelCenters& Grid;
  double Band;   // mm
  int Start = 0; // triangle
  NearestOnMesh Surface;
  std::vector<std::uint8_t> Inside;
  std::vector<float> Values;
};

std::shared_ptr<const ScalarField> SmoothField(std::vector<float> values,
                                               const VoxelCenters& centers,
                                               const ProgressFunction& progress)
{
  std::array<int, 3> size = centers.Size;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int count = size[axis];
    values = AxisWeights({count, count, 0.0, 1.0, Deviation}).Apply(values, size, axis);
  }
  const FieldGrid grid(size, centers.Origin, centers.Axes.diagonal(), Matrix3::Identity());
  FieldBuilder builder(grid);
  builder.AddChannel(SamplesOfGrid(values.data(), grid));
  builder.KeepAll();
  builder.SetInterpolation(FieldInterpolation::TricubicBSpline);
  std::shared_ptr<const ScalarField> field;
  RequireInput(RunBuilder(builder, Stage, progress, field));
  return field;
}
} // namespace

GuideReach ReachOfGuides(const SceneSettings& scene, int id)
{
  constexpr double Rounding = 5.0; // mm
  constexpr double StepsPerRange = 10.0;
  GuideReach reach;
  double shortest = std::numeric_limits<double>::infinity();
  for (const GuideSettings& guide : scene.Guides)
  {
    if (guide.HasStructure() && guide.Structure == id)
    {
      const double far = std::abs(guide.Distance) + guide.Range;
      reach.Reach = std::max(reach.Reach, Rounding * std::ceil(far / Rounding));
      shortest = std::min(shortest, guide.Range);
    }
  }
  if (reach.Reach > 0.0)
  {
    reach.Step = std::exp2(std::floor(std::log2(shortest / StepsPerRange)));
  }
  return reach;
}

std::shared_ptr<const StructureDistance> MakeGuideDistance(const SceneStructure& structure,
                                                           const SceneProduct& source,
                                                           const GuideReach& reach,
                                                           const ProgressFunction& progress)
{
  constexpr double SurfacePart = 0.2;
  constexpr double SamplesEnd = 0.7;
  const IndexedMesh mesh =
      ToIndexedMesh(ProtectedSurfaceOf(structure, source, PartOf(progress, 0.0, SurfacePart)));
  if (mesh.Triangles.empty())
  {
    Refuse(structure.File, "has no triangles, so it cannot guide", "choose another structure");
  }
  Eigen::AlignedBox3d box;
  for (const Vector3& point : mesh.Points)
  {
    box.extend(point);
  }
  const VoxelCenters grid = ChosenGrid(structure, box, reach);
  const double band = reach.Reach + SpreadMargin * grid.Axes(0, 0);
  std::vector<float> values =
      DistanceSamples(mesh, grid, band).Make(PartOf(progress, SurfacePart, SamplesEnd));
  std::shared_ptr<const StructureDistance> made;
  RequireInput(StructureDistance::Make(
      SmoothField(std::move(values), grid, PartOf(progress, SamplesEnd, 1.0)), reach.Reach, made));
  return made;
}
} // namespace palpate
