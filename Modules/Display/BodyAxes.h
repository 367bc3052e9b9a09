#pragma once

#include "ImageAxes.h"
#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <array>

namespace palpate
{
/// An image's axes by their part in the body: 0 towards left, 1 towards posterior, 2 towards
/// superior.
struct PALPATEDISPLAY_EXPORT BodyAxes
{
  /// Each part gets another axis; together they are as near to the body's as can be.
  explicit BodyAxes(const ImageAxes& image);

  /// The image's own direction that is nearest to a direction of the body's axes, a unit vector.
  Vector3 NearestWorld(const ImageAxes& image, const Vector3& bodyDirectionWorld) const;

  std::array<int, 3> Axis{};    ///< of the image
  std::array<double, 3> Sign{}; ///< -1 where the index runs the other way
};
} // namespace palpate
