#pragma once

#include "AnatomicalView.h"
#include "PalpateInteractionModule.h"
#include "Vector3.h"

#include <array>

class vtkImageData;

namespace palpate
{
/// Orientation of a slice in the body.
enum class SliceOrientation
{
  Axial,
  Coronal,
  Sagittal
};

constexpr std::array<SliceOrientation, 3> AllSliceOrientations{
    {SliceOrientation::Axial, SliceOrientation::Coronal, SliceOrientation::Sagittal}};

/// "Axial", ...
PALPATEINTERACTION_EXPORT const char* NameOf(SliceOrientation orientation);

/// A plane's colour in all views, 0 to 1; distinguishable for colour-blind people (Okabe and Ito,
/// Color Universal Design, 2008).
PALPATEINTERACTION_EXPORT std::array<double, 3> ColorOf(SliceOrientation orientation);

/// Geometry of slices of one orientation, in radiological convention: axial slices are seen from
/// the feet, sagittal ones from the left. World is patient LPS, mm.
struct PALPATEINTERACTION_EXPORT SliceGeometry
{
  /// Along the image axes nearest to the body's, or along the body's. Without an image, slices are
  /// 1 mm apart.
  SliceGeometry(SliceOrientation orientation, bool isAlongImage, vtkImageData* image);

  /// Whether slices have numbers: those of the image, counted from its first slice.
  bool HasNumbers() const { return this->Count > 0; }
  /// Number of the slice with the nearest centre plane, from 0; outside the image it is below 0 or
  /// not below Count.
  int NumberOf(const Vector3& world) const;
  /// The point moved by `steps` slices (to the patient's head, front or right). If slices have
  /// numbers, it lies on a slice's centre plane, within the image. Its position in the plane is
  /// kept.
  Vector3 Moved(const Vector3& world, int steps) const;

  ViewFrame Frame;
  Vector3 ForwardWorld;                 ///< unit, the direction in which slices are counted
  Vector3 FirstWorld = Vector3::Zero(); ///< a point of the first slice
  double StepMillimeters = 1.0;         ///< from slice to slice
  int Count = 0;                        ///< slices of the image; 0 across its axes
};
} // namespace palpate
