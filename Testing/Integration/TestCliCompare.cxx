#include "CommandRun.h"
#include "IsSoon.h"
#include "JsonLines.h"
#include "MeshShapes.h"
#include "ShapeMirror.h"
#include "ShapeSuperposition.h"
#include "StartedCommand.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "TriangleMesh.h"
#include "TwoVolumes.h"

#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace palpate::cli_compare_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

// A model of a sphere; its centre is in mm.
void WriteSphere(const std::filesystem::path& path, double radius, const Vector3& center)
{
  ModelDocument document;
  document.Surface = RadialModel(0, {radius * std::sqrt(4.0 * M_PI)}, center);
  WriteModel(path, document);
}

void WriteMesh(const std::filesystem::path& path, const IndexedMesh& mesh)
{
  TriangleMesh triangles;
  triangles.PointsWorld = mesh.Points;
  triangles.Triangles = mesh.Triangles;
  WriteSurface(path, PolyDataOf(triangles));
}

// A lump without a plane of symmetry.
OrganModel Lump(const Vector3& center = Vector3(30.0, -10.0, 5.0))
{
  return RadialModel(
      3, {70.0, 3.0, -2.0, 4.0, 5.0, -3.0, 6.0, 2.0, -4.0, 1.0, 3.0, -2.0, 2.0, 1.0, -3.0, 2.0},
      center);
}

void WriteOrgan(const std::filesystem::path& path, const OrganModel& organ)
{
  ModelDocument document;
  document.Surface = organ;
  WriteModel(path, document);
}

std::vector<Json> Compare(const TemporaryFolder& folder, std::vector<std::string> words,
                          int code = 0)
{
  words.insert(words.begin(), "compare");
  words.emplace_back("--json");
  const CommandRun run = RunPalpate(words, folder.Path());
  EXPECT_EQ(run.Code, code) << run.Errors;
  std::vector<Json> objects;
  std::istringstream lines(run.Output);
  for (std::string line; std::getline(lines, line);)
  {
    objects.push_back(Json::parse(line));
  }
  return objects;
}

TEST(CliCompare, MirroredSideHasNoAsymmetry)
{
  const TemporaryFolder folder;
  // Turned, too; TurnShape is about the origin.
  const Matrix3 turn = Eigen::AngleAxisd(0.2, Vector3(1.0, 2.0, -1.0).normalized()).matrix();
  WriteOrgan(folder / "left.json", Lump());
  WriteOrgan(folder / "right.json", TurnShape(MirrorShape(Lump()), {turn, turn}));
  const Json pair = Compare(folder, {"left.json", "right.json", "--mirror"}).at(0);
  const Json& mirror = pair.at("mirror");
  EXPECT_NEAR(mirror.at("turn_deg").get<double>(), 0.2 * 180.0 / M_PI, 0.05); // of triangles
  EXPECT_LT(mirror.at("shape_asymmetry_percent").get<double>(), 0.1);
  EXPECT_NEAR(mirror.at("volume_asymmetry_percent").get<double>(), 0.0, 1e-3);
  EXPECT_GT(pair.at("overlap").at("dice").get<double>(), 0.999);
}

TEST(CliCompare, AsymmetryIsThatOfSizeAndShape)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "left.json", 11.0, Vector3(30.0, 0.0, 0.0));
  WriteSphere(folder / "right.json", 10.0, Vector3(-30.0, 2.0, 0.0));
  const Json mirror = Compare(folder, {"left.json", "right.json", "--mirror"}).at(0).at("mirror");
  EXPECT_NEAR(mirror.at("volume_asymmetry_percent").get<double>(),
              200.0 * (1331.0 - 1000.0) / (1331.0 + 1000.0), 1e-6);
  EXPECT_NEAR(mirror.at("shape_asymmetry_percent").get<double>(), 100.0 / 11.0, 0.05); // triangles
  EXPECT_NEAR(mirror.at("shift_mm").at(1).get<double>(), -2.0, 0.01);
  EXPECT_TRUE(Compare(folder, {"left.json", "right.json"}).at(0).at("mirror").is_null());
}

