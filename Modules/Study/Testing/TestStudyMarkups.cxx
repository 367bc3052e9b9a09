#include "StudyMarkupsReader.h"

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

StudyMeasurement Measurement(MeasurementKind kind, const std::vector<Vector3>& points)
{
  StudyMeasurement measurement;
  measurement.Kind = kind;
  measurement.Name = NameOf(kind);
  measurement.PointsWorld = points;
  return measurement;
}

const StudyMeasurement Width =
    Measurement(MeasurementKind::Line, {{1.0, 2.0, 3.0}, {1.0, 5.0, 7.0}});
const StudyMeasurement Corner = Measurement(
    MeasurementKind::Angle, {{5.0, 0.0, 1.0 / 3.0}, {0.0, 0.0, 1.0 / 3.0}, {0.0, 2.0, 1.0 / 3.0}});

class MarkupsFile : public testing::Test
{
protected:
  StudyMarkups Written(const StudyMarkups& markups)
  {
    WriteMarkups(this->Path, markups);
    return ReadMarkups(this->Path);
  }
  // The markups of this text; "markups" and its brackets are added.
  StudyMarkups Read(const std::string& text)
  {
    test::WriteAll(this->Path, R"({"markups": [)" + text + "]}");
    return ReadMarkups(this->Path);
  }
  std::string RefusalOf(const std::string& text)
  {
    try
    {
      test::WriteAll(this->Path, text);
      ReadMarkups(this->Path);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder Folder;
  std::filesystem::path Path = Folder / "a.mrk.json";
};

TEST_F(MarkupsFile, HasPointsAndLinesInLps)
{
  WriteMarkups(this->Path, {Landmarks, {Width, Corner}});
  const auto root = nlohmann::json::parse(test::ReadAll(this->Path));
  EXPECT_NE(root["@schema"].get<std::string>().find("markups-schema-v1.0.3"), std::string::npos);
  const auto& markups = root["markups"];
  ASSERT_EQ(markups.size(), 3U);
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
  EXPECT_EQ(markups[2]["type"], "Angle");
  EXPECT_EQ(markups[2]["measurements"][0]["units"], "deg");
  EXPECT_NEAR(markups[2]["measurements"][0]["value"].get<double>(), 90.0, 1e-12);
}

TEST_F(MarkupsFile, ReadsBackWhatItHasATypeFor)
{
  const StudyMeasurement curve =
      Measurement(MeasurementKind::Curve, {{0.1, 0.2, 0.3}, {1.0, 0.0, 0.0}, {2.0, 5.0, 0.0}});
  const StudyMeasurement plane =
      Measurement(MeasurementKind::Plane, {{0.1, 0.2, 0.3}, {1.0, 0.0, 0.0}, {2.0, 5.0, 0.0}});
  const StudyMarkups all{Landmarks, {Width, Corner, curve, plane}};
  const StudyMarkups read = this->Written(all);
  EXPECT_EQ(read.Landmarks, all.Landmarks);
  EXPECT_EQ(read.Measurements, all.Measurements);
}

// Other programs have no type for them: the drawn line with its length is kept.
TEST_F(MarkupsFile, KeepsLinesAndValuesOfWhatWasFoundOnSurfaces)
{
  StudyMeasurement curve =
      Measurement(MeasurementKind::SurfaceCurve, {{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}});
  curve.PathWorld = {{0.0, 0.0, 0.0}, {2.0, 3.0, 0.0}, {4.0, 0.0, 0.0}};
  curve.StructureId = 7;
  StudyMeasurement wall = Width;
  wall.Kind = MeasurementKind::Thickness;
  const StudyMarkups read = this->Written({{}, {curve, wall}});
  ASSERT_EQ(read.Measurements.size(), 2U);
  EXPECT_EQ(read.Measurements[0].Kind, MeasurementKind::Curve);
  EXPECT_EQ(read.Measurements[0].PointsWorld, curve.PathWorld);
  EXPECT_EQ(ValueOf(read.Measurements[0]), ValueOf(curve));
  EXPECT_EQ(read.Measurements[1].Kind, MeasurementKind::Line);
  EXPECT_EQ(ValueOf(read.Measurements[1]), 5.0);
}

TEST_F(MarkupsFile, HasNoOpenMeasurement)
{
  StudyState state;
  state.Measurements = {Width, Corner};
  state.Measurements[1].PointsWorld.resize(2);
  state.Measurements[1].IsOpen = true;
  EXPECT_EQ(this->Written(MarkupsOf(state)).Measurements, std::vector<StudyMeasurement>{Width});
}

TEST_F(MarkupsFile, ReadsRasAndMicrometres)
{
  const StudyMarkups read = this->Read(
      R"({"type": "Line", "name": "width", "coordinateSystem": "RAS",
          "coordinateUnits": ["um", "UCUM", "micrometer"], "display": {"opacity": 0.5},
          "controlPoints": [{"label": "a", "position": [1000, 2000, 3000]},
                            {"label": "b", "position": [1000, 2000, 7000], "locked": true}]})");
  ASSERT_EQ(read.Measurements.size(), 1U);
  EXPECT_EQ(read.Measurements[0].Name, "width");
  EXPECT_EQ(read.Measurements[0].PointsWorld[0], Vector3(-1.0, -2.0, 3.0));
  EXPECT_EQ(ValueOf(read.Measurements[0]), 4.0);
}

TEST_F(MarkupsFile, LeavesOutPointsThatWereNotPlacedAndOtherTypes)
{
  const StudyMarkups read = this->Read(
      R"({"type": "Fiducial", "controlPoints": [
            {"label": "a", "position": [], "positionStatus": "undefined"},
            {"position": [1, 2, 3], "positionStatus": "defined"}, {"label": "c"}]},
         {"type": "Angle", "controlPoints": [{"position": [1, 2, 3]}]},
         {"type": "ROI", "controlPoints": [{"position": [1, 2, 3]}], "size": [1, 2, 3]})");
  ASSERT_EQ(read.Landmarks.size(), 1U);
  EXPECT_EQ(read.Landmarks[0].Name, "F-1");
  EXPECT_TRUE(read.Measurements.empty());
}

