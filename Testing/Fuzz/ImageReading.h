#pragma once

#include <filesystem>

namespace palpate::test
{
/// Reads a path as a volume and as a segmentation, as `palpate info` does, and measures the labels.
/// Throws InputError if it is neither.
void ReadImage(const std::filesystem::path& path);
} // namespace palpate::test
