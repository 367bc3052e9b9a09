#include "StudyMarkups.h"

#include "InputError.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::study_markups_test
{
namespace
{
const std::vector<StudyLandmark> Landmarks{{"apex", Vector3(0.1, -20.5, 1.0 / 3.0)},
                                           {"base, \"left\"", Vector3(1.0, 2.0, 3.0)}};
const std::vector<StudyDistance> Distances{
    {"width", Vector3(1.0, 2.0, 3.0), Vector3(1.0, 5.0, 7.0)}};

TEST(StudyMarkups, SlicerFileHasPointsAndLinesInLps)
{
  const test::TemporaryFolder folder;
  WriteMarkups(folder / "a.mrk.json", Landmarks, Distances);
  const auto root = nlohmann::json::parse(test::ReadAll(folder / "a.mrk.json"));
  EXPECT_NE(root["@schema"].get<std::string>().find("markups-schema-v1.0"), std::string::npos);
  const auto& markups = root["markups"];
  ASSERT_EQ(markups.size(), 2U);
  for (const auto& markup : markups)
  {
    EXPECT_EQ(markup["coordinateSystem"], "LPS");
    EXPECT_EQ(markup["coordinateUnits"], "mm");
  }
  EXPECT_EQ(markups[0]["type"], "Fiducial");
  ASSERT_EQ(markups[0]["controlPoints"].size(), 2U);
  EXPECT_EQ(markups[0]["controlPoints"][0]["label"], "apex");
  EXPECT_EQ(markups[0]["controlPoints"][0]["position"][2].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(markups[0]["controlPoints"][1]["label"], "base, \"left\"");
  EXPECT_EQ(markups[1]["type"], "Line");
  EXPECT_EQ(markups[1]["controlPoints"][1]["position"][1].get<double>(), 5.0);
  EXPECT_EQ(markups[1]["measurements"][0]["value"].get<double>(), 5.0);
}

TEST(StudyMarkups, TableHasOneLineEachWithQuotedNames)
{
  const test::TemporaryFolder folder;
  WriteMarkups(folder / "a.csv", Landmarks, Distances);
  EXPECT_EQ(test::ReadAll(folder / "a.csv"),
            "kind,name,x_mm,y_mm,z_mm,to_x_mm,to_y_mm,to_z_mm,length_mm\n"
            "landmark,apex,0.1,-20.5,0.3333333333333333,,,,\n"
            "landmark,\"base, \"\"left\"\"\",1,2,3,,,,\n"
            "distance,width,1,2,3,1,5,7,5\n");
}

TEST(StudyMarkups, RejectsEmptyMarkupsAndOtherEndings)
{
  const test::TemporaryFolder folder;
  EXPECT_THROW(WriteMarkups(folder / "a.csv", {}, {}), InputError);
  EXPECT_THROW(WriteMarkups(folder / "a.json", Landmarks, Distances), InputError);
  EXPECT_THROW(WriteMarkups(folder / "a.mrk.json", {{"\xFF", Vector3::Zero()}}, {}), InputError);
  EXPECT_EQ(folder.EntryCount(), 0U);
}
} // namespace
} // namespace palpate::study_markups_test
