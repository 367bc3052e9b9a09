#pragma once

#include "ComplianceAtlas.h"
#include "PressedPlace.h"
#include "RadialModel.h"
#include "ReducedCompliance.h"
#include "Vector3.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace palpate
{
/// The surface of an organ with the dents of a ball that is pressed into it, for pictures: long
/// waves by the reduced compliance, the rest as of a half-space under a Hertz bump (Johnson,
/// Contact Mechanics, 1985, section 3.4) whose modulus makes its compliance that of the place.
/// Immutable; queries allocate.
class DentedSurface
{
public:
  /// Of a model with its maps, which have long waves, drawn with vertices in these unit directions
  /// from the model's centre.
  DentedSurface(const RadialModel& model, const ComplianceMaps& maps,
                const std::vector<Vector3>& directions);

  /// What presses, and where it does: on both walls of a notch, for example.
  struct Ball
  {
    Vector3 CenterWorld; ///< mm
    double Radius;       ///< mm
    std::vector<PressedPlace> Places;
  };

  /// A ball of this radius (mm), this deep (mm) at the nearest point of the undeformed surface, in
  /// the unit vector `direction`.
  Ball PressedAt(const Vector3& direction, double depth, double ballRadius) const;
  /// Where the vertices are (mm, world), at most on the ball's surface: none is inside.
  std::vector<Vector3> PointsWorld(const Ball& ball) const;
  /// Where they are without a ball.
  const std::vector<Vector3>& RestWorld() const noexcept { return this->Rest; }

private:
  HertzPatch PatchAt(const Vector3& direction, double patchRadius) const;
  std::vector<double> Dents(const HertzPatch& patch, double force) const;

  RadialModel Model;
  ComplianceAtlas Atlas;
  ReducedCompliance LongWaves;
  Eigen::MatrixXd Harmonics; // a row for each vertex
  std::vector<Vector3> Rest; // mm, world
};
} // namespace palpate
