#pragma once

#include "ComparedBody.h"
#include "KernelProgress.h"
#include "Status.h"
#include "SurfaceRegistration.h"

#include <vector>

namespace palpate
{
/// How a body moved: as a whole, and what that leaves.
struct BodyMotion
{
  double Turn = 0.0;               ///< rad
  Vector3 Shift = Vector3::Zero(); ///< of the centroid, mm
  double Rest = 0.0;               ///< RMS distance of the surfaces after turn and shift, mm
  std::vector<Vector3> Landmarks;  ///< where they are after it, mm
};

/// Every n-th point of a surface, at most 5,000: enough to register it.
std::vector<Vector3> SomePoints(const IndexedMesh& mesh);
/// Brings a surface from its centroid at that of a body onto it by a rigid map (RegisterToSurface,
/// of some points). Fails as that does.
Status RegisterToBody(const IndexedMesh& moving, const Vector3& middle, const ComparedBody& fixed,
                      const KernelProgress& progress, SurfaceRegistration& made);

/// The motion from one body to another. A landmark (mm) on or near the first one's surface moves
/// with the body, and from there with the surface at the nearest point. Fails as RegisterToSurface
/// does.
Status FindBodyMotion(const ComparedBody& from, const ComparedBody& to,
                      const std::vector<Vector3>& landmarks, const KernelProgress& progress,
                      BodyMotion& motion);
} // namespace palpate
