#pragma once

#include "MeshGap.h"
#include "PalpateStudyModule.h"
#include "SurfacePaths.h"
#include "WallThickness.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <optional>

namespace palpate
{
/// Displayed surfaces of structures, on which distances are measured. Each is prepared when it is
/// first needed (1 us per triangle), and again when it changes.
class PALPATESTUDY_EXPORT MeasuredSurfaces
{
public:
  /// By the structure's id.
  void Show(const std::map<int, vtkPolyData*>& surfaces);

  struct Place
  {
    int StructureId = 0;
    Vector3 PointWorld = Vector3::Zero();
  };
  /// The nearest point of the surfaces, mm; of one structure only unless `id` is 0. None if
  /// nothing is nearer than `most`.
  std::optional<Place> Nearest(const Vector3& pointWorld, double most, int id = 0);

  /// These fail if a structure has no surface, or the kernel does (SurfacePaths, MeasureThickness,
  /// FindMeshGap).
  Status FindPath(int id, const Vector3& from, const Vector3& to, SurfacePaths::Path& path);
  Status FindThickness(int id, const Vector3& pointWorld, WallThickness& wall);
  Status FindGap(int one, int other, MeshGap& gap);

private:
  struct Surface
  {
    vtkSmartPointer<vtkPolyData> Source;
    vtkMTimeType Time = 0;
    std::shared_ptr<const SurfacePaths> Paths; ///< null until it is needed
    Status Problem = Status::Success();
  };
  const SurfacePaths* Prepare(Surface& surface);
  Status Prepare(int id, const SurfacePaths*& prepared);

  struct Gap
  {
    std::shared_ptr<const SurfacePaths> One;
    std::shared_ptr<const SurfacePaths> Other;
    MeshGap Found;
  };

  std::map<int, Surface> All;
  Gap LastGap; ///< of two surfaces: it does not depend on the places that are touched
};
} // namespace palpate
