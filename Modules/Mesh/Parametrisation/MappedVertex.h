#pragma once

#include "Vector3.h"

namespace palpate
{
/// A vertex of the surface and where the map puts it.
struct MappedVertex
{
  Vector3 Point;     ///< on the surface, any frame and scale
  Vector3 Direction; ///< unit vector
};
} // namespace palpate
