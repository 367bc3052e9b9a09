#pragma once

#include <array>

namespace palpate
{
/// Outline of what a tool must not touch, in all views.
constexpr std::array<double, 3> ForbiddenColor{{1.0, 0.15, 0.15}};
} // namespace palpate
