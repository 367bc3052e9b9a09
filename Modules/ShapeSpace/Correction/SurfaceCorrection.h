#pragma once

#include "Status.h"
#include "SurfacePull.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace palpate
{
/// A surface corrected by pulls: how far each of its points moves, as a function of the surface at
/// the start and the list of pulls. The surface is points (mm, patient LPS) and unit directions,
/// its normals or a radial model's rays.
///
/// A pull moves the surface by v f(x), with its own motion v and f(x) = sum_i a_i k(x, p_i), f = 1
/// at its place p_0 and f = 0 at the places p_i of former pulls, which so stay where they are
/// (kriging, Wackernagel, Multivariate Geostatistics, 2003, chapter 3). k(x, y) = exp(-|x - y|^2 /
/// 2 w^2) (1 + n_x . n_y) / 2, the heat kernel for widths below the radii of curvature, fading
/// where the surface turns away: the other wall of a thin organ stays. Former places nearer than
/// half the width are pulled again, and no longer pinned. A pull or preview costs one evaluation of
/// the field: a few us to a ms. Not thread-safe.
class SurfaceCorrection
{
public:
  static constexpr std::size_t MostPulls = 1000;
  static constexpr double LargestDisplacement = 200.0; ///< of a pull, mm
  static constexpr double LeastWidth = 0.5;            ///< mm
  static constexpr double LargestWidth = 200.0;        ///< mm

  enum class Motion
  {
    Free,           ///< the surface is carried along in the direction of the pull
    AlongDirections ///< each point moves along its own direction only
  };

  SurfaceCorrection() = default;
  /// As many directions as points.
  SurfaceCorrection(std::vector<Vector3> points, std::vector<Vector3> directions, Motion motion);

  /// Adds a pull. Fails, leaving all as it is, for numbers that are not finite or beyond the
  /// limits, a surface without points, and the pull after MostPulls.
  Status Pull(const SurfacePull& pull);
  /// All displacements if this pull were added. Fails as Pull does.
  Status Preview(const SurfacePull& pull, Eigen::Matrix3Xd& displacements) const;
  /// Removes the last pull, if there is one; the displacements have the bits from before it.
  void Undo();

  const std::vector<SurfacePull>& Pulls() const noexcept { return this->List; }
  const std::vector<Vector3>& Points() const noexcept { return this->Places; } ///< at the start
  const std::vector<Vector3>& Directions() const noexcept { return this->Ways; }
  /// mm, a column for each point.
  const Eigen::Matrix3Xd& Displacements() const noexcept { return this->Moved; }
  /// Of any point of the surface at the start and its direction (mm).
  Vector3 DisplacementAt(const Vector3& point, const Vector3& direction) const noexcept;
  /// The number of the point that is nearest to a place now, which a pull at that place moves; 0 if
  /// there are no points.
  std::size_t NearestNow(const Vector3& place) const;
  /// Where a point is now.
  Vector3 PointNow(std::size_t number) const;

private:
  // A pull's share of the displacements.
  struct Field
  {
    double Width = 0.0;
    double SecondWidth = 0.0;
    Vector3 Along = Vector3::Zero();  ///< motion of the pulled point, mm
    std::vector<std::size_t> Centers; ///< numbers of points; the pulled one first
    Eigen::VectorXd Weights;
  };

  Status Check(const SurfacePull& pull) const;
  Field FieldOf(const SurfacePull& pull) const;
  Vector3 ValueOf(const Field& field, const Vector3& point,
                  const Vector3& direction) const noexcept;
  void Add(const Field& field, Eigen::Matrix3Xd& displacements) const noexcept;

  std::vector<Vector3> Places;
  std::vector<Vector3> Ways;
  std::vector<SurfacePull> List;
  std::vector<Field> Fields;
  Eigen::Matrix3Xd Moved;
  Motion Rule = Motion::Free;
};
} // namespace palpate
