#pragma once

#include "Vector3.h"

namespace palpate
{
/// The vector, shortened in its own direction to a length of at most `maximum`; it exceeds that by
/// no rounding, and no magnitude overflows. Zero where a component is not finite, or where
/// `maximum` is not positive.
Vector3 ClampedLength(const Vector3& vector, double maximum) noexcept;
} // namespace palpate
