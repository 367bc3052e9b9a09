#pragma once

#include "SurfacePhantoms.h"

#include <vector>

namespace palpate::test
{
struct NamedPhantom
{
  const char* Name;
  SurfaceModel Surface;
};

/// Surfaces that are not star-shaped and do not cross themselves.
inline std::vector<NamedPhantom> SimplePhantoms()
{
  Random random(5);
  return {{"OpenRing", OpenRing()}, {"Bowl", Bowl()}, {"BumpyTube", BumpyTube(random)}};
}
} // namespace palpate::test
