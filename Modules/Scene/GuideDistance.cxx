#include "GuideDistance.h"

#include "AxisWeights.h"
#include "DecimalText.h"
#include "FieldRun.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"
#include "NearestOnMesh.h"
#include "Progress.h"
#include "ProtectedSurface.h"
#include "Refusal.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <array>
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
constexpr double StepsPerRange = 10.0;
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
    // An absurdly short range gives more than an integer holds.
    const double steps = std::ceil(size[static_cast<Eigen::Index>(axis)] / step);
    grid.Size[axis] = 1 + static_cast<int>(std::min(steps, MostGuideNodes));
  }
  return grid;
}

double NodesOf(const VoxelCenters& grid)
{
  return 1.0 * grid.Size[0] * grid.Size[1] * grid.Size[2];
}

// Far from a mesh, a search for its nearest point takes the longer, the more triangles it has.
double MostNodes(std::size_t triangles, double reach)
{
  constexpr double Near = 100.0;  // mm
  constexpr double Few = 100'000; // triangles
  return reach <= Near ? MostGuideNodes
                       : 0.5 * MostGuideNodes /
                             std::sqrt(std::max(1.0, static_cast<double>(triangles) / Few));
}

// With the wanted step, or the one at which there are few enough nodes.
VoxelCenters ChosenGrid(const SceneStructure& structure, const Eigen::AlignedBox3d& box,
                        const GuideReach& reach, double nodes)
{
  double step = reach.Step;
  VoxelCenters grid = GridAround(box, reach.Reach, step);
  while (NodesOf(grid) > nodes)
  {
    step *= 1.05;
    grid = GridAround(box, reach.Reach, step);
  }
  if (step > Coarsest * reach.Step)
  {
    // The shortest one with a step of which this is at most the coarsest multiple.
    const double range = StepsPerRange * std::exp2(std::ceil(std::log2(step / Coarsest)));
    Refuse(structure.File,
           "has a structure too large for the ranges of its guides, which act up to " +
               SignificantText(reach.Reach) + " mm from it: " + TitleOf(structure),
           "make \"range_mm\" of each at least " + SignificantText(range) +
               ", or \"distance_mm\" and \"range_mm\" of the others smaller");
  }
  return grid;
}

// Distances at the nodes of a grid, cut off at a band. Blocks of nodes beyond the band are found by
// their centres; the nodes of the others are searched many at a time, which takes a third of the
// time.
class DistanceSamples
{
public:
  DistanceSamples(const IndexedMesh& mesh, const VoxelCenters& grid, double band)
      : Grid(grid), Band(band)
  {
    const bool isConsistent = DescribeTopology(mesh).IsConsistent();
    RequireInput(FindInside(mesh, grid, isConsistent, this->Inside));
    RequireInput(NearestOnMesh::Make(mesh, this->Surface));
    const auto far = static_cast<float>(band);
    this->Values.resize(this->Inside.size());
    std::transform(this->Inside.begin(), this->Inside.end(), this->Values.begin(),
                   [far](std::uint8_t inside) { return inside != 0 ? -far : far; });
  }

  std::vector<float> Make(const ProgressFunction& progress)
  {
    for (int k = 0; k < this->Grid.Size[2]; k += BlockSide)
    {
      ReportProgress(progress, 1.0 * k / this->Grid.Size[2], Stage);
      this->MakeLayer(k);
    }
    return std::move(this->Values);
  }

private:
  static constexpr int BlockSide = 4; // nodes

  Vector3 PlaceOf(double i, double j, double k) const
  {
    return this->Grid.Origin + this->Grid.Axes(0, 0) * Vector3(i, j, k);
  }

  // Of a layer of blocks from slice k on, those that are not beyond the band.
  std::vector<std::array<int, 2>> NearBlocks(int k) const
  {
    constexpr double Half = 0.5 * (BlockSide - 1);
    std::vector<std::array<int, 2>> blocks;
    std::vector<Vector3> centers;
    for (int j = 0; j < this->Grid.Size[1]; j += BlockSide)
    {
      for (int i = 0; i < this->Grid.Size[0]; i += BlockSide)
      {
        blocks.push_back({i, j});
        centers.push_back(this->PlaceOf(i + Half, j + Half, k + Half));
      }
    }
    const double most = this->Band + std::sqrt(3.0) * Half * this->Grid.Axes(0, 0);
    const std::vector<NearestOnMesh::Result> found = this->Surface.FindAll(centers);
    std::vector<std::array<int, 2>> near;
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      if (found[n].Distance <= most)
      {
        near.push_back(blocks[n]);
      }
    }
    return near;
  }

  void MakeLayer(int k)
  {
    const std::array<int, 3>& size = this->Grid.Size;
    std::vector<std::size_t> nodes;
    std::vector<Vector3> places;
    const auto add = [&](int i, int j, int slice)
    {
      nodes.push_back((static_cast<std::size_t>(slice) * static_cast<std::size_t>(size[1]) +
                       static_cast<std::size_t>(j)) *
                          static_cast<std::size_t>(size[0]) +
                      static_cast<std::size_t>(i));
      places.push_back(this->PlaceOf(i, j, slice));
    };
    for (const auto& [left, front] : this->NearBlocks(k))
    {
      for (int n = 0; n < BlockSide * BlockSide * BlockSide; ++n)
      {
        const int i = left + n % BlockSide;
        const int j = front + n / BlockSide % BlockSide;
        const int slice = k + n / (BlockSide * BlockSide);
        if (i < size[0] && j < size[1] && slice < size[2])
        {
          add(i, j, slice);
        }
      }
    }
    const std::vector<NearestOnMesh::Result> found = this->Surface.FindAll(places);
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      const auto distance = static_cast<float>(std::min(found[n].Distance, this->Band));
      this->Values[nodes[n]] = this->Inside[nodes[n]] != 0 ? -distance : distance;
    }
  }

  const VoxelCenters& Grid;
  double Band; // mm
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
  const VoxelCenters grid =
      ChosenGrid(structure, box, reach, MostNodes(mesh.Triangles.size(), reach.Reach));
  const double band = reach.Reach + SpreadMargin * grid.Axes(0, 0);
  std::vector<float> values =
      DistanceSamples(mesh, grid, band).Make(PartOf(progress, SurfacePart, SamplesEnd));
  std::shared_ptr<const StructureDistance> made;
  RequireInput(StructureDistance::Make(
      SmoothField(std::move(values), grid, PartOf(progress, SamplesEnd, 1.0)), reach.Reach, made));
  return made;
}
} // namespace palpate
