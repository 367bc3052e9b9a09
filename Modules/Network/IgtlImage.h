#pragma once

#include "IgtlParser.h"
#include "ScalarType.h"
#include "Status.h"
#include "Vector3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// An image or a label map from an IMAGE message.
struct IgtlImage
{
  std::array<int, 3> Size{{0, 0, 0}};      ///< voxels along each index axis
  Vector3 Spacing = Vector3::Ones();       ///< mm
  Vector3 OriginWorld = Vector3::Zero();   ///< centre of voxel 0, 0, 0, mm, LPS
  Matrix3 Direction = Matrix3::Identity(); ///< column i: unit vector of index axis i, LPS
  ScalarType Type = ScalarType::UInt8;     ///< of the voxels
  std::vector<std::uint8_t> Voxels;        ///< in this machine's byte order, first axis fastest
};

/// The image of an IMAGE message, whose voxels are taken from it. Fails, with a sentence for
/// people, for parts of images, several values a voxel, and lengths or axes that make no image;
/// axes need not be perpendicular. Source: OpenIGTLink protocol, IMAGE, versions 1 and 2: the place
/// in the message is that of the image's centre.
Status ReadIgtlImage(IgtlMessage message, IgtlImage& image);
} // namespace palpate
