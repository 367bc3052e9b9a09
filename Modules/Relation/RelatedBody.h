#pragma once

#include "ComparedBody.h"
#include "MeshGap.h"
#include "ShapeFeatures.h"
#include "Status.h"

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <vector>

namespace palpate
{
/// Of which points a body's spread is.
enum class SpreadOf
{
  Inside,      ///< all that its surface encloses
  VoxelCenters ///< of a mask, as the Image Biomarker Standardisation Initiative has it
};

/// A closed body that is prepared for relations with others. Immutable.
class RelatedBody
{
public:
  /// Fails for an open surface, and one that encloses no volume. Where the border of an image of
  /// this size (voxels) cuts the body, which is then that of a mask, is not its surface.
  static Status Make(ComparedBody body, SpreadOf spread, RelatedBody& made,
                     const std::array<int, 3>* imageSize = nullptr);

  const ComparedBody& Body() const noexcept { return *this->Compared; }
  /// The surface at whose points maps are: that of the body; of a model, whose drawing is finer, a
  /// quarter of its triangles, with points on the model.
  const IndexedMesh& Samples() const noexcept { return this->Sampled; }
  /// The same points, with the triangles that are the body's own surface: without those where a
  /// border cuts it.
  const IndexedMesh& Own() const noexcept
  {
    return this->Uncut != nullptr ? *this->Uncut : this->Sampled;
  }
  const GapSurface& Gap() const noexcept { return this->Surface; }
  const Eigen::AlignedBox3d& Box() const noexcept { return this->Bounds; }
  const PointSpread& Spread() const noexcept { return this->Points; }
  /// Its shape features. Fails as MeasureShapeFeatures does.
  Status Features(std::vector<ShapeFeature>& features) const
  {
    return MeasureShapeFeatures(this->Compared->Enclosure(), this->Points, features);
  }
  /// The centres of some 5,000 equal cubes inside it, mm.
  const std::vector<Vector3>& Inside() const noexcept { return this->Centers; }

private:
  std::shared_ptr<const ComparedBody> Compared; // where it stays
  IndexedMesh Sampled;
  std::shared_ptr<const IndexedMesh> Uncut; // null if nothing is cut
  GapSurface Surface;
  Eigen::AlignedBox3d Bounds;
  PointSpread Points;
  std::vector<Vector3> Centers;
};
} // namespace palpate
