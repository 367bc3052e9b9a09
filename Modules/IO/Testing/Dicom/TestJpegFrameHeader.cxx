#include "JpegFrameHeader.h"

#include <gtest/gtest.h>

namespace palpate::jpeg_frame_header_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

const Bytes Comment{0xFF, 0xFE, 0, 3, 1};
// Lossless, 12 bits, 3 rows, 260 columns, one component.
const Bytes Frame{0xFF, 0xC3, 0, 11, 12, 0, 3, 1, 4, 1, 1, 0x11, 0};
const Bytes Scan{0xFF, 0xDA, 0, 3, 1};

Bytes Stream(const std::vector<Bytes>& segments)
{
  Bytes stream{0xFF, 0xD8};
  for (const Bytes& segment : segments)
  {
    stream.insert(stream.end(), segment.begin(), segment.end());
  }
  return stream;
}

bool HasHeader(const Bytes& stream)
{
  return ReadJpegFrameHeader(stream).has_value();
}

TEST(JpegFrameHeader, FindsFrameAmongMarkers)
{
  // With a repeated 0xFF.
  const auto header = ReadJpegFrameHeader(Stream({Comment, {0xFF}, Frame, Scan}));
  ASSERT_TRUE(header);
  EXPECT_EQ(header->Marker, JpegFrameHeader::Lossless);
  EXPECT_EQ(header->Precision, 12);
  EXPECT_EQ(header->Rows, 3);
  EXPECT_EQ(header->Columns, 260);
  EXPECT_EQ(header->Components, 1);
}

TEST(JpegFrameHeader, RejectsTruncatedHeaders)
{
  const Bytes good = Stream({Comment, Frame});
  for (std::size_t size = 0; size + 4 <= good.size(); ++size)
  {
    EXPECT_FALSE(HasHeader(Bytes(good.begin(), good.begin() + static_cast<int>(size)))) << size;
  }
}

TEST(JpegFrameHeader, RejectsLengthsBeyondStream)
{
  EXPECT_FALSE(HasHeader(Stream({{0xFF, 0xFE, 0xFF, 0xFE}, Frame, Scan})));
  EXPECT_FALSE(HasHeader(Stream({Comment, Scan})));
}
} // namespace
} // namespace palpate::jpeg_frame_header_test
