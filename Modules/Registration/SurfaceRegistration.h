#pragma once

#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "RegistrationStep.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// Enough for points whose start is far away.
constexpr int StepsFromAfar = 300;

struct SurfaceRegistrationSettings
{
  RegistrationKind Kind = RegistrationKind::Rigid;
  double Noise = 0.0; ///< standard deviation of the points, mm; 0: judged by what remains
  int MostSteps = 200;
};

/// How points lie on a surface once they are brought there.
struct SurfaceRegistration
{
  Eigen::Affine3d Map = Eigen::Affine3d::Identity(); ///< of the moving points (mm)
  double Rms = 0.0;                                  ///< of the distances from the surface, mm
  double Median = 0.0;                               ///< the same
  /// Of rigid maps and similarities. Honest from 40 points on; with fewer the surface's flat
  /// directions are more uncertain than that.
  PredictedPoseError Error;
  int Steps = 0;
  bool HasConverged = false;
};

/// Brings points (mm) from `start` onto the surface of a mesh, closed or open: Gauss-Newton steps
/// on the distances to the nearest points, along their directions, damped as by Levenberg and
/// Marquardt (Chen and Medioni, Image and Vision Computing 10, 1992). Distances far above the noise
/// count less (Geman and McClure's weights). Finds the optimum near the start. Fails for fewer
/// points than unknowns, points that are not finite, as NearestOnMesh::Make does, and if `progress`
/// cancels. Allocates.
Status RegisterToSurface(const std::vector<Vector3>& points, const IndexedMesh& fixed,
                         const Eigen::Affine3d& start, const SurfaceRegistrationSettings& settings,
                         const KernelProgress& progress, SurfaceRegistration& made);
} // namespace palpate
