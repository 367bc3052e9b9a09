#pragma once

#include "ImageAxes.h"
#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <array>

namespace palpate
{
/// Assigns an image's axes to the body's: 0 towards left, 1 towards posterior, 2 towards superior.
struct PALPATEDISPLAY_EXPORT BodyAxes
{
  /// Each body axis gets a different image axis; together they are as close to the body's as
  /// possible.
  explicit BodyAxes(const ImageAxes& image);

  /// The image's own direction that is nearest to a direction of the body's axes, a unit vector.
  Vector3 NearestWorld(const ImageAxes& image, const Vector3& bodyDirectionWorld) const;

  std::array<int, 3> Axis{};    ///< of the image
  std::array<double, 3> Sign{}; ///< -1 if the index runs in the opposite direction
};
} // namespace palpate