TEST(CliCompare, MotionIsThatOfTheBodyAndItsLandmarks)
{
  const TemporaryFolder folder;
  const Vector3 shift(3.0, -4.0, 2.0);
  const Vector3 before(30.0, -10.0, 5.0);
  WriteOrgan(folder / "before.json", Lump(before));
  WriteOrgan(folder / "after.json", Lump(before + shift));
  const Vector3 place =
      before + std::get<RadialModel>(Lump()).Radius(Vector3::UnitY()) * Vector3::UnitY();
  std::ostringstream landmark;
  landmark << place.x() << ',' << place.y() << ',' << place.z();
  const Json motion = Compare(folder, {"after.json", "before.json", "--landmark=" + landmark.str()})
                          .at(0)
                          .at("motion");
  EXPECT_NEAR(motion.at("turn_deg").get<double>(), 0.0, 0.01);
  EXPECT_NEAR(motion.at("rest_mm").get<double>(), 0.0, 0.01);
  const std::vector<double> moved = motion.at("landmarks_mm").at(0);
  const std::vector<double> way = motion.at("shift_mm");
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(way[axis], shift[axis], 0.01);
    EXPECT_NEAR(moved[axis], place[axis] + shift[axis], 0.01);
  }
}

TEST(CliCompare, VolumesOverTimeAreComparedWithTheFirst)
{
  const TemporaryFolder folder;
  WriteTwoVolumes(folder / "beat.nii"); // balls of 6 and 9 mm about one centre
  const std::vector<Json> phases =
      Compare(folder, {"beat.nii", "--time", "40", "--output", "beat", "--jobs", "1"});
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_EQ(phases[0].at("time"), 0.0);
  EXPECT_EQ(phases[1].at("time"), 40.0);
  EXPECT_NEAR(phases[0].at("motion").at("rest_mm").get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(phases[1].at("motion").at("rest_mm").get<double>(), 3.0, 0.25); // voxels of 1 mm
  EXPECT_NEAR(phases[1].at("first").at("volume_ml").get<double>(), 3.054, 0.15);
  EXPECT_NE(ReadAll(folder / "beat" / "report.html").find("over time"), std::string::npos);
  // Resumed from the table: nothing is compared again, and the page keeps its charts.
  EXPECT_TRUE(Compare(folder, {"beat.nii", "--time", "40", "--output", "beat"}).empty());
  EXPECT_NE(ReadAll(folder / "beat" / "report.html").find("over time"), std::string::npos);
}

TEST(CliCompare, TimesFitTheVolumes)
{
  const TemporaryFolder folder;
  WriteTwoVolumes(folder / "beat.nii");
  const auto errors = [&folder](const std::vector<std::string>& words)
  { return RunPalpate(words, folder.Path()).Errors; };
  EXPECT_NE(errors({"compare", "beat.nii", "--time", "1,2,3"}).find("has 2 volumes"),
            std::string::npos);
  EXPECT_NE(errors({"compare", "beat.nii", "beat.nii", "--time", "1"}).find("without REFERENCE"),
            std::string::npos);
  WriteTwoSpheres(folder / "one.nii.gz");
  EXPECT_NE(errors({"compare", "one.nii.gz", "--time", "1"}).find("has one volume"),
            std::string::npos);
}

TEST(CliCompare, MirrorIsForTwoFiles)
{
  const TemporaryFolder folder;
  for (const char* side : {"a", "b"})
  {
    std::filesystem::create_directory(folder / side);
    WriteOrgan(folder / side / "organ.json", Lump());
  }
  EXPECT_NE(RunPalpate({"compare", "a", "b", "--mirror"}, folder.Path())
                .Errors.find("--mirror is for two files"),
            std::string::npos);
}

TEST(CliCompare, ThresholdMakesStructuresOfImagesOnly)
{
  const TemporaryFolder folder;
  WriteGradedSphere(folder / "p.nii.gz");
  WriteSphere(folder / "a.json", 10.0, Vector3::Zero());
  Compare(folder, {"p.nii.gz", "a.json"}, 2);
  const auto pairs = Compare(folder, {"p.nii.gz", "a.json", "--threshold", "0.5"});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_GT(pairs[0].at("overlap").at("dice").get<double>(), 0.98);
  Compare(folder, {"a.json", "a.json", "--threshold", "0.5"}, 2);
}

TEST(CliCompare, TwoModelsHaveTheirExactDistances)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "a.json", 22.0, {100.0, -50.0, 7.0});
  WriteSphere(folder / "b.json", 20.0, {100.0, -50.0, 7.0});
  const Json pair = Compare(folder, {"a.json", "b.json", "--tolerance", "1.5,2.5"}).at(0);
  EXPECT_NEAR(pair.at("distance").at("both").at("mean_mm").get<double>(), 2.0, 1e-9);
  EXPECT_NEAR(pair.at("distance").at("hausdorff95_mm").get<double>(), 2.0, 1e-9);
  EXPECT_NEAR(pair.at("distance").at("first_to_reference").at("signed_mean_mm").get<double>(), 2.0,
              1e-9);
  EXPECT_EQ(pair.at("surface_dice").at(0).at("value"), 0.0);
  EXPECT_EQ(pair.at("surface_dice").at(1).at("value"), 1.0);
  EXPECT_NEAR(pair.at("volume_difference_percent").get<double>(), 33.1, 1e-9);
  EXPECT_EQ(pair.at("overlap").at("cells"), "none");
  EXPECT_TRUE(pair.at("overlap").at("spacing_mm").is_null());
  EXPECT_NEAR(pair.at("overlap").at("dice").get<double>(), 2.0 / (1.0 + 1.331), 1e-9);
}

