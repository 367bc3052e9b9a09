#pragma once

#include "ComplianceAtlas.h"
#include "ElasticForce.h"
#include "ReducedCompliance.h"
#include "SphericalHarmonicModel.h"
#include "Vector3.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace palpate
{
/// The surface of an organ with the dent of a ball that is pressed into it, for pictures: long
/// waves by the reduced compliance, the rest as of a half-space under a Hertz bump (Johnson,
/// Contact Mechanics, 1985, section 3.4) whose modulus makes its compliance that of the place.
/// Immutable; queries allocate.
class DentedSurface
{
public:
  /// Of a model with its maps, which have long waves, drawn with vertices in these unit directions
  /// from the model's centre.
  DentedSurface(const SphericalHarmonicModel& model, const ComplianceMaps& maps,
                const std::vector<Vector3>& directions);

  /// What presses: the nearest point of the undeformed surface in the unit vector Direction, and
  /// the depth (mm) of a ball of Radius (mm) there.
  struct Ball
  {
    Vector3 Direction;
    double Depth;
    double Radius;
  };

  /// Where the vertices are (mm, world), at most on the ball's surface: none is inside.
  std::vector<Vector3> PointsWorld(const Ball& ball) const;
  /// Where they are without a ball.
  const std::vector<Vector3>& RestWorld() const noexcept { return this->Rest; }

private:
  std::vector<double> Dents(const HertzPatch& patch, double force) const;
  void KeepOut(const Ball& ball, const HertzPatch& patch, std::vector<Vector3>& points) const;

  SphericalHarmonicModel Model;
  ComplianceAtlas Atlas;
  ReducedCompliance LongWaves;
  Eigen::MatrixXd Harmonics; // a row for each vertex
  std::vector<Vector3> Rest; // mm, world
};
} // namespace palpate
