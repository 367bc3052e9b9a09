#pragma once

#include "Vector3.h"

#include <algorithm>
#include <vector>

namespace palpate
{
/// A face of a scan's border that cuts a structure. The structure goes on behind it, so what lies
/// there is none of its surface.
struct ScanCut
{
  Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, out of the scan
  double Offset = 0.0;                    ///< mm: the face has x . NormalWorld = Offset
  double Depth = 0.0;                     ///< mm: how far a cut may lie in front of the face
};

/// Whether a place of a structure's surface (mm) with this unit normal is one of cuts: near a face,
/// and turned to it by less than 45 degrees, since models and smoothed masks round the edges.
inline bool IsOnCut(const std::vector<ScanCut>& cuts, const Vector3& placeWorld,
                    const Vector3& normalWorld) noexcept
{
  constexpr double LeastCosine = 0.7071;
  return std::any_of(cuts.begin(), cuts.end(),
                     [&](const ScanCut& cut)
                     {
                       return normalWorld.dot(cut.NormalWorld) > LeastCosine &&
                              placeWorld.dot(cut.NormalWorld) > cut.Offset - cut.Depth;
                     });
}
} // namespace palpate