TEST(CliCompare, TolerancesMayComeBeforeTheFiles)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "a.json", 22.0, Vector3::Zero());
  const Json pair = Compare(folder, {"--tolerance", "4,0.5", "a.json", "a.json"}).at(0);
  ASSERT_EQ(pair.at("surface_dice").size(), 2u);
  EXPECT_EQ(pair.at("surface_dice").at(0).at("tolerance_mm"), 0.5);
}

TEST(CliCompare, StructuresOfOneNumberArePaired)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::vector<Json> pairs = Compare(folder, {"a.nii.gz", "a.nii.gz"});
  ASSERT_EQ(pairs.size(), 2u);
  for (const Json& pair : pairs)
  {
    EXPECT_EQ(pair.at("first").at("label"), pair.at("reference").at("label"));
    EXPECT_EQ(pair.at("overlap").at("dice"), 1.0);
    EXPECT_EQ(pair.at("overlap").at("cells"), "voxels");
    EXPECT_NEAR(pair.at("distance").at("both").at("max_mm").get<double>(), 0.0, 1e-9);
    EXPECT_EQ(pair.at("distance").at("least_mm"), 0.0);
  }
}

// A folder's structures are numbered in the order of their names, a file's as it likes.
TEST(CliCompare, FolderOfStructuresIsPairedWithAFileByName)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteTwoSpheres(folder / "both.nii.gz");
  for (const auto& [name, label] : {std::pair("zone", "1"), std::pair("apex", "2")})
  {
    ASSERT_EQ(RunPalpate({"convert", "both.nii.gz", std::string("masks/") + name + ".nii.gz",
                          "--label", label},
                         folder.Path())
                  .Code,
              0);
  }
  WriteAll(folder / "both.nii.txt", "1 zone 1\n2 apex 2\n");
  const auto pairs = Compare(folder, {"masks", "both.nii.gz"});
  ASSERT_EQ(pairs.size(), 2U);
  for (const Json& pair : pairs)
  {
    EXPECT_EQ(pair.at("first").at("name"), pair.at("reference").at("name"));
    EXPECT_NE(pair.at("first").at("label"), pair.at("reference").at("label"));
    EXPECT_EQ(pair.at("overlap").at("dice"), 1.0);
  }
}

