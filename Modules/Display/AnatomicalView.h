#pragma once

#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <array>
#include <string>

namespace palpate
{
/// The side from which a patient is looked at.
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

/// How a picture lies in space: unit vectors in patient LPS, Right x Up = TowardsViewer.
struct ViewFrame
{
  Vector3 RightWorld;
  Vector3 UpWorld;
  Vector3 TowardsViewerWorld;
};

/// Looked at from the front, the back, the left or the right, the patient's head is up; from above
/// or below, the patient's front is up (from below: as radiologists show axial slices).
PALPATEDISPLAY_EXPORT ViewFrame FrameOf(ViewSide side);

/// From the patient's front, a little from the left and from above.
PALPATEDISPLAY_EXPORT ViewFrame ObliqueFrame();

/// "Anterior", "Posterior", ...
PALPATEDISPLAY_EXPORT std::string NameOf(ViewSide side);

/// Letters of the patient's directions (L, R, P, A, S, I) along a unit vector in LPS, the strongest
/// first; those are named whose share is at least half of the strongest. "S", or "PL" for oblique.
PALPATEDISPLAY_EXPORT std::string OrientationLetters(const Vector3& directionWorld);

/// Those of a picture's edges: left, right, top, bottom.
PALPATEDISPLAY_EXPORT std::array<std::string, 4> EdgeLettersOf(const ViewFrame& frame);
} // namespace palpate
