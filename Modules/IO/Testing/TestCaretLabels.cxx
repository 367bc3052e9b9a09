#include "CaretLabels.h"
#include "ImageGrid.h"
#include "ImageWriter.h"
#include "SegmentationFile.h"
#include "SegmentationWriter.h"
#include "StoredImages.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace palpate::caret_labels_test
{
namespace
{
using namespace palpate::test;
using Color = std::array<double, 3>;

// As TotalSegmentator writes it, for two of its organs.
const std::string Xml =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?> <CaretExtension>  "
    "<Date><![CDATA[2013-07-14]]></Date>"
    "<VolumeInformation Index=\"0\"><LabelTable>\n"
    "<Label Key=\"1\" Red=\"0.0\" Green=\"1.0\" Blue=\"0.5019607843137255\" Alpha=\"1\">"
    "<![CDATA[spleen]]></Label>\n"
    "<Label Key=\"2\" Red=\"1.0\" Green=\"0.0\" Blue=\"0.0\" Alpha=\"1\">"
    "<![CDATA[kidney_right]]></Label>\n"
    "</LabelTable><VolumeType><![CDATA[Label]]></VolumeType></VolumeInformation></CaretExtension>";

// A file of 60 voxels of 1 and 60 of 2, with one extension of this code.
std::string WithExtension(const std::string& text, std::int32_t code)
{
  return WithNiftiExtension(NiftiBytes({}, std::string(60, '\1') + std::string(60, '\2')), text,
                            code);
}

Segmentation ReadLabels(const TemporaryFolder& folder, const std::string& bytes)
{
  WriteAll(folder / "a.nii", bytes);
  return ReadSegmentation(folder / "a.nii");
}

TEST(CaretLabels, ReadsNamesAndColours)
{
  const auto table = LabelsOfCaret(Xml);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->size(), 2U);
  EXPECT_EQ(table->at(1).Name, "spleen");
  EXPECT_EQ(*table->at(1).Color, (Color{0.0, 1.0, 128.0 / 255.0}));
  EXPECT_EQ(table->at(2).Name, "kidney_right");
}

TEST(CaretLabels, EveryTextSurvives)
{
  LabelTable table;
  table[0] = {"a ]]> b ]]]]>> \"&amp;<Label>", Color{0.1, 1.0 / 3.0, 1.0}};
  table[-5] = {"", Color{0.0, 0.0, 0.0}};
  table[70000] = {"G\u00e4rtner", Color{1.0, 1.0, 1.0}};
  const auto read = LabelsOfCaret(CaretTextOf(table));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), table.size());
  for (const auto& [key, entry] : table)
  {
    EXPECT_EQ(read->at(key).Name, entry.Name);
    EXPECT_EQ(*read->at(key).Color, *entry.Color);
  }
}

TEST(CaretLabels, RejectsOtherAndDamagedTexts)
{
  std::string entity = Xml;
  entity.insert(Xml.find("?>") + 2, "<!DOCTYPE a [<!ENTITY b \"c\">]>");
  for (const std::string& text :
       {std::string(), std::string("liver"), Xml.substr(0, Xml.size() - 5), entity,
        std::string("<a><LabelTable><Label Key=\"1\">liver</Label></LabelTable></a>"),
        std::string("<CaretExtension><LabelTable></LabelTable></CaretExtension>"),
        std::string("<CaretExtension><Label Key=\"one\">liver</Label></CaretExtension>")})
  {
    EXPECT_FALSE(LabelsOfCaret(text)) << text;
  }
}

TEST(CaretLabels, TakesTheFirstVolumesTable)
{
  const auto table =
      LabelsOfCaret("<CaretExtension><LabelTable><Label Key=\"1\">liver</Label></LabelTable>"
                    "<LabelTable><Label Key=\"1\">spleen</Label></LabelTable></CaretExtension>");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(1).Name, "liver");
  EXPECT_FALSE(table->at(1).Color);
}

TEST(CaretLabels, NamesAreReadFromHeadersOfBothCodes)
{
  const TemporaryFolder folder;
  for (const std::int32_t code : {0, 30})
  {
    const Segmentation read = ReadLabels(folder, WithExtension(Xml, code));
    ASSERT_EQ(read.Segments.size(), 2U);
    EXPECT_EQ(read.Segments[0].Name, "spleen");
    EXPECT_EQ(read.Segments[1].Color, (Color{1.0, 0.0, 0.0}));
  }
}

TEST(CaretLabels, TableOfTheFileCountsMoreAndThatOfTheFolderLess)
{
  const TemporaryFolder folder;
  WriteAll(folder / "dataset.json", R"({"labels": {"folder": 1}})");
  EXPECT_EQ(ReadLabels(folder, WithExtension(Xml, 0)).Segments[0].Name, "spleen");
  WriteAll(folder / "a.label", "1 renamed\n");
  EXPECT_EQ(ReadLabels(folder, WithExtension(Xml, 0)).Segments[0].Name, "renamed");
}

TEST(CaretLabels, NiftiKeepsNamesColoursAndVoxels)
{
  const TemporaryFolder folder;
  const Segmentation named = ReadLabels(folder, WithExtension(Xml, 0));
  for (const char* name : {"b.nii", "c.nii.gz"})
  {
    WriteSegmentation(folder / name, named);
    const Segmentation read = ReadSegmentation(folder / name);
    ASSERT_EQ(read.Segments.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i)
    {
      EXPECT_EQ(read.Segments[i].Name, named.Segments[i].Name);
      EXPECT_EQ(read.Segments[i].Color, named.Segments[i].Color);
    }
    vtkDataArray* voxels = read.Layers[0]->GetPointData()->GetScalars();
    ASSERT_EQ(voxels->GetNumberOfTuples(), 120);
    for (vtkIdType i = 0; i < 120; ++i)
    {
      ASSERT_EQ(voxels->GetTuple1(i), i < 60 ? 1.0 : 2.0);
    }
    EXPECT_TRUE(IsSameGrid(GridOf(read.Layers[0]), GridOf(named.Layers[0])));
  }
  EXPECT_EQ(ReadAll(folder / "c.nii.gz").substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(ReadAll(folder / "b.nii").substr(0, 2), "\x5c\x01"); // not compressed
}

TEST(CaretLabels, FileWithoutNamesHasNoExtension)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nii", NiftiBytes({}, std::string(120, '\1')));
  const Segmentation plain = ReadSegmentation(folder / "a.nii");
  WriteSegmentation(folder / "b.nii", plain);
  WriteImage(folder / "c.nii", plain.Layers[0]);
  EXPECT_EQ(ReadAll(folder / "b.nii"), ReadAll(folder / "c.nii"));
}

TEST(CaretLabels, ItkSnapTableGivesNamesAndColoursBack)
{
  const TemporaryFolder folder;
  Segmentation named = ReadLabels(folder, WithExtension(Xml, 0));
  named.Segments[1].Name = "a \"big\"\none";
  WriteSegmentation(folder / "n.txt", named);
  const auto table = LabelLines(ReadAll(folder / "n.txt"));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->at(1).Name, "spleen");
  EXPECT_EQ(*table->at(1).Color, (Color{0.0, 1.0, 128.0 / 255.0}));
  EXPECT_EQ(table->at(2).Name, "a 'big''one");
}
} // namespace
} // namespace palpate::caret_labels_test