TEST(CliCompare, OtherLabelIsChosenForTheReference)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const Json pair =
      Compare(folder, {"a.nii.gz", "a.nii.gz", "--label", "1", "--reference-label", "2"}).at(0);
  EXPECT_EQ(pair.at("overlap").at("dice"), 0.0);
  EXPECT_NE(pair.at("notes").at(0).get<std::string>().find("share no volume"), std::string::npos);
}

TEST(CliCompare, TwoOrgansHaveALeastDistanceAndNoHintOfAFrame)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "liver.json", 20.0, {0.0, 0.0, 0.0});
  WriteSphere(folder / "spleen.json", 10.0, {0.0, 40.0, 0.0});
  const Json pair = Compare(folder, {"liver.json", "spleen.json"}).at(0);
  EXPECT_NEAR(pair.at("distance").at("least_mm").get<double>(), 10.0, 0.01);
  ASSERT_EQ(pair.at("notes").size(), 1U);
  const std::string note = pair.at("notes").at(0);
  EXPECT_NE(note.find("least distance between them is 10.0"), std::string::npos) << note;
  EXPECT_EQ(note.find("frame"), std::string::npos) << note;
}

TEST(CliCompare, OneStructureFarFromItselfHasAHintOfAFrame)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "flipped");
  WriteSphere(folder / "liver.json", 20.0, {50.0, 50.0, 0.0});
  WriteSphere(folder / "flipped" / "liver.json", 20.0, {-50.0, -50.0, 0.0});
  const Json pair = Compare(folder, {"liver.json", "flipped/liver.json"}).at(0);
  const std::string note = pair.at("notes").at(0);
  EXPECT_NE(note.find("one frame"), std::string::npos) << note;
}

TEST(CliCompare, MaskAndModelAgreeWithTheFitsOwnNumbers)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun fit =
      RunPalpate({"fit", "a.nii.gz", "--label", "1", "--degree", "6", "--output", "out", "--json"},
                 folder.Path());
  ASSERT_EQ(fit.Code, 0) << fit.Errors;
  const Json quality = Json::parse(fit.Output).at("quality").at("mask");
  const Json pair = Compare(folder, {"out/model.json", "a.nii.gz", "--label", "1"}).at(0);
  EXPECT_EQ(pair.at("overlap").at("cells"), "mask-voxels");
  EXPECT_NEAR(pair.at("overlap").at("dice").get<double>(), quality.at("dice").get<double>(), 1e-3);
  // The fit measures from its drawing, and marches the mask's boundary in another way.
  EXPECT_NEAR(pair.at("distance").at("both").at("mean_mm").get<double>(),
              quality.at("mean_mm").get<double>(), 0.03);
}

TEST(CliCompare, OpenSurfaceHasNoVolumeAndANote)
{
  const TemporaryFolder folder;
  IndexedMesh open = Sphere(10, 20.0);
  open.Triangles.resize(open.Triangles.size() / 2);
  WriteMesh(folder / "open.stl", open);
  WriteMesh(folder / "closed.ply", Sphere(20, 20.0));
  const Json pair = Compare(folder, {"open.stl", "closed.ply"}).at(0);
  EXPECT_TRUE(pair.at("overlap").is_null());
  EXPECT_TRUE(pair.at("first").at("volume_ml").is_null());
  EXPECT_TRUE(pair.at("distance").at("reference_to_first").at("signed_mean_mm").is_null());
  EXPECT_NE(pair.at("notes").at(0).get<std::string>().find("is open"), std::string::npos);
}

