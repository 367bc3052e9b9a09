#pragma once

#include "MeshGap.h"
#include "PalpateStudyModule.h"
#include "StudyJobs.h"
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
/// first needed (1 us per triangle), and again when it changes; one of many triangles by a job.
/// Owner thread only.
class PALPATESTUDY_EXPORT MeasuredSurfaces
{
public:
  /// The most that are prepared by the call that needs them.
  static constexpr vtkIdType MostTrianglesAtOnce = 50000;

  /// Keeps the address.
  explicit MeasuredSurfaces(StudyJobs& jobs) : Jobs(jobs) {}
  MeasuredSurfaces(const MeasuredSurfaces&) = delete;
  MeasuredSurfaces& operator=(const MeasuredSurfaces&) = delete;
  ~MeasuredSurfaces();

  /// By the structure's id.
  void Show(const std::map<int, vtkPolyData*>& surfaces);

  struct Place
  {
    int StructureId = 0;
    Vector3 PointWorld = Vector3::Zero();
  };
  /// Whether a surface that was asked for is still being prepared.
  bool IsPreparing() const;

  /// The nearest point of the surfaces, mm; of one structure only unless `id` is 0. None if
  /// nothing is nearer than `most`, or if a surface that might be is being prepared.
  std::optional<Place> Nearest(const Vector3& pointWorld, double most, int id = 0);

  /// These fail if a structure has no surface, or one that is being prepared, or the kernel does
  /// (SurfacePaths, MeasureThickness, FindMeshGap).
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
    std::optional<StudyJobs::Id> Job;
  };
  void Clear(Surface& surface);
  const SurfacePaths* Prepare(int id, Surface& surface);
  void StartJob(int id, Surface& surface);
  Status Prepare(int id, const SurfacePaths*& prepared);

  struct Gap
  {
    std::shared_ptr<const SurfacePaths> One;
    std::shared_ptr<const SurfacePaths> Other;
    MeshGap Found;
  };

  StudyJobs& Jobs;
  std::map<int, Surface> All;
  Gap LastGap; ///< of two surfaces: it does not depend on the places that are touched
};
} // namespace palpate
