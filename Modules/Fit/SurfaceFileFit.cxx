#include "SurfaceFileFit.h"

#include "ClosedMesh.h"
#include "DecimalText.h"
#include "FitHints.h"
#include "FitStructure.h"
#include "KernelWatch.h"
#include "MeshConversion.h"
#include "MeshDecimation.h"
#include "ModelSurface.h"
#include "RepairRemarks.h"
#include "SphericalParametrisation.h"
#include "StageClock.h"
#include "SurfaceTopology.h"
#include "TriangleMesh.h"
#include "Units.h"

#include <memory>
#include <utility>

namespace palpate
{
namespace
{
void RemarkOnMends(const ClosedMesh& closed, FitResult& result)
{
  const MeshMends& mends = closed.Mends;
  std::string done;
  const auto add = [&done](int count, const char* one, const char* several)
  {
    if (count > 0)
    {
      done += (done.empty() ? "" : ", ") + CountText(count, one, several);
    }
  };
  add(mends.DroppedTriangles, "triangle without three points dropped",
      "triangles without three points dropped");
  add(mends.Duplicates, "triangle that was there twice dropped",
      "triangles that were there twice dropped");
  add(mends.DroppedParts, "other part of it left out", "other parts of it left out");
  add(mends.ReversedTriangles, "triangle turned to face outwards",
      "triangles turned to face outwards");
  if (!done.empty())
  {
    result.Notes.push_back("the surface was mended: " + done);
  }
  if (!closed.Fault.empty())
  {
    result.Notes.push_back("the surface " + closed.Fault + ": it was made again from voxels of " +
                           SignificantText(closed.VoxelSize, 3) + " mm inside it");
    if (closed.Added.AreaPercent > 0.0)
    {
      result.Notes.push_back(SignificantText(closed.Added.AreaPercent, 3) +
                             " % of its area is new, up to " + FixedText(closed.Added.Distance, 1) +
                             " mm from the surface that was given, at " +
                             PlaceText(closed.Added.Farthest));
    }
    RemarkOnChanges(closed.Topology, result);
  }
  else if (closed.Mesh.Triangles.size() < static_cast<std::size_t>(closed.GivenTriangles / 2))
  {
    result.Notes.push_back("the surface was coarsened from " +
                           std::to_string(closed.GivenTriangles) + " to " +
                           std::to_string(closed.Mesh.Triangles.size()) + " triangles");
  }
}

// Nothing that is felt is so small; files in metres are common.
void RemarkOnUnit(FitResult& result)
{
  constexpr double Smallest = 1.0; // mm
  if (const double diagonal = result.Surface->GetLength(); diagonal < Smallest)
  {
    result.Notes.push_back("the surface is only " + SignificantText(diagonal, 2) +
                           " mm large; its coordinates are taken as mm");
  }
}

void RunClosedMesh(vtkPolyData* surface, FitSurface& made, const ProgressFunction& progress)
{
  FitResult& result = made.Found;
  StageClock clock(result.Seconds);
  KernelWatch watch(progress, "surface");
  TriangleMesh triangles = TrianglesOf(surface, result.Input);
  ClosedMeshSettings settings;
  settings.Repairs = result.Settings.Repairs;
  settings.Part = result.Settings.WantsOneComponent() ? result.Settings.Component : 0;
  ClosedMesh closed;
  const Status status =
      MakeClosedMesh({std::move(triangles.PointsWorld), std::move(triangles.Triangles)}, settings,
                     watch.Of(0.0, 1.0), closed);
  watch.Require();
  if (!status.IsOk())
  {
    result.State = FitResult::Outcome::BadInput;
    result.Message = status.Message();
    result.OptionHint = HintForOpenSurface(result.Settings, OptionWords);
    result.WindowHint = HintForOpenSurface(result.Settings, WindowWords);
    return;
  }
  RemarkOnMends(closed, result);
  result.Details.SurfaceRepair = closed.Topology;
  result.Details.AddedAreaPercent = closed.Added.AreaPercent;
  result.SurfaceMilliliters = DescribeTopology(closed.Mesh).Volume / CubicMillimetersPerMilliliter;
  result.Surface = ToPolyData(closed.Mesh);
  made.Boundary = result.Surface;
  RemarkOnUnit(result);
  clock.EndStage("surface");
}
} // namespace

FitSurface MakeFitSurface(const std::filesystem::path& file, vtkPolyData* surface,
                          const FitSettings& settings, const ProgressFunction& progress)
{
  FitSurface made;
  FitResult& result = made.Found;
  result.Input = file;
  result.CaseName = CaseNameOf(file);
  result.Structure.Name = result.CaseName;
  result.Settings = settings;
  result.IsOfSurface = true;
  RunClosedMesh(surface, made, progress);
  made.IsOver = !result.Message.empty();
  return made;
}

std::string MapSurfaceFile(FitResult& result, const ProgressFunction& progress)
{
  KernelWatch watch(progress, "surface");
  auto mapped = std::make_shared<MappedSurface>();
  mapped->Mesh = ToIndexedMesh(result.Surface);
  mapped->Topology = result.Details.SurfaceRepair;
  const DecimationSettings coarse{MappedSurfaceSettings().Triangles};
  Status status = Status::Success();
  if (mapped->Mesh.Triangles.size() > static_cast<std::size_t>(coarse.Triangles))
  {
    status = DecimateMesh(mapped->Mesh, coarse, {}, watch.Of(0.0, 0.6), mapped->Mesh);
  }
  SphericalParametrisation map;
  if (status.IsOk())
  {
    status = ParametriseOnSphere(mapped->Mesh, watch.Of(0.6, 1.0), map);
  }
  if (status.IsOk())
  {
    status = CheckSphereMap(map.Quality);
  }
  watch.Require();
  if (!status.IsOk())
  {
    return status.Message();
  }
  mapped->Directions = std::move(map.Directions);
  mapped->Map = map.Quality;
  result.Details.Mapped = std::move(mapped);
  return {};
}
} // namespace palpate
