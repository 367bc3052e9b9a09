#pragma once

#include "IndexedMesh.h"
#include "NearestOnMesh.h"
#include "Status.h"

#include <Eigen/Geometry>
#include <vector>

namespace palpate
{
struct HeldFitSettings
{
  double Stiffness = 0.5; ///< N/mm, of surfaces that are close to each other; above 0
  double Reach = 10.0;    ///< mm, above 0: parts that are farther apart do not pull
  int Points = 128;       ///< of the held surface, of equal areas; a tick asks for each

  /// For a hand that holds a body near this surface: of at most 1.5 N, which a hand holds for long,
  /// and half as far as the surface is thick, so that the force is continuous.
  static HeldFitSettings ForHand(const IndexedMesh& fixed);
};

/// What a held surface does to the hand that holds it.
struct HeldForce
{
  double Energy = 0.0;              ///< N mm, from 0 to MostEnergy
  Vector3 Force = Vector3::Zero();  ///< N
  Vector3 Torque = Vector3::Zero(); ///< N mm, about the held surface's pivot
};

/// How a surface that a hand holds fits another one: an energy of its pose, whose negative gradient
/// is the force on the hand. Each of N points at the distance d from the fixed surface has
/// (k / N) (c^2 / 6) (1 - (1 - d^2 / c^2)^3), for a stiffness k and a reach c, and the same as at c
/// beyond it (Tukey's biweight). Its force is no longer than 0.287 k c, and continuous, but for the
/// edges of facets, where the fixed surface is thicker than twice the reach. The energy is concave
/// in d^2, and so bends upwards by at most k: a motion by D under a force that is held meanwhile,
/// as a servo does, gives the hand at most k |D|^2 / 2 more than the energy loses. Immutable;
/// queries allocate nothing.
class HeldFit
{
public:
  /// The force of one point at d = c / sqrt(5), over k c.
  static constexpr double LargestOfPoint = 0.28621670111997307;

  /// Of the surface `moving` where it is, and `fixed` (mm). Fails for settings out of range, a
  /// surface without area, and as NearestOnMesh::Make does.
  static Status Make(const IndexedMesh& moving, const IndexedMesh& fixed,
                     const HeldFitSettings& settings, HeldFit& made);

  /// In the world; `pose` moves the held surface from where it was, and may change its size.
  HeldForce At(const Eigen::Affine3d& pose) const noexcept;

  double Stiffness() const noexcept { return this->Settings.Stiffness; }
  double LargestForce() const noexcept
  {
    return LargestOfPoint * this->Settings.Stiffness * this->Settings.Reach;
  }
  double MostEnergy() const noexcept
  {
    return this->Settings.Stiffness * this->Settings.Reach * this->Settings.Reach / 6.0;
  }
  double Reach() const noexcept { return this->Settings.Reach; }
  /// mm: the mean of the held surface, where it was.
  const Vector3& Pivot() const noexcept { return this->Middle; }
  /// mm, where it was.
  const std::vector<Vector3>& Points() const noexcept { return this->Samples; }
  /// mm, of the fixed surface.
  const Eigen::AlignedBox3d& FixedBounds() const noexcept { return this->Bounds; }

private:
  HeldFitSettings Settings;
  std::vector<Vector3> Samples;
  Vector3 Middle = Vector3::Zero();
  Eigen::AlignedBox3d Bounds;
  NearestOnMesh Fixed;
};

/// Points on a surface, each for the same area, in the order of its triangles: `count` or one more
/// or less; none of a surface without area.
std::vector<Vector3> PointsOfEqualArea(const IndexedMesh& mesh, int count);
} // namespace palpate
