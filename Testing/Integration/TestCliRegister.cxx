#include "CommandRun.h"
#include "ModelFile.h"
#include "StudyMarkups.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TransformFile.h"
#include "VolumeFile.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_register_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

// A lump without symmetry, and where it is.
RadialModel LumpAt(const Vector3& center, double size = 1.0)
{
  std::vector<double> coefficients{70.0, 3.0, -2.0, 4.0,  5.0, -3.0, 6.0,  2.0,
                                   -4.0, 1.0, 3.0,  -2.0, 2.0, 1.0,  -3.0, 2.0};
  for (double& one : coefficients)
  {
    one *= size;
  }
  return {3, coefficients, center};
}

class CliRegister : public testing::Test
{
protected:
  void Write(const std::string& name, const RadialModel& model) const
  {
    ModelDocument document;
    document.Surface = model;
    WriteModel(this->Folder / name, document);
  }
  void WritePoints(const std::string& name, const std::vector<Vector3>& points) const
  {
    StudyMarkups markups;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      markups.Landmarks.push_back({std::string(1, static_cast<char>('a' + i)), points[i]});
    }
    WriteMarkups(this->Folder / name, markups);
  }
  Json Register(std::vector<std::string> words) const
  {
    words.insert(words.begin(), "register");
    words.emplace_back("--json");
    const CommandRun run = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(run.Code, 0) << run.Errors;
    return run.Output.empty() ? Json() : Json::parse(run.Output);
  }
  std::string RefusalOf(std::vector<std::string> words) const
  {
    words.insert(words.begin(), "register");
    const CommandRun run = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(run.Code, 2);
    return run.Errors;
  }
  static Vector3 Mapped(const Json& found, const Vector3& point)
  {
    Vector3 mapped;
    for (int row = 0; row < 3; ++row)
    {
      const std::vector<double> line = found.at("map").at(row);
      mapped[row] = line[0] * point[0] + line[1] * point[1] + line[2] * point[2] + line[3];
    }
    return mapped;
  }
  // Directions of an octahedron's corners and faces.
  static std::vector<Vector3> SurfacePoints(const RadialModel& model)
  {
    std::vector<Vector3> points;
    for (const double x : {-1.0, 0.0, 1.0})
    {
      for (const double y : {-1.0, 0.0, 1.0})
      {
        for (const double z : {-1.0, 0.0, 1.0})
        {
          if (const Vector3 direction(x, y, z); direction.norm() > 0.0)
          {
            const Vector3 unit = direction.normalized();
            points.emplace_back(model.CenterWorld() + model.Radius(unit) * unit);
          }
        }
      }
    }
    return points;
  }

  TemporaryFolder Folder;
  Vector3 Before{30.0, -10.0, 5.0};
  Vector3 After{-20.0, 15.0, 40.0};
};

TEST_F(CliRegister, ModelReturnsOntoItselfAndTheTransformSaysSo)
{
  this->Write("before.json", LumpAt(this->Before));
  this->Write("after.json", LumpAt(this->After));
  const Json found = this->Register({"before.json", "after.json", "--output", "moved.tfm"});
  EXPECT_LT((Mapped(found, this->Before) - this->After).norm(), 0.01); // of triangles
  EXPECT_NEAR(found.at("turn_deg").get<double>(), 0.0, 0.02);
  EXPECT_LT(found.at("surface").at("rms_mm").get<double>(), 0.01);
  const Eigen::Affine3d written = ReadTransform(this->Folder / "moved.tfm");
  EXPECT_LT((written * this->Before - Mapped(found, this->Before)).norm(), 1e-9);
}

TEST_F(CliRegister, SizeIsFoundWhereItMayChange)
{
  this->Write("small.json", LumpAt(this->Before));
  this->Write("large.json", LumpAt(this->After, 1.2));
  const Json found = this->Register({"small.json", "large.json", "--kind", "similarity"});
  EXPECT_NEAR(found.at("size").get<double>(), 1.2, 0.001);
}

TEST_F(CliRegister, TouchedPointsFindTheModelEitherWay)
{
  const RadialModel model = LumpAt(this->Before);
  this->Write("model.json", model);
  const Vector3 shift(4.0, -3.0, 2.0);
  std::vector<Vector3> points = SurfacePoints(model);
  for (Vector3& point : points)
  {
    point += shift;
  }
  this->WritePoints("touched.mrk.json", points);
  const Json onto = this->Register({"model.json", "touched.mrk.json"});
  EXPECT_LT((Mapped(onto, this->Before) - this->Before - shift).norm(), 0.05);
  const Json back = this->Register({"touched.mrk.json", "model.json"});
  EXPECT_LT((Mapped(back, this->Before + shift) - this->Before).norm(), 0.05);
  EXPECT_NE(onto.at("notes").dump().find("fewer than 40 points"), std::string::npos);
}

