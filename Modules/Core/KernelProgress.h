#pragma once

#include <functional>

namespace palpate
{
/// Receives the fraction done, 0 to 1, on the caller's thread; returns false to cancel. A cancelled
/// kernel returns a failure, whose message is for developers only.
using KernelProgress = std::function<bool(double fraction)>;
} // namespace palpate
