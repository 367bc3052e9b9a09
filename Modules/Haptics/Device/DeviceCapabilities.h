#pragma once

#include "PlainVector3.h"
#include "Vector3.h"

#include <algorithm>
#include <string>

namespace palpate
{
/// What a device can do, in its own frame; 0 where a number is not known.
struct DeviceCapabilities
{
  std::string Name;              ///< as a person would call it
  int DegreesOfFreedom = 3;      ///< of the pose that it measures: 3 or 6; forces have 3
  Eigen::AlignedBox3d Workspace; ///< mm
  double MaximumForce = 0.0;     ///< N, in any direction
  double MaximumStiffness = 0.0; ///< N/mm, that its maker or experience calls stable
  double MaximumDamping = 0.0;   ///< N s/mm, of commanded forces, likewise
  double Damping = 0.0;          ///< N s/mm, of the mechanism itself
  double Friction = 0.0;         ///< N, Coulomb's, of the mechanism itself
  double Resolution = 0.0;       ///< mm, one count of its encoders
  double Delay = 0.0;            ///< s, from a position's being measured to its force's being felt
  double Rate = 0.0;             ///< Hz, new samples
  /// s, from one new sample to the next while all is well, as on a bus that others use too; 0: a
  /// period.
  double LongestGap = 0.0;

  /// N, device's frame: what carries the weight of its handle. The servo adds it to the forces of
  /// the scene, so that it passes the safety chain like them.
  PlainVector3 GravityCompensation;

  /// Hz, that new samples keep in any case.
  double LeastRate() const noexcept
  {
    return this->LongestGap > 0.0 ? std::min(this->Rate, 1.0 / this->LongestGap) : this->Rate;
  }
};
} // namespace palpate
