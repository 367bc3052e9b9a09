#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// A number that describes a shape, by its name in the reference manual of the Image Biomarker
/// Standardisation Initiative.
struct ShapeFeature
{
  const char* Key;  ///< in tables: "volume_density_convex_hull"
  const char* Name; ///< "Volume density (convex hull)"
  const char* Code; ///< the manual's, "R3ER"
  const char* Unit; ///< "mm", "mm2", "mm3", "1/mm"; empty of a ratio
  double Value = 0.0;
};

/// Mean and covariance (mm, mm^2) of a body's points.
struct PointSpread
{
  Vector3 Mean = Vector3::Zero();
  Matrix3 Covariance = Matrix3::Zero();

  /// Of the points that a closed mesh encloses, by integrals.
  static PointSpread OfInside(const IndexedMesh& mesh);
  /// Of points, as the manual has it for the centres of voxels.
  static PointSpread OfPoints(const std::vector<Vector3>& points);

  /// Columns are unit vectors along which the points spread most, less and least; right-handed, the
  /// largest component of the first two positive. With `lengths`, 4 times the standard deviations.
  Matrix3 Axes(Vector3* lengths = nullptr) const;
};

/// The morphological features of Zwanenburg et al., "Image biomarker standardisation initiative",
/// arXiv:1612.07003v11, chapter 3.1, that depend on shape alone: of a closed mesh (mm, outwards)
/// and the spread of what it encloses. Ratios to oriented boxes and to the least ellipsoid, which
/// have no reference values, are left out. The indices must be valid. Fails without volume.
Status MeasureShapeFeatures(const IndexedMesh& mesh, const PointSpread& spread,
                            std::vector<ShapeFeature>& features);
/// The value of a feature by its key; NaN if there is none.
double ValueOf(const std::vector<ShapeFeature>& features, const char* key);
} // namespace palpate