TEST(CliCompare, SurfaceThatEnclosesPlacesTwiceHasANote)
{
  const TemporaryFolder folder;
  WriteMesh(folder / "nested.stl", Join(Sphere(20, 20.0), Sphere(20, 10.0)));
  WriteMesh(folder / "hollow.stl", Join(Sphere(20, 20.0), Reversed(Sphere(20, 10.0))));
  const Json pair = Compare(folder, {"hollow.stl", "nested.stl"}).at(0);
  ASSERT_EQ(pair.at("notes").size(), 1U);
  const auto note = pair.at("notes").at(0).get<std::string>();
  EXPECT_EQ(note.find("nested.stl encloses 12.5 % of its inside not just once"), 0U) << note;
}

TEST(CliCompare, WritesMapPictureAndPageWithoutPaths)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "secret");
  WriteSphere(folder / "secret/a.json", 22.0, Vector3::Zero());
  WriteTwoSpheres(folder / "secret/b.nii.gz");
  Compare(folder, {"secret/a.json", "secret/b.nii.gz", "--label", "1", "--output", "out"});
  const vtkSmartPointer<vtkPolyData> first = ReadSurface(folder / "out/first.vtp");
  const TriangleMesh mesh = TrianglesOf(first, "first.vtp");
  ASSERT_EQ(mesh.Values.size(), 1u);
  EXPECT_EQ(mesh.Values.front().Name, "SignedDistance");
  EXPECT_GT(mesh.Values.front().Numbers.front(), 10.0);
  EXPECT_EQ(ReadAll(folder / "out/map.png").substr(1, 3), "PNG");
  const std::string page = ReadAll(folder / "out/report.html");
  EXPECT_NE(page.find("Nikolov"), std::string::npos);
  EXPECT_EQ(page.find("secret"), std::string::npos);
  EXPECT_EQ(page.find(folder.Path().string()), std::string::npos);
}

TEST(CliCompare, FoldersGiveATableAndNameWhatIsAlone)
{
  const TemporaryFolder folder;
  for (const char* reader : {"one", "two"})
  {
    std::filesystem::create_directory(folder / reader);
    WriteSphere(folder / reader / "p1.json", 20.0, Vector3::Zero());
  }
  WriteSphere(folder / "one" / "p2.json", 21.0, Vector3::Zero());
  WriteSphere(folder / "two" / "p2.json", 20.0, Vector3::Zero());
  WriteSphere(folder / "two" / "p3.json", 20.0, Vector3::Zero());
  const CommandRun run = RunPalpate({"compare", "one", "two", "--output", "out"}, folder.Path());
  EXPECT_EQ(run.Code, 0);
  EXPECT_NE(run.Output.find("2 pairs"), std::string::npos) << run.Output;
  EXPECT_NE(run.Errors.find("p3.json has no partner"), std::string::npos) << run.Errors;
  const std::string table = ReadAll(folder / "out/comparison.csv");
  EXPECT_NE(table.find("\np1,"), std::string::npos) << table;
  EXPECT_NE(table.find("\np2,"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/p2/report.html"));
  EXPECT_NE(ReadAll(folder / "out/report.html").find("href=\"p2/report.html\""), std::string::npos);
}

TEST(CliCompare, CohortsModelsArePairedWithTheirMasks)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteTwoSpheres(folder / "masks/a.nii.gz");
  WriteTwoSpheres(folder / "masks/b.nii.gz");
  ASSERT_EQ(RunPalpate({"fit", "masks", "--degree", "4", "--output", "fitted"}, folder.Path()).Code,
            0);
  const std::vector<Json> pairs = Compare(folder, {"masks", "fitted"});
  ASSERT_EQ(pairs.size(), 4u); // two structures each
  for (const Json& pair : pairs)
  {
    EXPECT_EQ(pair.at("status"), "compared");
    EXPECT_GT(pair.at("overlap").at("dice").get<double>(), 0.9);
  }
  const std::vector<Json> chosen = Compare(folder, {"masks", "fitted", "--label", "2"});
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen.front().at("first").at("label"), 2);
}