TEST_F(CliRegister, LandmarksArePairedByNameAndStartABody)
{
  const std::vector<Vector3> places = SurfacePoints(LumpAt(this->Before));
  const Matrix3 turn = Eigen::AngleAxisd(2.5, Vector3::UnitZ()).toRotationMatrix();
  StudyMarkups fixed;
  StudyMarkups moving;
  for (std::size_t i = 0; i < 10; ++i)
  {
    moving.Landmarks.push_back({"p" + std::to_string(i), places[i]});
    fixed.Landmarks.insert(fixed.Landmarks.begin(), {"p" + std::to_string(i), turn * places[i]});
  }
  WriteMarkups(this->Folder / "moving.mrk.json", moving);
  WriteMarkups(this->Folder / "fixed.mrk.json", fixed);
  const Json found = this->Register({"moving.mrk.json", "fixed.mrk.json"});
  EXPECT_NEAR(found.at("turn_deg").get<double>(), 2.5 * 180.0 / M_PI, 1e-6);
  EXPECT_TRUE(found.at("surface").is_null());
  // From its own place a body that lies turned is not found, from landmarks it is.
  this->Write("body.json", LumpAt(this->Before));
  const Json started = this->Register({"body.json", "body.json", "--moving-landmarks",
                                       "fixed.mrk.json", "--fixed-landmarks", "fixed.mrk.json"});
  EXPECT_NEAR(started.at("turn_deg").get<double>(), 0.0, 0.02);
}

TEST_F(CliRegister, RefusesWithTheWayOut)
{
  this->Write("a.json", LumpAt(this->Before));
  this->WritePoints("three.mrk.json", {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}});
  this->WritePoints("two.mrk.json", {{0, 0, 0}, {10, 0, 0}});
  WriteTwoSpheres(this->Folder / "two.nii.gz");
  EXPECT_NE(this->RefusalOf({"a.json", "a.json", "--output", "a.mat"}).find(".tfm"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf({"a.json", "a.json", "--moving-landmarks", "three.mrk.json"})
                .find("give both"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf({"two.nii.gz", "a.json"}).find("choose one by --label"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf({"two.mrk.json", "two.mrk.json"}).find("at least three pairs"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf({"three.mrk.json", "a.json"}).find("at least 6 points"),
            std::string::npos);
}

TEST_F(CliRegister, ImagesAndTheirMasksFindTheSameWay)
{
  ASSERT_EQ(
      RunPalpate({"phantom", "--output", "p", "--spacing", "1.5,1.5,2"}, this->Folder.Path()).Code,
      0);
  const Eigen::Affine3d truth =
      Eigen::Translation3d(4.0, -3.0, 5.0) *
      Eigen::Affine3d(Eigen::AngleAxisd(0.1, Vector3(1.0, 2.0, 2.0) / 3.0));
  const std::filesystem::path volume = this->Folder / "p/volume.nii.gz";
  WriteTransform(this->Folder / "truth.mat", truth.inverse(), {volume, volume});
  ASSERT_EQ(RunPalpate({"convert", "p/volume.nii.gz", "moved.nii.gz", "--transform", "truth.mat",
                        "--reference", "p/volume.nii.gz"},
                       this->Folder.Path())
                .Code,
            0);
  const Json found =
      this->Register({"moved.nii.gz", "p/volume.nii.gz", "--images", "--output", "found.mat"});
  const Eigen::Affine3d map = ReadTransform(this->Folder / "found.mat", {volume, volume});
  const Volume read = ReadVolume(volume);
  Vector3 center;
  read.Image->GetCenter(center.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 point = center + 25.0 * Vector3::Unit(axis);
    EXPECT_LT((map * point - truth * point).norm(), 1.0); // half a slice; the gland is nearly round
    EXPECT_LT((Mapped(found, point) - map * point).norm(), 1e-6);
  }
  EXPECT_GT(found.at("images").at("steps").get<int>(), 0);
  // From the truth on, it stays there.
  const Json again =
      this->Register({"moved.nii.gz", "p/volume.nii.gz", "--images", "--initial", "found.mat"});
  EXPECT_LT((Mapped(again, center) - map * center).norm(), 0.3);
}

TEST_F(CliRegister, InitialTransformReplacesTheStart)
{
  this->Write("before.json", LumpAt(this->Before));
  this->Write("after.json", LumpAt(this->After));
  WriteTransform(this->Folder / "start.tfm",
                 Eigen::Affine3d(Eigen::Translation3d(this->After - this->Before)));
  const Json found = this->Register({"before.json", "after.json", "--initial", "start.tfm"});
  EXPECT_LT((Mapped(found, this->Before) - this->After).norm(), 0.01);
  this->WritePoints("a.mrk.json", SurfacePoints(LumpAt(this->Before)));
  EXPECT_NE(
      this->RefusalOf({"a.mrk.json", "a.mrk.json", "--initial", "start.tfm"}).find("--initial"),
      std::string::npos);
  EXPECT_NE(this->RefusalOf({"before.json", "after.json", "--output", "a.mat"}).find("two images"),
            std::string::npos);
}
} // namespace
} // namespace palpate::cli_register_test
