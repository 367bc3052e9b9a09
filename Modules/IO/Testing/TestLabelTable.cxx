#include "FileStamp.h"
#include "LabelTable.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::label_table_test
{
namespace
{
using namespace palpate::test;
using Color = std::array<double, 3>;

TEST(LabelLines, ReadsTheFormatOfMricron)
{
  const auto table = LabelLines("1 Precentral_L 2001\r\n2 3rd_Ventricle\n\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(1).Name, "Precentral_L");
  EXPECT_FALSE(table->at(1).Color);
  EXPECT_EQ(table->at(2).Name, "3rd_Ventricle");
}

// The first lines of FreeSurfer's own table.
TEST(LabelLines, ReadsColoursOfFreeSurferAndSlicer)
{
  const auto table = LabelLines("#$Id: FreeSurferColorLUT.txt\n"
                                "#No. Label Name:                            R   G   B   A\n\n"
                                "0   Unknown                                 0   0   0   0\n"
                                "17  Left-Hippocampus                        220 216 20  0\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(17).Name, "Left-Hippocampus");
  EXPECT_EQ(*table->at(17).Color, (Color{220.0 / 255.0, 216.0 / 255.0, 20.0 / 255.0}));
}

TEST(LabelLines, ReadsTheTableOfItkSnap)
{
  const auto table = LabelLines("################################################\n"
                                "# ITK-SnAP Label Description File\n"
                                "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                                "    2   255    0   51        1  1  1    \"Left upper lobe\"\n"
                                "    3   0    255    0        0.5  1  1    \"Heart\"\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(2).Name, "Left upper lobe");
  EXPECT_EQ(*table->at(2).Color, (Color{1.0, 0.0, 0.2}));
  EXPECT_EQ(table->at(3).Name, "Heart") << "of half opacity";
}

TEST(LabelLines, RejectsOtherTexts)
{
  for (const char* text : {"", "# only a comment\n", "some remarks\n", "1\n", "1 2 3\n4 5 6\n",
                           "-1 liver\n", "99999999999 liver\n", "1 liver\nremarks\n"})
  {
    EXPECT_FALSE(LabelLines(text)) << text;
  }
}

TEST(LabelColumns, ReadsTheTableOfBids)
{
  const auto table = LabelColumns("index\tname\tabbreviation\tcolor\n"
                                  "1\tGray Matter\tGM\t#ff3300\n2\tWhite Matter\tWM\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(1).Name, "Gray Matter");
  EXPECT_EQ(*table->at(1).Color, (Color{1.0, 0.2, 0.0}));
  EXPECT_EQ(table->at(2).Name, "White Matter");
  EXPECT_FALSE(table->at(2).Color);
}

TEST(LabelColumns, FindsColumnsWhateverTheirCaseAndOrder)
{
  const auto table = LabelColumns("Name,R,G,B,LabelValue\r\n\"liver\",255,0,0,5\r\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(5).Name, "liver");
  EXPECT_EQ(*table->at(5).Color, (Color{1.0, 0.0, 0.0}));
}

TEST(LabelColumns, RejectsOtherTables)
{
  for (const char* text : {"", "index\n1\n", "case,dice\na,0.9\n", "index,name\nx,liver\n",
                           "index,name\n1\n", "index,name\n"})
  {
    EXPECT_FALSE(LabelColumns(text)) << text;
  }
  EXPECT_FALSE(LabelColumns("index,name,color\n1,liver,#12345\n")->at(1).Color);
}

TEST(LabelsOfDataset, ReadsBothVersionsOfNnunet)
{
  const auto two = LabelsOfDataset(
      R"({"labels": {"background": 0, "liver": 1, "whole tumour": [1, 2], "tumour": 2}})");
  ASSERT_TRUE(two);
  EXPECT_EQ(two->at(1).Name, "liver");
  EXPECT_EQ(two->at(2).Name, "tumour");
  EXPECT_EQ(two->size(), 3U);
  EXPECT_EQ(LabelsOfDataset(R"({"labels": {"0": "background", "7": "spleen"}})")->at(7).Name,
            "spleen");
  for (const char* text : {"", "{", "[]", R"({"labels": []})", R"({"labels": {"a": -1}})",
                           R"({"labels": {"a": 1e300}})", R"({"labels": {}})"})
  {
    EXPECT_FALSE(LabelsOfDataset(text)) << text;
  }
}

class LabelTableNextToMask : public testing::Test
{
protected:
  LabelTableNextToMask()
  {
    std::filesystem::create_directory(this->Folder / "labelsTr");
    std::string voxels(120, '\0');
    voxels[0] = 1;
    voxels[1] = 2;
    WriteAll(this->Mask, NiftiBytes({}, voxels));
  }
  std::string NameOfTwo() const { return ReadSegmentation(this->Mask).Segments[1].Name; }

  TemporaryFolder Folder;
  std::filesystem::path Mask = this->Folder / "labelsTr/case_1.nii";
};

TEST_F(LabelTableNextToMask, NamesComeFromEachKindOfFile)
{
  const std::pair<const char*, const char*> files[] = {
      {"labelsTr/case_1.label", "2 255 0 0 1 1 1 \"of itk-snap\"\n"},
      {"labelsTr/case_1.tsv", "index\tname\n2\tof bids\n"},
      {"labelsTr/case_1.label.csv", "label,name\n2,of csv\n"},
      {"labelsTr/FreeSurferColorLUT.txt", "2 of_freesurfer 245 245 245 0\n"},
      {"labelsTr/dataset.json", R"({"labels": {"of nnunet": 2}})"},
      {"dataset.json", R"({"labels": {"of the data set": 2}})"}};
  for (const auto& [name, text] : files)
  {
    const std::string before = StampOf(this->Mask);
    WriteAll(this->Folder / name, text);
    EXPECT_EQ(this->NameOfTwo().rfind("of", 0), 0U) << name;
    EXPECT_NE(StampOf(this->Mask), before) << "so it is read again";
    std::filesystem::remove(this->Folder / name);
    EXPECT_EQ(this->NameOfTwo(), "");
  }
}

TEST_F(LabelTableNextToMask, FilesOfOtherContentAreNoTables)
{
  WriteAll(this->Folder / "labelsTr/case_1.txt", "a remark\n");
  WriteAll(this->Folder / "labelsTr/case_1.csv", "index,name\n7,of another label\n");
  WriteAll(this->Folder / "dataset.json", R"({"name": "a set"})");
  const Segmentation mask = ReadSegmentation(this->Mask);
  EXPECT_EQ(mask.Segments[1].Name, "");
  EXPECT_TRUE(mask.Notes.empty()) << mask.Notes.front();
}
} // namespace
} // namespace palpate::label_table_test
