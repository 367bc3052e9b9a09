#pragma once

#include "AnatomicalView.h"
#include "PalpateInteractionModule.h"
#include "Vector3.h"

#include <array>

class vtkImageData;

namespace palpate
{
/// How a slice cuts the body.
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

/// By which a plane is known in all views, 0 to 1; told apart by colour-blind eyes (Okabe and Ito,
/// Color Universal Design, 2008).
PALPATEINTERACTION_EXPORT std::array<double, 3> ColorOf(SliceOrientation orientation);

/// How slices of one orientation lie in space, hung as radiologists do: in axial slices the patient
/// is seen from the feet, in sagittal ones from the left. World is patient LPS, mm.
struct PALPATEINTERACTION_EXPORT SliceGeometry
{
  /// Along the image's own axes that are nearest to the body's, or along the body's. Without an
  /// image slices are 1 mm apart.
  SliceGeometry(SliceOrientation orientation, bool isAlongImage, vtkImageData* image);

  /// Whether slices have numbers: those of the image, counted from its first one.
  bool HasNumbers() const { return this->Count > 0; }
  /// Of the slice whose middle is nearest, from 0; outside the image it is below 0 or not below
  /// Count.
  int NumberOf(const Vector3& world) const;
  /// The point so many slices further (to the patient's head, front or right), on a slice's
  /// middle if slices have numbers, and within the image then. The place in the plane is kept.
  Vector3 Moved(const Vector3& world, int steps) const;

  ViewFrame Frame;
  Vector3 ForwardWorld;                 ///< unit, the way in which slices are counted
  Vector3 FirstWorld = Vector3::Zero(); ///< a point of the first slice
  double StepMillimeters = 1.0;         ///< from slice to slice
  int Count = 0;                        ///< slices of the image; 0 across its axes
};
} // namespace palpate
