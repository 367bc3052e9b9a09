#pragma once

#include "ModelPaths.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// Lengths along a body's surface (mm): of a model on the model itself, of triangles along them.
/// Immutable; queries are thread-safe and allocate.
class SurfaceGeodesics
{
public:
  struct Length
  {
    Vector3 From;                      ///< on the surface
    Vector3 To;                        ///< on the surface
    double Along = 0.0;                ///< mm
    double Direct = 0.0;               ///< mm, through space
    std::optional<double> Uncertainty; ///< mm, of a model: what its chords leave open
    std::vector<Vector3> Points;       ///< of the path, from end to end
  };
  /// Triangles: of more, Find starts once, since twice would take some 20 s.
  static constexpr std::size_t MostForShortest = 150000;

  /// Fails as ModelPaths::Make.
  static Status OfModel(const OrganModel& model, SurfaceGeodesics& made);
  /// Fails as SurfacePaths::Make.
  static Status OfMesh(IndexedMesh mesh, SurfaceGeodesics& made);

  /// Between the surface's points that are nearest to these (mm, finite). Fails if no path connects
  /// them, and if `progress` cancels.
  Status Find(const Vector3& from, const Vector3& to, const KernelProgress& progress,
              Length& found) const;
  /// From the surface's point nearest to `from` to the points of Mesh(); infinite on parts that are
  /// not connected. Fails only if `progress` cancels.
  Status Distances(const Vector3& from, const KernelProgress& progress,
                   std::vector<double>& distances) const;

  bool IsOnModel() const noexcept { return this->OnModel != nullptr; }
  /// The triangles, or a drawing of the model.
  const IndexedMesh& Mesh() const noexcept;

private:
  std::shared_ptr<const ModelPaths> OnModel;
  std::shared_ptr<const SurfacePaths> OnTriangles; ///< unless it is a model
};
} // namespace palpate
