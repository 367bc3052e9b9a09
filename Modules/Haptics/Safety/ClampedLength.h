#pragma once

#include "Vector3.h"

namespace palpate
{
/// The vector, shortened to a length of at most `maximum` in its own direction; rounding never
/// exceeds that, and no magnitude overflows. Zero if a component is not finite, or `maximum` is not
/// positive.
Vector3 ClampedLength(const Vector3& vector, double maximum) noexcept;
} // namespace palpate
