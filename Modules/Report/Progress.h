#pragma once

#include <functional>
#include <string>

namespace palpate
{
/// Told now and then how far a piece of work has come: fraction in 0..1 and the stage's name.
/// Answers false to have the work cancelled.
using ProgressFunction = std::function<bool(double fraction, const std::string& stage)>;
} // namespace palpate
