#pragma once

#include "RegistrationStep.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// How landmarks lie on their partners once they are brought there.
struct LandmarkRegistration
{
  Eigen::Affine3d Map = Eigen::Affine3d::Identity(); ///< of the moving landmarks (mm)
  std::vector<double> Residuals;                     ///< distance of each pair, mm
  std::vector<double> Weights;                       ///< of each pair, 0 to 1; near 0: a wrong pair
  double Rms = 0.0;                                  ///< weighted, mm
  PredictedPoseError Error;                          ///< of rigid maps and similarities
};

/// The map that brings landmarks (mm) closest to their partners, in the order of both lists: in
/// closed form (Umeyama, IEEE PAMI 13, 1991; least squares if it is affine), with Geman and
/// McClure's weights whose width shrinks from the largest distance to that of noise (graduated
/// non-convexity: Yang et al., IEEE RA-L 5, 2020), so that pairs that were exchanged or misplaced
/// count little. From eight pairs on two that were exchanged are found mostly; below, nothing finds
/// them. `noise` (mm) is the standard deviation of a coordinate; 0: judged by what remains. Fails
/// for lists of different lengths, fewer than three pairs (affine: four), pairs on a line (affine:
/// in a plane), and coordinates that are not finite. Allocates.
Status RegisterLandmarks(const std::vector<Vector3>& moving, const std::vector<Vector3>& fixed,
                         RegistrationKind kind, double noise, LandmarkRegistration& made);
} // namespace palpate
