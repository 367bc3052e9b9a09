#pragma once

#include <array>
#include <filesystem>

namespace palpate
{
/// The map (LPS, mm, from the fixed to the moving image) of a text file of ITK with one linear
/// transform of three dimensions: three rows of a matrix and a shift. Without Eigen, since ITK has
/// one of its own. Throws InputError.
std::array<std::array<double, 4>, 3> ReadItkTransform(const std::filesystem::path& file);
} // namespace palpate