TEST(CliCompare, CaseThatCannotBeReadDoesNotStopTheOthers)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "a.json", 20.0, Vector3::Zero());
  WriteAll(folder / "broken.stl", "solid nothing");
  WriteAll(folder / "pairs.csv", "case,first,reference\nx,broken.stl,a.json\ny,a.json,a.json\n");
  const std::vector<Json> pairs = Compare(folder, {"--pairs", "pairs.csv", "--output", "out"}, 1);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].at("status"), "bad-input");
  EXPECT_EQ(pairs[1].at("status"), "compared");
  EXPECT_NE(ReadAll(folder / "out/comparison.csv").find("bad-input"), std::string::npos);
}

/// Three pairs of models in two folders, the second of which cannot be read.
class CliCompareFolders : public testing::Test
{
protected:
  CliCompareFolders()
  {
    for (const char* reader : {"one", "two"})
    {
      std::filesystem::create_directory(this->Folder / reader);
      WriteSphere(this->Folder / reader / "a.json", reader[0] == 'o' ? 21.0 : 20.0,
                  Vector3::Zero());
      WriteAll(this->Folder / reader / "b.json", "no model");
      WriteSphere(this->Folder / reader / "c.json", 20.0, Vector3::Zero());
    }
  }
  std::vector<std::string> Words(const std::string& output, const std::string& jobs) const
  {
    return {"compare", "one", "two", "--output", output, "--jobs", jobs};
  }
  CommandRun Run(const std::string& output = "out", const std::string& jobs = "1") const
  {
    return RunPalpate(this->Words(output, jobs), this->Folder.Path());
  }
  std::string Table(const std::string& output = "out") const
  {
    return ReadAll(this->Folder / output / "comparison.csv");
  }
  /// Sends the signal as soon as a table exists.
  int CodeOfRunUntilFirstRow(int signal, const std::string& jobs) const
  {
    StartedCommand command(PALPATE_PROGRAM, this->Words("out", jobs), this->Folder.Path());
    EXPECT_TRUE(
        IsSoon([&] { return std::filesystem::exists(this->Folder / "out/comparison.csv"); }));
    command.Send(signal);
    return command.Finish().Code;
  }

  TemporaryFolder Folder;
};

TEST_F(CliCompareFolders, SecondRunComparesOnlyChanges)
{
  EXPECT_EQ(this->Run().Code, 1);
  const std::string table = this->Table();
  const CommandRun again = this->Run();
  EXPECT_EQ(again.Code, 1);
  EXPECT_NE(again.Errors.find("3 of 3 cases were done before"), std::string::npos) << again.Errors;
  EXPECT_NE(again.Output.find("2 pairs"), std::string::npos) << again.Output;
  EXPECT_EQ(this->Table(), table);
  // The invalid files become valid; a report is lost; a model changes.
  WriteSphere(this->Folder / "one/b.json", 20.0, Vector3::Zero());
  WriteSphere(this->Folder / "two/b.json", 20.0, Vector3::Zero());
  std::filesystem::remove(this->Folder / "out/a/report.html");
  const CommandRun third = this->Run();
  EXPECT_EQ(third.Code, 0) << third.Errors;
  EXPECT_NE(third.Errors.find("1 of 3 cases were done before"), std::string::npos) << third.Errors;
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/a/report.html"));
}

TEST_F(CliCompareFolders, OtherTolerancesCompareEveryPairAgain)
{
  this->Run();
  std::vector<std::string> words = this->Words("out", "1");
  words.insert(words.end(), {"--tolerance", "0.5"});
  const CommandRun run = RunPalpate(words, this->Folder.Path());
  EXPECT_EQ(run.Errors.find("done before"), std::string::npos) << run.Errors;
  EXPECT_NE(this->Table().find("surface_dice_0.5mm"), std::string::npos);
}

