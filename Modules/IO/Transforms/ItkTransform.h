#pragma once

#include "MapRows.h"

#include <filesystem>

namespace palpate
{
/// The map (LPS, mm, from the fixed to the moving image) of a text file of ITK with one linear
/// transform of three dimensions: three rows of a matrix and a shift. Throws InputError.
MapRows ReadItkTransform(const std::filesystem::path& file);
} // namespace palpate
