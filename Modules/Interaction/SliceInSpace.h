#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SliceGeometry.h"
#include "SlicePatch.h"
#include "ViewProps.h"

#include <cstdint>

class vtkImageDisplay;

namespace palpate
{
/// A whole slice of a volume as a textured plane in 3D, at about the voxels' resolution, with an
/// outline in its plane's colour. World is patient LPS, mm.
class PALPATEINTERACTION_EXPORT SliceInSpace : public ViewProps
{
public:
  explicit SliceInSpace(SliceOrientation orientation);
  /// Through a point; nothing is shown without a display, or if the plane misses the volume.
  /// Painted again only after a change.
  void Update(vtkImageDisplay* display, bool isAlongImage, const Vector3& throughWorld);

  vtkActor* Actor() const { return this->Patch.Actor(); }

private:
  PixelGrid GridOf(const std::vector<Vector3>& corners, const ViewFrame& frame,
                   double pixelMillimeters) const;

  SliceOrientation Orientation;
  SlicePatch Patch;
  CurveActor Outline;
  std::uint64_t PaintedTime = 0;
  double PaintedHeight = 0.0;
  Vector3 PaintedNormal = Vector3::Zero();
  bool IsEmpty = true;
};
} // namespace palpate
