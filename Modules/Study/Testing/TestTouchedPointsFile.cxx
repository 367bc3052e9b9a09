#include "TouchedPointsFile.h"

#include "MessageOf.h"
#include "StudyMarkups.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::touched_points_file_test
{
namespace
{
using namespace palpate::test;

class TouchedPointsFile : public testing::Test
{
protected:
  std::vector<SurfaceTouch> Read(const std::string& name, const std::string& text) const
  {
    WriteWholeFile(this->Folder / name, text);
    return ReadTouchedPoints(this->Folder / name, 0.7);
  }
  std::string Refusal(const std::string& text) const
  {
    return MessageOf([&] { this->Read("bad.csv", text); });
  }

  TemporaryFolder Folder;
};

TEST_F(TouchedPointsFile, ReadsPlainTables)
{
  const auto touches = this->Read("a.csv", "x,y,z\n1,2,3\n-4.5,5e1,6\n");
  ASSERT_EQ(touches.size(), 2U);
  EXPECT_EQ(touches[1].PointWorld, Vector3(-4.5, 50.0, 6.0));
  EXPECT_EQ(touches[0].Deviation, 0.7);
  EXPECT_FALSE(touches[0].Normal);
  EXPECT_FALSE(touches[0].IsOutside);
}

TEST_F(TouchedPointsFile, ReadsNormalsStrokesDeviationsAndPointsOutside)
{
  const auto touches = this->Read("a.csv", "z_mm;y_mm;x_mm;nx;ny;nz;sd;stroke;outside\n"
                                           "3;2;1;0;0;-2;0.25;4;0\n"
                                           "6;5;4;;;;;;1\n");
  ASSERT_EQ(touches.size(), 2U);
  EXPECT_EQ(touches[0].PointWorld, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(*touches[0].Normal, Vector3(0.0, 0.0, -2.0));
  EXPECT_EQ(touches[0].Deviation, 0.25);
  EXPECT_EQ(touches[0].Stroke, 4);
  EXPECT_FALSE(touches[1].Normal);
  EXPECT_EQ(touches[1].Deviation, 0.7);
  EXPECT_TRUE(touches[1].IsOutside);
}

TEST_F(TouchedPointsFile, ReadsWhatTheWindowWrites)
{
  StudyMarkups markups;
  markups.Landmarks = {{"a", {1, 2, 3}}, {"b", {4, 5, 6}}};
  for (const char* name : {"a.csv", "a.mrk.json"})
  {
    WriteMarkups(this->Folder / name, markups);
    const auto touches = ReadTouchedPoints(this->Folder / name, 0.7);
    ASSERT_EQ(touches.size(), 2U) << name;
    EXPECT_EQ(touches[1].PointWorld, Vector3(4.0, 5.0, 6.0)) << name;
    EXPECT_EQ(touches[1].Stroke, 0) << name;
  }
}

TEST_F(TouchedPointsFile, CurvesOfSlicerAreStrokes)
{
  StudyMarkups markups;
  StudyMeasurement curve;
  curve.Kind = MeasurementKind::Curve;
  curve.PointsWorld = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}};
  StudyMeasurement line;
  line.PointsWorld = {{7, 7, 7}, {8, 8, 8}};
  markups.Measurements = {line, curve, curve};
  WriteMarkups(this->Folder / "a.mrk.json", markups);
  const auto touches = ReadTouchedPoints(this->Folder / "a.mrk.json", 1.0);
  ASSERT_EQ(touches.size(), 6U); // the end that is the start counts once, the line not at all
  EXPECT_EQ(touches[2].Stroke, 1);
  EXPECT_EQ(touches[3].Stroke, 2);
}

TEST_F(TouchedPointsFile, ReadsFcsvInItsFrame)
{
  const std::string rows = "a,1,2,3,0,0,0,1,1,1,0,F-1,,\n";
  const std::string head =
      "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
  EXPECT_EQ(this->Read("a.fcsv", "# CoordinateSystem = LPS\n" + head + rows)[0].PointWorld,
            Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(this->Read("a.fcsv", "# CoordinateSystem = 0\n" + head + rows)[0].PointWorld,
            Vector3(-1.0, -2.0, 3.0));
  EXPECT_EQ(this->Read("a.fcsv", head + rows)[0].PointWorld, Vector3(-1.0, -2.0, 3.0));
}

TEST_F(TouchedPointsFile, RefusesWhatItCannotRead)
{
  EXPECT_TRUE(Contains(this->Refusal("x,y\n1,2\n"), "point 1 no number for z"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z\n1,2,3\n1,b,3\n"), "point 2 no number for y"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z\n1,2,nan\n"), "no number for z"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z,stroke\n1,2,3,-1\n"), "no number for stroke"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z,stroke\n1,2,3,1.5\n"), "no number for stroke"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z,outside\n1,2,3,2\n"), "no number for outside"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z,nx,ny\n1,2,3,0,1\n"), "no number for nz"));
  EXPECT_TRUE(Contains(this->Refusal("x,y,z\n"), "has no points"));
}

TEST_F(TouchedPointsFile, TableHoldsAllThatIsKnown)
{
  const std::vector<SurfaceTouch> touches{{{1.0 / 3.0, -2e-7, 3.0}, 0.25, Vector3(0.6, 0.0, -0.8)},
                                          {{4.0, 5.0, 6.0}, 1.5, std::nullopt, 2},
                                          {{7.0, 8.0, 9.0}, 1.0, std::nullopt, 0, true}};
  WriteTouchedPoints(this->Folder / "t.csv", touches);
  EXPECT_EQ(ReadTouchedPoints(this->Folder / "t.csv", 0.7), touches);
}

TEST_F(TouchedPointsFile, MarkupsHoldPointsAndStrokes)
{
  const std::vector<SurfaceTouch> touches{{{1.0, 2.0, 3.0}, 0.7},
                                          {{4.0, 5.0, 6.0}, 0.7, std::nullopt, 1},
                                          {{5.0, 5.0, 6.0}, 0.7, std::nullopt, 1},
                                          {{6.0, 5.0, 7.0}, 0.7, std::nullopt, 1}};
  WriteTouchedPoints(this->Folder / "t.mrk.json", touches);
  EXPECT_EQ(ReadTouchedPoints(this->Folder / "t.mrk.json", 0.7), touches);
}

TEST_F(TouchedPointsFile, RefusesToLosePointsOutside)
{
  const std::vector<SurfaceTouch> touches{{{7.0, 8.0, 9.0}, 1.0, std::nullopt, 0, true}};
  const std::string message =
      MessageOf([&] { WriteTouchedPoints(this->Folder / "t.mrk.json", touches); });
  EXPECT_NE(message.find("outside"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "t.mrk.json"));
  EXPECT_NE(MessageOf([&] { WriteTouchedPoints(this->Folder / "t.csv", {}); }), "");
}
} // namespace
} // namespace palpate::touched_points_file_test
