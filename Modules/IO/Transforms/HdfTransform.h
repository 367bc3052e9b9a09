#pragma once

#include "MapRows.h"

#include <filesystem>

namespace palpate
{
///@{
/// The map (LPS, mm, from the fixed to the moving image) of a .h5 file of ITK with one linear
/// transform of three dimensions. HDF5's library runs in a process of its own,
/// palpate-transform-hdf5, with limits on memory and time, because it is not safe on damaged files.
/// Throws InputError, also if that program is not installed.
MapRows ReadHdfTransform(const std::filesystem::path& file);
void WriteHdfTransform(const std::filesystem::path& file, const MapRows& map);
///@}
} // namespace palpate
