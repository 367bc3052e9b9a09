#include "JpegSegments.h"

#include <gtest/gtest.h>

using namespace palpate;

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
  return ReadJpegFrameHeader(stream, ReadJpegSegments(stream)).has_value();
}
} // namespace

TEST(JpegSegments, FrameIsFoundAmongTheMarkers)
{
  // With a repeated 0xFF, and a coded byte behind the scan.
  const Bytes stream = Stream({Comment, {0xFF}, Frame, Scan, {7}});
  const std::vector<JpegSegment> segments = ReadJpegSegments(stream);
  ASSERT_EQ(segments.size(), 3u);
  EXPECT_EQ(segments.back().Marker, JpegMarker::Scan);
  EXPECT_EQ(segments.back().End, stream.size() - 1);
  const auto header = ReadJpegFrameHeader(stream, segments);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->Process, JpegMarker::LosslessFrame);
  EXPECT_EQ(header->Precision, 12);
  EXPECT_EQ(header->Rows, 3);
  EXPECT_EQ(header->Columns, 260);
  EXPECT_EQ(header->Components, 1);
}

TEST(JpegSegments, EveryCutBeforeTheScanLeavesNothing)
{
  const Bytes good = Stream({Comment, Frame, Scan});
  ASSERT_TRUE(HasHeader(good));
  for (std::size_t size = 0; size < good.size(); ++size)
  {
    EXPECT_TRUE(
        ReadJpegSegments(Bytes(good.begin(), good.begin() + static_cast<int>(size))).empty())
        << size;
  }
}

TEST(JpegSegments, LengthsThatDoNotEvenHoldThemselvesAreDamage)
{
  EXPECT_FALSE(HasHeader(Stream({{0xFF, 0xFE, 0, 1}, Frame, Scan})));
  EXPECT_FALSE(HasHeader(Stream({{0xFF, 0xFE, 0xFF, 0xFE}, Frame, Scan})));
  EXPECT_FALSE(HasHeader(Stream({Frame, {0xFF, 0xDA, 0, 1, 1}})));
}

TEST(JpegSegments, ThereIsOneFrame)
{
  EXPECT_FALSE(HasHeader(Stream({Comment, Scan})));
  EXPECT_FALSE(HasHeader(Stream({Frame, Frame, Scan})));
  EXPECT_FALSE(HasHeader(Stream({{0xFF, 0xC3, 0, 5, 12, 0, 3}, Scan})));
}
