#pragma once

#include <array>

namespace palpate
{
/// Three rows of a matrix and a shift (patient LPS, mm). Without Eigen, since ITK has one of its
/// own.
using MapRows = std::array<std::array<double, 4>, 3>;
} // namespace palpate
