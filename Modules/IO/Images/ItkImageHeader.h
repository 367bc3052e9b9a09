#pragma once

#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// What ITK reports of an image file, in plain numbers: ITK brings an Eigen of its own, which
/// cannot meet ours in one translation unit.
struct ItkImageHeader
{
  std::vector<long long> Size;                ///< voxels along each axis; two or more axes
  std::vector<double> Spacing;                ///< mm
  std::vector<double> OriginWorld;            ///< mm, patient LPS
  std::vector<std::vector<double>> AxesWorld; ///< unit vector of each index axis
  int Components = 0;                         ///< values per voxel
  int VtkType = 0;                            ///< VTK_SHORT, ...; 0 for a type without a VTK one
  std::map<std::string, std::string> Entries; ///< text entries (NRRD's key/value pairs)
};
} // namespace palpate
