#pragma once

#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// An image header as reported by ITK, in plain numbers: ITK bundles its own Eigen, which cannot be
/// included in the same translation unit as ours.
struct ItkImageHeader
{
  std::vector<long long> Size;                ///< voxels along each axis; two or more axes
  std::vector<double> Spacing;                ///< mm
  std::vector<double> OriginWorld;            ///< mm, patient LPS
  std::vector<std::vector<double>> AxesWorld; ///< unit vector of each index axis
  int Components = 0;                         ///< values per voxel
  int VtkType = 0;                            ///< VTK_SHORT, ...; 0 if VTK has no such type
  std::map<std::string, std::string> Entries; ///< text entries (NRRD's key/value pairs)
};
} // namespace palpate