TEST_F(MarkupsFile, ClosedCurveEndsWhereItBegins)
{
  const StudyMarkups read = this->Read(
      R"({"type": "ClosedCurve", "controlPoints": [{"position": [0, 0, 0]},
            {"position": [3, 0, 0]}, {"position": [3, 4, 0]}]})");
  ASSERT_EQ(read.Measurements.size(), 1U);
  EXPECT_EQ(ValueOf(read.Measurements[0]), 12.0);
}

TEST_F(MarkupsFile, PlaneMayBeGivenByItsNormal)
{
  const StudyMarkups read = this->Read(
      R"({"type": "Plane", "coordinateSystem": "RAS", "planeType": "pointNormal",
          "normal": [0.6, 0, 0.8], "controlPoints": [{"position": [1, 2, 3]}]})");
  ASSERT_EQ(read.Measurements.size(), 1U);
  const std::vector<Vector3>& points = read.Measurements[0].PointsWorld;
  EXPECT_EQ(points[0], Vector3(-1.0, -2.0, 3.0));
  const Vector3 normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized();
  EXPECT_LT((normal - Vector3(-0.6, 0.0, 0.8)).norm(), 1e-12);
}

TEST_F(MarkupsFile, NamesWhatItRefuses)
{
  const auto refusal = [this](const std::string& markup)
  { return this->RefusalOf(R"({"markups": [{"type": "Line", )" + markup + "}]}"); };
  for (const auto& [text, fact] : std::vector<std::pair<std::string, std::string>>{
           {R"("coordinateSystem": "HFS")", "coordinateSystem"},
           {R"("coordinateUnits": "inch")", "unit"},
           {R"("controlPoints": [{"position": [1, 2]}])", "position"},
           {R"("controlPoints": [{"position": [1, 2, 1e7]}])", "controlPoints[0]"},
           {R"("controlPoints": [{"position": [1, 2, 1e300]}])", "position"},
           {R"("controlPoints": [7])", "controlPoints[0]"},
           {R"("controlPoints": {"a": 1})", "list"},
           {R"("name": 3)", "name"},
           {R"("controlPoints": [])", "no points"}})
  {
    EXPECT_NE(refusal(text).find(fact), std::string::npos) << text << ": " << refusal(text);
    EXPECT_NE(refusal(text).find(this->Path.string()), std::string::npos);
  }
  for (const char* text : {"{}", "[]", "3", R"({"markups": 3})", "no JSON", R"({"markups": [3]})",
                           R"({"markups": [{"type": "Plane", "controlPoints": []}]})"})
  {
    EXPECT_NE(this->RefusalOf(text), "") << text;
  }
}

TEST_F(MarkupsFile, RefusesMoreThanCanBeDrawn)
{
  std::string points = R"({"type": "Fiducial", "controlPoints": [)";
  for (int i = 0; i < 2001; ++i)
  {
    points += std::string(i == 0 ? "" : ", ") + R"({"position": [1, 2, 3]})";
  }
  EXPECT_NE(this->RefusalOf(R"({"markups": [)" + points + "]}]}").find("2000"), std::string::npos);
}

TEST_F(MarkupsFile, TableHasOneLinePerPointWithQuotedNames)
{
  WriteMarkups(this->Folder / "a.csv", {Landmarks, {Width}});
  EXPECT_EQ(test::ReadAll(this->Folder / "a.csv"),
            "kind,name,point,x_mm,y_mm,z_mm,value,unit\n"
            "Landmark,apex,1,0.1,-20.5,0.3333333333333333,,\n"
            "Landmark,\"base, \"\"left\"\"\",1,1,2,3,,\n"
            "Line,Line,1,1,2,3,5,mm\n"
            "Line,Line,2,1,5,7,5,mm\n");
}

TEST_F(MarkupsFile, RejectsEmptyMarkupsAndOtherEndings)
{
  EXPECT_THROW(WriteMarkups(this->Folder / "a.csv", {}), InputError);
  EXPECT_THROW(WriteMarkups(this->Folder / "a.json", {Landmarks, {}}), InputError);
  EXPECT_THROW(WriteMarkups(this->Path, {{{"\xFF", Vector3::Zero()}}, {}}), InputError);
  EXPECT_EQ(this->Folder.EntryCount(), 0U);
}
} // namespace
} // namespace palpate::study_markups_test
