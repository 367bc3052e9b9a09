#include "ClosedMesh.h"

#include "DecimalText.h"
#include "GenusZeroSurface.h"
#include "MeshCrossings.h"
#include "MeshDecimation.h"
#include "MeshDistances.h"
#include "MeshRefinement.h"
#include "MeshVoxels.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// Numbers points in the order in which triangles use them; all are used.
void NumberByFirstUse(IndexedMesh& mesh)
{
  std::vector<int> numbers(mesh.Points.size(), -1);
  std::vector<Vector3> points;
  points.reserve(mesh.Points.size());
  for (std::array<int, 3>& triangle : mesh.Triangles)
  {
    for (int& corner : triangle)
    {
      int& number = numbers[static_cast<std::size_t>(corner)];
      if (number < 0)
      {
        number = static_cast<int>(points.size());
        points.push_back(mesh.Points[static_cast<std::size_t>(corner)]);
      }
      corner = number;
    }
  }
  mesh.Points = std::move(points);
}

std::string CrossingFault(const IndexedMesh& mesh)
{
  MeshCrossings crossings;
  const Status status = FindMeshCrossings(mesh, {1, 1}, crossings);
  if (!status.IsOk())
  {
    return "has points that are too far apart";
  }
  if (crossings.Count == 0)
  {
    return {};
  }
  const Vector3& place = crossings.Pairs.front().Place;
  return "has triangles that cross each other, such as at (" + FixedText(place.x(), 1) + ", " +
         FixedText(place.y(), 1) + ", " + FixedText(place.z(), 1) + ") mm";
}

AddedSurface AddedTo(const IndexedMesh& given, const IndexedMesh& made, double near)
{
  AddedSurface added;
  ComparedSurface from;
  ComparedSurface to;
  if (!ComparedSurface::Make(given, from).IsOk() || !ComparedSurface::Make(made, to).IsOk())
  {
    return added;
  }
  const DistanceSamples samples = to.SamplesFrom(from);
  added.AreaPercent = 100.0 * (1.0 - ShareWithin(samples, near));
  if (samples.Largest > near)
  {
    added.Distance = samples.Largest;
    added.Farthest = samples.Farthest;
  }
  return added;
}

// Only bodies far apart: what else a repair changes is told.
Status CheckGaps(const TopologyReport& report)
{
  TopologyLimits limits;
  limits.ChangedPercent = std::numeric_limits<double>::infinity();
  limits.CavityDiameter = std::numeric_limits<double>::infinity();
  return CheckTopology(report, limits);
}

/// The steps of MakeClosedMesh.
class Maker
{
public:
  Maker(const ClosedMeshSettings& settings, const KernelProgress& progress, ClosedMesh& made)
      : Settings(&settings), Progress(&progress), Made(&made)
  {
  }

  Status Run()
  {
    IndexedMesh& mesh = this->Made->Mesh;
    this->Made->GivenTriangles = static_cast<int>(mesh.Triangles.size());
    Status status = MendMesh(mesh, this->Settings->Part, this->Made->Mends);
    if (!status.IsOk() || !this->Report(0.1))
    {
      return status.IsOk() ? Cancelled() : status;
    }
    NumberByFirstUse(mesh);
    const SurfaceTopology topology = DescribeTopology(mesh);
    std::string fault = FaultOfGenusZero(topology);
    if (!this->Report(0.2))
    {
      return Cancelled();
    }
    fault = fault.empty() ? CrossingFault(mesh) : fault;
    if (!this->Report(0.5))
    {
      return Cancelled();
    }
    if (!fault.empty())
    {
      status = this->Settings->Repairs ? this->Repair(fault, topology.IsConsistent())
                                       : Status::Failure(fault);
    }
    return status.IsOk() ? this->Resample() : status;
  }

private:
  static Status Cancelled() { return Status::Failure("Cancelled."); }
  bool Report(double fraction) const { return !*this->Progress || (*this->Progress)(fraction); }

  Status Repair(const std::string& fault, bool isConsistent)
  {
    IndexedMesh& mesh = this->Made->Mesh;
    const VoxelCenters grid = CubesAround(mesh, this->Settings->RepairVoxels);
    VoxelMask mask;
    Status status = FindInside(mesh, grid, isConsistent, mask.Inside);
    if (!status.IsOk())
    {
      return status;
    }
    const double side = grid.Axes(0, 0);
    mask.Size = grid.Size;
    mask.Spacing = {side, side, side};
    if (mask.Count() == 0)
    {
      return Status::Failure(fault + " and encloses no volume");
    }
    GenusZeroSettings settings;
    settings.Topology.BridgeParts = true;
    GenusZeroSurface surface;
    status = MakeGenusZeroSurface(
        mask, settings, [this](double part) { return this->Report(0.5 + 0.2 * part); }, surface);
    if (!status.IsOk())
    {
      return status;
    }
    status = CheckGaps(surface.Topology);
    if (!status.IsOk())
    {
      return status;
    }
    const auto place = [&](const Vector3& point) -> Vector3 { return grid.Origin + point; };
    for (Vector3& point : surface.Mesh.Points)
    {
      point = place(point);
    }
    this->Made->Added = AddedTo(mesh, surface.Mesh, 2.0 * side);
    mesh = std::move(surface.Mesh);
    this->Made->Topology = surface.Topology;
    TopologyReport& report = this->Made->Topology;
    for (TopologyChange* change : {&report.DroppedParts, &report.Bridges, &report.FilledCavities,
                                   &report.CutHandles, &report.FilledHandles})
    {
      change->LargestCentre = place(change->LargestCentre);
    }
    this->Made->Fault = fault;
    this->Made->VoxelSize = side;
    return Status::Success();
  }

  Status Resample()
  {
    IndexedMesh& mesh = this->Made->Mesh;
    const int most = this->Settings->MostTriangles;
    if (mesh.Triangles.size() > static_cast<std::size_t>(most))
    {
      Status status = DecimateMesh(
          mesh, {most}, {}, [this](double part) { return this->Report(0.7 + 0.3 * part); }, mesh);
      if (!status.IsOk())
      {
        return status;
      }
    }
    // Edges of equal triangles that cover the area.
    const double area = DescribeTopology(mesh).Area;
    const double edge =
        std::sqrt(4.0 / std::sqrt(3.0) * area / std::max(1, this->Settings->FewestTriangles));
    SplitLongEdges(mesh, 2.0 * edge, most);
    return this->Report(1.0) ? Status::Success() : Cancelled();
  }

  const ClosedMeshSettings* Settings;
  const KernelProgress* Progress;
  ClosedMesh* Made;
};
} // namespace

Status MakeClosedMesh(IndexedMesh mesh, const ClosedMeshSettings& settings,
                      const KernelProgress& progress, ClosedMesh& made)
{
  made = {};
  made.Mesh = std::move(mesh);
  return Maker(settings, progress, made).Run();
}
} // namespace palpate
