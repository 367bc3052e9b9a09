#pragma once

#include "MeshGap.h"
#include "OrganModel.h"
#include "PalpateStudyModule.h"
#include "StudyJobs.h"
#include "SurfaceGeodesics.h"
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

  using Models = std::map<int, std::shared_ptr<const OrganModel>>;
  /// By the structure's id; the models of surfaces that are drawings of them.
  void Show(const std::map<int, vtkPolyData*>& surfaces, const Models& models = {});

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

  /// What lengths along a surface are measured on: its triangles, or its model if it has one, as
  /// `palpate measure` does, which takes some 0.1 s.
  enum class PathOn
  {
    Triangles,
    Model
  };
  /// These fail if a structure has no surface, or one that is being prepared, or the kernel does
  /// (SurfacePaths, SurfaceGeodesics, MeasureThickness, FindMeshGap).
  Status FindPath(int id, const Vector3& from, const Vector3& to, PathOn on,
                  SurfacePaths::Path& path);
  Status FindThickness(int id, const Vector3& pointWorld, WallThickness& wall);
  Status FindGap(int one, int other, MeshGap& gap);

private:
  struct Surface
  {
    vtkSmartPointer<vtkPolyData> Source;
    vtkMTimeType Time = 0;
    std::shared_ptr<const SurfacePaths> Paths; ///< null until it is needed
    std::shared_ptr<const OrganModel> Model;   ///< null: of none
    std::optional<SurfaceGeodesics> OnModel;   ///< once it is needed
    Status Problem = Status::Success();
    std::optional<StudyJobs::Id> Job;
  };
  void Clear(Surface& surface);
  const SurfacePaths* Prepare(int id, Surface& surface);
  void StartJob(int id, Surface& surface);
  Status Prepare(int id, const SurfacePaths*& prepared);
  static Status FindOnModel(Surface& surface, const Vector3& from, const Vector3& to,
                            SurfacePaths::Path& path);

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
