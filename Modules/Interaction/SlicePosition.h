#pragma once

#include "AnatomicalView.h"
#include "PixelGrid.h"

namespace palpate
{
/// What a slice view currently shows; world is patient LPS, mm.
struct SlicePosition
{
  ViewFrame Frame;
  Vector3 CenterWorld = Vector3::Zero(); ///< in the plane, at the centre of the view
  double PixelMillimeters = 1.0;
  int Width = 0; ///< pixels
  int Height = 0;
  double PointPixels = 1.0; ///< pixels of a point (1/72 inch) on this screen

  /// Offset of a layer towards the viewer: higher layers are drawn over lower ones. Invisible
  /// otherwise, in parallel projection.
  Vector3 Lift(int layer) const { return layer * this->Frame.TowardsViewerWorld; }
  Vector3 Projected(const Vector3& world) const
  {
    return world - this->HeightOver(world) * this->Frame.TowardsViewerWorld;
  }
  /// Towards the viewer, mm.
  double HeightOver(const Vector3& world) const
  {
    return (world - this->CenterWorld).dot(this->Frame.TowardsViewerWorld);
  }
  /// Converts a position in the view, in pixels from its lower left corner.
  Vector3 ToWorld(double x, double y) const
  {
    return this->CenterWorld +
           this->PixelMillimeters * ((x - 0.5 * this->Width) * this->Frame.RightWorld +
                                     (y - 0.5 * this->Height) * this->Frame.UpWorld);
  }
  PixelGrid Pixels() const
  {
    return {this->ToWorld(0.5, 0.5), this->PixelMillimeters * this->Frame.RightWorld,
            this->PixelMillimeters * this->Frame.UpWorld, this->Width, this->Height};
  }
};

/// Drawing order in a slice.
enum SliceLayer
{
  ContourLayer = 1,
  LandmarkLayer,
  ProbeLayer,
  ArrowLayer,
  CrosshairLayer
};
} // namespace palpate
