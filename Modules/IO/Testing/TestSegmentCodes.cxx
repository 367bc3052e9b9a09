#include "SegmentCodes.h"

#include <gtest/gtest.h>

namespace palpate::segment_codes_test
{
namespace
{
void ExpectTerm(const CodedTerm& term, const char* scheme, const char* value, const char* meaning)
{
  EXPECT_EQ(term.Scheme, scheme);
  EXPECT_EQ(term.Value, value);
  EXPECT_EQ(term.Meaning, meaning);
}

TEST(SegmentCodes, ReadsTheTagsOfSlicer)
{
  const SegmentCodes codes = CodesOfSlicerTags(
      "Segmentation.Status:inprogress|TerminologyEntry:Segmentation category and type - 3D Slicer "
      "General Anatomy list~SCT^49755003^Morphologically Altered Structure~SCT^4147007^Mass"
      "~^^~Anatomic codes - DICOM master list~SCT^64033007^Kidney~SCT^24028007^Right|Other:1|");
  ExpectTerm(codes.Category, "SCT", "49755003", "Morphologically Altered Structure");
  ExpectTerm(codes.Type, "SCT", "4147007", "Mass");
  ExpectTerm(codes.TypeModifier, "", "", "");
  ExpectTerm(codes.Region, "SCT", "64033007", "Kidney");
  ExpectTerm(codes.RegionModifier, "SCT", "24028007", "Right");
}

TEST(SegmentCodes, SurviveTags)
{
  SegmentCodes codes;
  codes.Category = {"SCT", "123037004", "Anatomical Structure"};
  codes.Type = {"SCT", "64033007", "Kidney"};
  codes.TypeModifier = {"99X", "a|b~c", "Left^right"};
  const SegmentCodes read = CodesOfSlicerTags(SlicerTagsOf(codes));
  ExpectTerm(read.Category, "SCT", "123037004", "Anatomical Structure");
  ExpectTerm(read.Type, "SCT", "64033007", "Kidney");
  ExpectTerm(read.TypeModifier, "99X", "a b c", "Left right");
  ExpectTerm(read.Region, "", "", "");
}

TEST(SegmentCodes, OtherTextsHaveNone)
{
  EXPECT_EQ(SlicerTagsOf({}), "");
  for (const char* text : {"", "TerminologyEntry:", "TerminologyEntry:a", "Name:x|", "~~~~~~~"})
  {
    EXPECT_EQ(CodesOfSlicerTags(text).Category.Value, "") << text;
  }
}
} // namespace
} // namespace palpate::segment_codes_test
