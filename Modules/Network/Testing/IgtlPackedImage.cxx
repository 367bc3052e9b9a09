#include "IgtlPackedImage.h"

#include <cmath>
#include <igtl_util.h>
#include <numeric>

namespace palpate::test
{
std::vector<std::uint8_t> IgtlPackedImage(std::array<int, 3> size, int scalarType)
{
  igtl::ImageMessage::Pointer message = igtl::ImageMessage::New();
  message->SetDeviceName("Scan");
  message->SetDimensions(size.data());
  message->SetSpacing(2.5F, 1.5F, 3.0F);
  message->SetScalarType(scalarType);
  message->SetCoordinateSystem(igtl::ImageMessage::COORDINATE_RAS);
  std::array<int, 3> offset{};
  message->SetSubVolume(size.data(), offset.data());
  message->SetEndian(igtl_is_little_endian() ? igtl::ImageMessage::ENDIAN_LITTLE
                                             : igtl::ImageMessage::ENDIAN_BIG);
  message->AllocateScalars();
  if (scalarType == igtl::ImageMessage::TYPE_UINT16)
  {
    auto* first = static_cast<std::uint16_t*>(message->GetScalarPointer());
    std::iota(first, first + message->GetImageSize() / 2, std::uint16_t{0});
  }
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  const auto cosine = static_cast<float>(std::sqrt(0.75));
  matrix[0][0] = matrix[1][1] = cosine;
  matrix[1][0] = 0.5F;
  matrix[0][1] = -0.5F;
  matrix[0][3] = 10.0F;
  matrix[1][3] = 20.0F;
  matrix[2][3] = -30.0F;
  message->SetMatrix(matrix);
  message->Pack();
  const auto* bytes = static_cast<const std::uint8_t*>(message->GetPackPointer());
  return {bytes, bytes + message->GetPackSize()};
}
} // namespace palpate::test
