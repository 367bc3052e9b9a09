#pragma once

#include "IgtlTouch.h"
#include "TouchState.h"

#include <optional>

namespace palpate
{
/// What a program that displays a touch is told of a tick; nothing while the device has no pose or
/// is not ready.
std::optional<IgtlTouch> IgtlTouchOf(const TouchState& state) noexcept;
} // namespace palpate
