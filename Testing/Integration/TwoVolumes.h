#pragma once

#include "SyntheticImages.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace palpate::test
{
/// A NIfTI file of two volumes of 24^3 voxels of 1 mm: balls of label 1, of 6 and of 9 mm.
inline void WriteTwoVolumes(const std::filesystem::path& path)
{
  constexpr int Size = 24;
  NiftiSpec spec;
  spec.Dimensions = {4, Size, Size, Size, 2, 1, 1, 1};
  spec.PixelDimensions = {1, 1, 1, 1};
  spec.SForm = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::string voxels;
  for (const double radius : {6.0, 9.0})
  {
    for (int i = 0; i < Size * Size * Size; ++i)
    {
      const double x = i % Size - 11.5;
      const double y = i / Size % Size - 11.5;
      const double z = i / Size / Size - 11.5;
      voxels.push_back(std::hypot(x, y, z) < radius ? '\1' : '\0');
    }
  }
  std::ofstream(path, std::ios::binary) << NiftiBytes(spec, voxels);
}
} // namespace palpate::test
