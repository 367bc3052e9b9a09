#pragma once

#include "ElasticForce.h"
#include "PressedPlace.h"
#include "Vector3.h"

#include <Eigen/Core>

#include <cstddef>

namespace palpate
{
/// A ball that is pressed into several walls of an elastic organ at once, as into a notch: a patch
/// at each, and each moves the others. The energy is the stationary value of
///
///     U = sum_i F_i (d_i - h_i(a_i)) - sum_i F_i^2 c_ii(a_i) / 2 - sum_i<j F_i F_j c_ij
///
/// for the ball's motion against the walls; the force is minus its gradient by the ball's place,
/// with which the patches move as Hold says. Of c_ij the part of a half-space under two equal bumps
/// at the distance D is taken (a Gaussian's potential, within 3 % of a Hertz bump's), times
/// ((1 + n_i . n_j) / 2)^3: two patches that meet are one, and walls that face each other do not
/// move each other. In finite elements of a cleft of 90 degrees, patches 4 mm apart move each other
/// by a fourteenth of what they move themselves, and those 10 mm apart by less than a hundredth;
/// the power gives a thirtieth for both.
class CoupledPatches
{
public:
  static constexpr std::size_t MostWalls = 6;

  struct Wall
  {
    Vector3 Direction; ///< unit, from the model's centre, of the place that holds the ball
    double Depth;      ///< by which the ball is pressed into it along its normal, mm
    double Gap = 0.0;  ///< from the ball where the walls hold it, mm; negative if it overlaps
  };

  /// Where the walls hold the ball, which tells what places of them it touches.
  struct Hold
  {
    Vector3 Push = Vector3::Zero(); ///< from the ball to there, mm
    /// Derivative of that place by the ball's, symmetric; zero for walls that stay.
    Eigen::Matrix3d Motion = Eigen::Matrix3d::Zero();
  };

  /// PatchRadius is the largest patch's; Slope is that along the force. Of walls above MostWalls
  /// the last are left out. `places`, if not null, gets a place for each wall, in any order. Does
  /// not allocate.
  static ElasticForce Of(const ComplianceAtlas& atlas, const RadialModel& model, const Wall* walls,
                         std::size_t count, double ballRadius, const Hold& hold,
                         PressedPlace* places = nullptr) noexcept;
  /// For walls that stay wherever the ball goes.
  static ElasticForce Of(const ComplianceAtlas& atlas, const RadialModel& model, const Wall* walls,
                         std::size_t count, double ballRadius) noexcept
  {
    return Of(atlas, model, walls, count, ballRadius, Hold());
  }
};
} // namespace palpate
