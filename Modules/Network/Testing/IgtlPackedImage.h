#pragma once

#include <array>
#include <cstdint>
#include <igtlImageMessage.h>
#include <vector>

namespace palpate::test
{
/// An IMAGE message of 16-bit voxels 0, 1, 2, ... as the protocol's own library packs it: 2.5 x 1.5
/// x 3 mm, turned about the patient's axis by 30 degrees (right-handed), in RAS.
std::vector<std::uint8_t> IgtlPackedImage(std::array<int, 3> size,
                                          int scalarType = igtl::ImageMessage::TYPE_UINT16);
} // namespace palpate::test
