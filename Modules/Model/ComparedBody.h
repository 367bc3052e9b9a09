#pragma once

#include "DistanceSamples.h"
#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "NearestOnMesh.h"
#include "OrganModel.h"
#include "Status.h"
#include "VoxelMask.h"

#include <memory>
#include <vector>

namespace palpate
{
class ModelFoot;

/// A mask on its grid.
struct PlacedMask
{
  VoxelMask Voxels;
  IndexToWorld ToWorld; ///< of image indices
};

/// Points of compared bodies are at most this far from the origin along each axis, mm.
constexpr double FarthestCompared = 1e7;

/// One of two bodies that are compared: a mask, a triangle surface or a model, as a surface with
/// points as dense as measurements need (world mm, patient LPS). Immutable.
class ComparedBody
{
public:
  /// The mask's boundary half way between voxel centres (MakeMaskBoundary). Fails as that does.
  static Status OfMask(VoxelMask mask, const IndexToWorld& toWorld, ComparedBody& made);
  /// The mask's shape, closer to what it was drawn from than its steps (MakeMaskSurface with all
  /// components); still with the volume of its voxels. Fails as that does.
  static Status OfMaskShape(VoxelMask mask, const IndexToWorld& toWorld, ComparedBody& made);
  /// A surface, closed or open: equal points are merged, triangles turned outwards, and long edges
  /// split, so that the surface has some 20,000 points. Fails for a mesh without triangles with
  /// area, points that are not finite, and indices out of range.
  static Status OfMesh(IndexedMesh mesh, ComparedBody& made);
  /// A model, at points on itself; distances from it are those from the model, not from triangles.
  /// Fails if its points are not finite or enclose no volume. All fail beyond FarthestCompared.
  static Status OfModel(const OrganModel& model, ComparedBody& made);

  const IndexedMesh& Surface() const noexcept { return this->Mesh; }
  /// Triangles that enclose the body: the surface; of a model, whose drawing lies inside it where
  /// it is convex, the drawing scaled to the model's volume.
  const IndexedMesh& Enclosure() const noexcept
  {
    return this->Scaled != nullptr ? *this->Scaled : this->Mesh;
  }
  /// Of a model only: the same points with a quarter of the triangles. Allocates.
  IndexedMesh CoarseSurface() const;
  bool IsClosed() const noexcept { return this->Holes == 0; }
  int HoleCount() const noexcept { return this->Holes; }
  /// As SurfaceTopology::IsConsistent; of masks and models true.
  bool IsConsistent() const noexcept { return this->HasPairsOnly; }
  /// Of a closed mesh (IrregularShare), else 0.
  double Irregular() const noexcept { return this->IrregularPart; }
  /// mm^3: of a mask's voxels, a model's integral, the volume that a mesh encloses; NaN if open.
  double Volume() const noexcept { return this->EnclosedVolume; }
  double Area() const noexcept { return this->SurfaceArea; } ///< mm^2
  /// Of the volume, or of the surface if it is open.
  const Vector3& Centroid() const noexcept { return this->Middle; }
  const PlacedMask* Mask() const noexcept { return this->Voxels.get(); }
  bool IsModel() const noexcept { return this->Foot != nullptr; }

  /// Distances (mm) of points from this surface: negative inside if it is closed, else unsigned.
  /// Fails only if `progress` cancels.
  Status DistancesOf(const std::vector<Vector3>& points, const KernelProgress& progress,
                     std::vector<double>& distances) const;
  /// Distances (mm) of points from the triangles of Surface(), without sign.
  std::vector<double> DistancesOfTriangles(const std::vector<Vector3>& points) const
  {
    return this->Nearest.DistancesOf(points);
  }
  /// Distances over this surface from another body's, as that measures them (SampleDistances). The
  /// first samples are the points of Surface(); all are on the model, of one. Fails only if
  /// `progress` cancels.
  Status SampleDistancesFrom(const ComparedBody& other, const KernelProgress& progress,
                             DistanceSamples& samples) const;

private:
  Status Finish();
  void TakeMask(VoxelMask mask, const IndexToWorld& toWorld);
  Status Measure(const std::vector<Vector3>& points, const KernelProgress& progress,
                 std::vector<double>& distances) const;
  void GiveSigns(const std::vector<Vector3>& points, std::vector<double>& distances) const;

  IndexedMesh Mesh;
  NearestOnMesh Nearest;
  std::shared_ptr<const ModelFoot> Foot;
  std::shared_ptr<const IndexedMesh> Scaled; // of a model
  std::shared_ptr<const PlacedMask> Voxels;
  Vector3 Middle = Vector3::Zero();
  double EnclosedVolume = 0.0;
  double SurfaceArea = 0.0;
  double IrregularPart = 0.0;
  bool HasPairsOnly = true;
  int Holes = 0;
};
} // namespace palpate
