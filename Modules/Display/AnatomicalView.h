#pragma once

#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <array>
#include <string>

namespace palpate
{
/// The side from which a patient is viewed.
enum class ViewSide
{
  Anterior,
  Posterior,
  Left,
  Right,
  Superior,
  Inferior
};

constexpr std::array<ViewSide, 6> AllViewSides{{ViewSide::Anterior, ViewSide::Posterior,
                                                ViewSide::Left, ViewSide::Right, ViewSide::Superior,
                                                ViewSide::Inferior}};

/// Axes of an image in space: unit vectors in patient LPS, Right x Up = TowardsViewer.
struct ViewFrame
{
  Vector3 RightWorld;
  Vector3 UpWorld;
  Vector3 TowardsViewerWorld;
};

/// From the front, the back, the left or the right, the patient's head is up; from above or below,
/// the patient's front is up (from below: the radiological convention of axial slices).
PALPATEDISPLAY_EXPORT ViewFrame FrameOf(ViewSide side);

/// From the patient's front, a little from the left and from above.
PALPATEDISPLAY_EXPORT ViewFrame ObliqueFrame();

/// "Anterior", "Posterior", ...
PALPATEDISPLAY_EXPORT std::string NameOf(ViewSide side);

/// Letters of the patient's directions (L, R, P, A, S, I) along a unit vector in LPS, the largest
/// component first; only components of at least half the largest count. "S", or "PL" for oblique.
PALPATEDISPLAY_EXPORT std::string OrientationLetters(const Vector3& directionWorld);

/// Letters of an image's edges: left, right, top, bottom.
PALPATEDISPLAY_EXPORT std::array<std::string, 4> EdgeLettersOf(const ViewFrame& frame);
} // namespace palpate
