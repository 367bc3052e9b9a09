#pragma once

#include "ForceField.h"
#include "Status.h"

#include <memory>
#include <vector>

namespace palpate
{
/// What a guide keeps the tool at.
enum class GuideShape
{
  Point, ///< the first point
  Path,  ///< straight lines from point to point
  Plane  ///< through the first three points
};

/// A guide, in the world.
struct GuideSettings
{
  GuideShape Shape = GuideShape::Point;
  std::vector<Vector3> PointsWorld; ///< mm
  double Stiffness = 0.2;           ///< N per mm of the world, at the guide
  double Range = 10.0;              ///< mm; farther away it does not act
  double LargestForce = 0.5;        ///< N
};

inline bool operator==(const GuideSettings& a, const GuideSettings& b)
{
  return a.Shape == b.Shape && a.PointsWorld == b.PointsWorld && a.Stiffness == b.Stiffness &&
         a.Range == b.Range && a.LargestForce == b.LargestForce;
}

/// Pulls the tool's origin towards the nearest point of a guide: for a distance D within the range
/// R with the force k D (1 - D^2/R^2)^2, whose potential is -k R^2 (1 - D^2/R^2)^3 / 6. So it is a
/// spring of stiffness k at the guide, largest at R / sqrt(5) with 0.286 k R, and ends smoothly at
/// R. The stiffness is lowered until that is at most the largest force. Since the distance is
/// continuous, so is the potential, and closed paths do no work; where two parts of a path are
/// equally near, the force turns from the one to the other in a step. Immutable, shared by threads.
class GuideField final : public ForceField
{
public:
  /// Fails for missing points or more than MostPoints, a plane's points on one line, numbers that
  /// are not finite, and stiffness, range or force that are not positive.
  static Status Make(const GuideSettings& settings, std::shared_ptr<const ForceField>& made);

  static constexpr std::size_t MostPoints = 1000;

  Vector3 ForceWorld(const Vector3& originWorld) const noexcept override;
  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  double Stiffness() const noexcept override { return this->Spring; }

private:
  explicit GuideField(const GuideSettings& settings);
  Vector3 NearestTo(const Vector3& originWorld) const noexcept;

  GuideShape Shape;
  std::vector<Vector3> Points; // mm
  Vector3 Normal = Vector3::UnitZ();
  double Range;  // mm
  double Spring; // N/mm
};
} // namespace palpate
