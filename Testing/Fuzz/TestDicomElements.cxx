#include "DicomElements.h"

#include "CompressedDicom.h"
#include "FuzzTarget.h"
#include "SyntheticImages.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::test::dicom_elements_test
{
namespace
{
constexpr std::uint32_t ImagePosition = 0x00200032;

std::string Segmentation()
{
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "a"}, {2, "b"}};
  spec.Frames = {{1, 0.0, std::vector<int>(12, 1)}, {2, 6.0, std::vector<int>(12, 1)}};
  return WrittenBytes("a.dcm", [&](const std::filesystem::path& file)
                      { WriteDicomSegmentation(file, spec); });
}

std::size_t IndexOf(const std::vector<DicomElement>& elements, std::uint32_t tag)
{
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [tag](const DicomElement& e) { return e.Tag == tag; });
  return static_cast<std::size_t>(found - elements.begin());
}

TEST(DicomElements, CoverWholeFile)
{
  const std::string bytes = Segmentation();
  const std::vector<DicomElement> elements = DicomElementsOf(bytes);
  std::size_t end = 132; // after the preamble
  for (const DicomElement& element : elements)
  {
    if (element.Parent < 0)
    {
      EXPECT_EQ(element.First, end);
      end = element.End;
    }
  }
  EXPECT_EQ(end, bytes.size());
}

TEST(DicomElements, ReachIntoSequences)
{
  const std::string bytes = Segmentation();
  const std::vector<DicomElement> elements = DicomElementsOf(bytes);
  const std::size_t position = IndexOf(elements, ImagePosition);
  ASSERT_LT(position, elements.size());
  EXPECT_EQ(bytes.substr(elements[position].Value, elements[position].Count), "10\\20\\0 ");
  int depth = 0;
  for (int outer = elements[position].Parent; outer >= 0;
       outer = elements[static_cast<std::size_t>(outer)].Parent)
  {
    ++depth;
  }
  EXPECT_EQ(depth, 4); // two sequences with an item each
}

TEST(DicomElements, ReplacedValueUpdatesLengths)
{
  std::string bytes = Segmentation();
  const std::vector<DicomElement> before = DicomElementsOf(bytes);
  const std::size_t position = IndexOf(before, ImagePosition);
  ReplaceInValue(bytes, before, position, 0, before[position].Count, "10.000000\\20\\0 ");
  const std::vector<DicomElement> after = DicomElementsOf(bytes);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after.back().End, bytes.size());
  EXPECT_EQ(after[position].Count, 15U);
}

TEST(DicomElements, FindCompressedFragments)
{
  DicomSliceSpec spec;
  const std::string bytes = WrittenBytes("a.dcm",
                                         [&](const std::filesystem::path& file)
                                         {
                                           WriteDicomSlice(file, spec);
                                           Compress(file, Codec::Jpeg2000);
                                         });
  const std::vector<DicomElement> elements = DicomElementsOf(bytes);
  const std::size_t pixels = IndexOf(elements, DicomElement::PixelData);
  ASSERT_LT(pixels + 2, elements.size());
  EXPECT_EQ(elements[pixels + 1].Count, 0U); // the offset table
  EXPECT_EQ(bytes.substr(elements[pixels + 2].Value, 2), "\xFF\x4F");
}
} // namespace
} // namespace palpate::test::dicom_elements_test
