#pragma once

#include "OrganModel.h"

namespace palpate
{
/// The mirror image at the sagittal plane x = 0 of the frame, exactly: as mirroring turns a
/// direction's longitude p into pi - p, harmonics of order m change by the sign (-1)^m if they are
/// cosines, by -(-1)^m if they are sines. A surface's parameters are mirrored too, so that it stays
/// outside out; its x coordinates also change their sign. Twice is the shape itself. Allocates.
OrganModel MirrorShape(const OrganModel& shape);

/// The sign of a harmonic of order m (below 0: sines) under x to -x.
constexpr double MirrorSign(int m)
{
  return (m % 2 == 0) == (m >= 0) ? 1.0 : -1.0;
}
} // namespace palpate
