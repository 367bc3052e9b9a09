#include "IgtlImage.h"

#include "IgtlPackedImage.h"

#include <cstring>
#include <gtest/gtest.h>
#include <igtl_image.h>
#include <random>

namespace palpate::igtl_image_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

IgtlMessage MessageOf(const Bytes& bytes)
{
  IgtlParser parser({{"IMAGE", 1U << 20U}});
  EXPECT_TRUE(parser.Take(bytes.data(), bytes.size()));
  std::optional<IgtlMessage> message = parser.Next();
  EXPECT_TRUE(message.has_value());
  return message ? *message : IgtlMessage();
}

// With a header that `change` has changed.
template <typename Change>
IgtlMessage Changed(const Change& change)
{
  IgtlMessage message = MessageOf(test::IgtlPackedImage({4, 3, 2}));
  igtl_image_header header;
  std::memcpy(&header, message.Content.data(), sizeof header);
  igtl_image_convert_byte_order(&header);
  change(header);
  igtl_image_convert_byte_order(&header);
  std::memcpy(message.Content.data(), &header, sizeof header);
  return message;
}

std::string RefusalOf(const IgtlMessage& message)
{
  IgtlImage image;
  image.Size = {7, 7, 7};
  const Status status = ReadIgtlImage(message, image);
  EXPECT_EQ(image.Size[0] == 7, !status.IsOk()) << "a refused image changes nothing";
  return status.IsOk() ? "" : status.Message();
}

TEST(IgtlImage, GridIsThatOfTheSenderInLps)
{
  IgtlImage image;
  ASSERT_TRUE(ReadIgtlImage(MessageOf(test::IgtlPackedImage({4, 3, 2})), image).IsOk());
  EXPECT_EQ(image.Size, (std::array<int, 3>{4, 3, 2}));
  // Single precision.
  EXPECT_TRUE(image.Spacing.isApprox(Vector3(2.5, 1.5, 3.0), 1e-6));
  Matrix3 direction;
  const double cosine = std::sqrt(0.75);
  direction << -cosine, 0.5, 0.0, -0.5, -cosine, 0.0, 0.0, 0.0, 1.0;
  EXPECT_TRUE(image.Direction.isApprox(direction, 1e-6)) << image.Direction;
  // The message has the place of the image's centre: 1.5, 1 and 0.5 voxels from the first.
  const Vector3 center(-10.0, -20.0, -30.0);
  const Vector3 origin = center - direction * Vector3(1.5 * 2.5, 1.5, 1.5);
  EXPECT_TRUE(image.OriginWorld.isApprox(origin, 1e-6)) << image.OriginWorld.transpose();
}

TEST(IgtlImage, VoxelsAreThoseOfTheSender)
{
  IgtlImage image;
  ASSERT_TRUE(ReadIgtlImage(MessageOf(test::IgtlPackedImage({4, 3, 2})), image).IsOk());
  ASSERT_EQ(image.Type, ScalarType::UInt16);
  ASSERT_EQ(image.Voxels.size(), 48U);
  for (std::size_t i = 0; i < 24; ++i)
  {
    std::uint16_t voxel = 0;
    std::memcpy(&voxel, image.Voxels.data() + 2 * i, 2);
    ASSERT_EQ(voxel, i);
  }
}

TEST(IgtlImage, OtherByteOrderIsReversed)
{
  IgtlImage image;
  const IgtlMessage other =
      Changed([](igtl_image_header& header) { header.endian = 3 - header.endian; });
  ASSERT_TRUE(ReadIgtlImage(other, image).IsOk());
  std::uint16_t voxel = 0;
  std::memcpy(&voxel, image.Voxels.data() + 2 * 5, 2);
  EXPECT_EQ(voxel, 5 << 8);
}

TEST(IgtlImage, LpsAxesStay)
{
  IgtlImage image;
  const IgtlMessage lps =
      Changed([](igtl_image_header& header) { header.coord = IGTL_IMAGE_COORD_LPS; });
  ASSERT_TRUE(ReadIgtlImage(lps, image).IsOk());
  EXPECT_NEAR(image.Direction(0, 0), std::sqrt(0.75), 1e-6);
}

TEST(IgtlImage, EveryTypeOfVoxelIsRead)
{
  for (const int type : {2, 3, 4, 5, 6, 7, 10, 11})
  {
    IgtlImage image;
    EXPECT_TRUE(ReadIgtlImage(MessageOf(test::IgtlPackedImage({3, 2, 2}, type)), image).IsOk())
        << type;
  }
}

TEST(IgtlImage, WhatIsNoWholeImageIsRefused)
{
  const auto refusal = [](auto change) { return RefusalOf(Changed(change)); };
  using Header = igtl_image_header;
  const auto newer = [](Header& h)
  {
    const std::uint16_t version = 9;
    std::memcpy(&h, &version, sizeof version); // the first field
  };
  EXPECT_NE(refusal(newer).find("version"), std::string::npos);
  EXPECT_NE(refusal([](Header& h) { h.num_components = 3; }).find("3 values"), std::string::npos);
  EXPECT_NE(refusal([](Header& h) { h.scalar_type = 9; }).find("type"), std::string::npos);
  EXPECT_NE(refusal([](Header& h) { h.endian = 0; }).find("byte order"), std::string::npos);
  EXPECT_NE(refusal([](Header& h) { h.coord = 0; }).find("axes"), std::string::npos);
  EXPECT_NE(refusal([](Header& h) { h.subvol_size[2] = 1; }).find("whole"), std::string::npos);
  EXPECT_NE(refusal([](Header& h) { h.size[0] = 0; }).find("whole"), std::string::npos);
  const auto larger = [](Header& h) { h.size[0] = h.subvol_size[0] = 65535; };
  EXPECT_NE(refusal(larger).find("number of voxels"), std::string::npos);
  const auto flat = [](Header& h) { std::fill(h.matrix, h.matrix + 3, 0.0F); };
  EXPECT_NE(refusal(flat).find("no length"), std::string::npos);
  const auto nowhere = [](Header& h) { h.matrix[9] = std::numeric_limits<float>::quiet_NaN(); };
  EXPECT_NE(refusal(nowhere).find("no length"), std::string::npos);
  IgtlMessage cut = MessageOf(test::IgtlPackedImage({4, 3, 2}));
  cut.Content.resize(40);
  EXPECT_NE(RefusalOf(cut).find("short"), std::string::npos);
}

TEST(IgtlImage, AnyBytesAreAnImageOrARefusal)
{
  std::mt19937_64 random(5);
  const IgtlMessage whole = MessageOf(test::IgtlPackedImage({4, 3, 2}));
  int refused = 0;
  for (int round = 0; round < 4000; ++round)
  {
    IgtlMessage damaged = whole;
    for (int change = 0; change < 2; ++change)
    {
      damaged.Content[random() % IGTL_IMAGE_HEADER_SIZE] = static_cast<std::uint8_t>(random());
    }
    IgtlImage image;
    if (!ReadIgtlImage(damaged, image).IsOk())
    {
      ++refused;
      continue;
    }
    ASSERT_TRUE(image.Direction.allFinite() && image.OriginWorld.allFinite());
    ASSERT_GT(image.Spacing.minCoeff(), 0.0);
  }
  EXPECT_GT(refused, 400); // most bytes of the first 22 and the last 12 make no image
}
} // namespace
} // namespace palpate::igtl_image_test
