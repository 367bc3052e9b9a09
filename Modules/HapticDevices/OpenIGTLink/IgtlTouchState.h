#pragma once

#include "IgtlTouch.h"
#include "TouchState.h"

namespace palpate
{
/// What a program that displays a touch is told of a tick.
IgtlTouch IgtlTouchOf(const TouchState& state) noexcept;
} // namespace palpate
