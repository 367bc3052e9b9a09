#pragma once

#include "CurvesInSlice.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"

#include <Eigen/Geometry>
#include <cstdint>

class vtkSurfaceDisplay;

namespace palpate
{
/// A plane, and when the surface that it cuts was changed.
struct SurfaceCutPlane
{
  std::uint64_t Time = 0;
  double Height = 0.0;
  Vector3 Normal = Vector3::Zero();
};

/// The contours of surfaces in a slice, cut again only if the slice or the surface changed.
class PALPATEINTERACTION_EXPORT SliceContours
    : public CurvesInSlice<vtkSurfaceDisplay, SurfaceCutPlane>
{
public:
  void Update(const SlicePosition& slice);
  /// Of all surfaces that are not wireframes, world; empty if there is none.
  Eigen::AlignedBox3d Bounds() const;

private:
  void Update(Entry& contour, const SlicePosition& slice);
};
} // namespace palpate