TEST_F(CliCompareFolders, SecondRunAtATimeIntoTheFolderIsRefused)
{
  WriteSphere(this->Folder / "one/d.json", 20.0, Vector3::Zero()); // so that it does not end before
  WriteSphere(this->Folder / "two/d.json", 20.0, Vector3::Zero());
  StartedCommand first(PALPATE_PROGRAM, this->Words("out", "1"), this->Folder.Path());
  ASSERT_TRUE(IsSoon([&] { return std::filesystem::exists(this->Folder / "out/comparison.csv"); }));
  first.Send(SIGSTOP);
  const CommandRun second = this->Run();
  first.Send(SIGCONT);
  EXPECT_EQ(second.Code, 2);
  EXPECT_NE(second.Errors.find("another run"), std::string::npos) << second.Errors;
  EXPECT_EQ(first.Finish().Code, 1); // one pair is invalid
  EXPECT_EQ(this->Run().Errors.find("another run"), std::string::npos);
}

TEST_F(CliCompareFolders, NumberOfJobsDoesNotChangeResults)
{
  const CommandRun one = this->Run("out1", "1");
  const CommandRun three = this->Run("out3", "3");
  EXPECT_EQ(three.Code, one.Code);
  EXPECT_EQ(three.Output, one.Output);
  EXPECT_EQ(this->Table("out3"), this->Table("out1"));
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out3/c/report.html"));
}

TEST_F(CliCompareFolders, InterruptedRunLeavesOnlyCompleteResultsAndIsResumed)
{
  for (const char* jobs : {"1", "2"})
  {
    std::filesystem::remove_all(this->Folder / "out");
    for (int i = 0; i < 6; ++i) // enough to be interrupted
    {
      for (const char* reader : {"one", "two"})
      {
        WriteSphere(this->Folder / reader / ("d" + std::to_string(i) + ".json"), 20.0,
                    Vector3::Zero());
      }
    }
    EXPECT_EQ(this->CodeOfRunUntilFirstRow(SIGINT, jobs), 130);
    EXPECT_FALSE(std::filesystem::exists(this->Folder / "out/report.html"));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(this->Folder / "out"))
    {
      // AtomicFile's temporary names begin with a dot; a pair's files are written together.
      EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
      EXPECT_TRUE(!entry.is_directory() || std::filesystem::exists(entry.path() / "report.html"))
          << entry.path();
    }
    const CommandRun run = this->Run();
    EXPECT_NE(run.Errors.find("cases were done before"), std::string::npos) << run.Errors;
    EXPECT_NE(run.Output.find("8 pairs"), std::string::npos) << run.Output;
  }
}

TEST(CliCompare, RefusesWithTheWayOut)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteSphere(folder / "b.json", 20.0, Vector3::Zero());
  std::filesystem::create_directory(folder / "folder");
  const auto refusal = [&](const std::vector<std::string>& words)
  {
    std::vector<std::string> all{"compare"};
    all.insert(all.end(), words.begin(), words.end());
    const CommandRun run = RunPalpate(all, folder.Path());
    EXPECT_EQ(run.Code, 2);
    return run.Errors;
  };
  EXPECT_NE(refusal({"a.nii.gz", "b.json"}).find("choose one with --label"), std::string::npos);
  EXPECT_NE(refusal({"b.json", "b.json", "--label", "1"}).find("leave out --label"),
            std::string::npos);
  WriteSphere(folder / "flat.json", 0.0, Vector3::Zero());
  EXPECT_NE(refusal({"b.json", "flat.json"}).find("flat.json encloses no volume; "),
            std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz", "folder"}).find("two files or two folders"), std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz"}).find("REFERENCE"), std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz", "b.json", "--label", "7"}).find("7"), std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz", "b.json", "--tolerance", "nan"}).find("--tolerance"),
            std::string::npos);
}
} // namespace
} // namespace palpate::cli_compare_test
