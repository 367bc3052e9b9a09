#include "SceneBuilder.h"

#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Refusal.h"
#include "StructureFollower.h"
#include "SurfaceFile.h"
#include "SurfacePhantoms.h"
#include "SurfaceTexture.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "TouchRun.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palpate::scene_builder_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// Eight small spheres in a row as labels 1 to 8, and one as a model.
class SceneBuilderTest : public testing::Test
{
protected:
  static constexpr int Spheres = 8;

  void SetUp() override
  {
    test::LabelGrid grid;
    grid.Size = {{80, 12, 12}};
    const auto image = test::MakeLabelImage(
        grid, [](double x, double y, double z)
        { return std::hypot(std::fmod(x, 10.0) - 5.0, y - 5.5, z - 5.5) < 4.0; });
    auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      voxel[i] = static_cast<unsigned char>(voxel[i] * (1 + i % grid.Size[0] / 10));
    }
    WriteImage(this->MaskPath, image);
    WriteModel(this->ModelPath,
               {RadialModel(0, {5.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
  }

  SceneStructure Entry(const std::filesystem::path& file, bool isTouched) const
  {
    SceneStructure entry;
    entry.File = file;
    entry.IsTouchable = isTouched;
    return entry;
  }
  // One entry per sphere, of which `touched` is touched.
  SceneSettings RowOf(const std::filesystem::path& file, int count, int touched) const
  {
    SceneSettings settings;
    for (int label = 1; label <= count; ++label)
    {
      settings.Structures.push_back(this->Entry(file, label == touched));
      settings.Structures.back().Labels = {std::to_string(label)};
    }
    return settings;
  }
  BuiltScene Make(const std::vector<SceneStructure>& entries) const
  {
    SceneSettings settings;
    settings.Structures = entries;
    return BuildScene(settings, GoOn);
  }

  test::TemporaryFolder Folder;
  std::filesystem::path MaskPath = Folder / "balls.nii.gz";
  std::filesystem::path ModelPath = Folder / "ball.json";
  std::filesystem::path Missing = Folder / "missing.nii.gz";
};

TEST_F(SceneBuilderTest, RefusesALabelWithoutAnyShape)
{
  test::LabelGrid grid;
  grid.Size = {{20, 12, 12}};
  const auto oneVoxel = test::MakeLabelImage(grid, [](double x, double y, double z)
                                             { return x == 5.0 && y == 5.0 && z == 5.0; });
  WriteImage(this->Folder / "voxel.nii.gz", oneVoxel);
  SceneStructure entry = this->Entry(this->Folder / "voxel.nii.gz", true);
  entry.Representation = TouchRepresentation::ModelOrField;
  // The field is tried after the surface was refused.
  EXPECT_THROW(this->Make({entry}), InputError);
}

// A ball that the border of its image cuts at x = -3.5 mm.
std::shared_ptr<test::TemporaryFolder> FolderWithACutBall(std::filesystem::path& file)
{
  auto folder = std::make_shared<test::TemporaryFolder>();
  test::LabelGrid grid;
  grid.Size = {{20, 20, 20}};
  grid.Origin = {-3.0, -9.5, -9.5};
  file = *folder / "ended.nii.gz";
  WriteImage(file, test::MakeLabelImage(grid, [](double x, double y, double z)
                                        { return std::hypot(x, y, z) < 7.0; }));
  return folder;
}

// N, of a point that is pushed from a place into the only structure by 3 mm.
double ForceOfAPush(const BuiltScene& made, const Vector3& from, const Vector3& along)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(0.0);
  scene.Structures = {made.Touched.front().Touch};
  std::vector<StructureFollower> followers;
  RequireInput(StructureFollower::Make(scene.Structures[0], scene, 0.003, followers));
  FollowStep step;
  step.Passed = 0.001;
  step.Now.PositionWorld = from;
  double most = 0.0;
  for (int tick = 0; tick < 100; ++tick)
  {
    step.Last = step.Now;
    step.Now.PositionWorld += 0.1 * along;
    most = std::max(most, followers[0].Follow(step).norm());
  }
  return most;
}

TEST_F(SceneBuilderTest, CutsByTheBorderAreFeltOnlyIfAsked)
{
  std::filesystem::path file;
  const auto folder = FolderWithACutBall(file);
  for (const char* representation :
       {TouchRepresentation::Harmonics, TouchRepresentation::Facets, TouchRepresentation::SubVoxel,
        TouchRepresentation::ModelOrField})
  {
    SceneStructure entry = this->Entry(file, true);
    entry.Representation = representation;
    const BuiltScene passed = this->Make({entry});
    entry.KeepsCuts = true;
    const BuiltScene kept = this->Make({entry});
    const Vector3 outside = -9.0 * Vector3::UnitX();
    EXPECT_EQ(ForceOfAPush(passed, outside, Vector3::UnitX()), 0.0) << representation;
    EXPECT_GT(ForceOfAPush(kept, outside, Vector3::UnitX()), 0.5) << representation;
    // Its own surface is felt, opposite of the cut and beside it.
    const Vector3 opposite = 12.0 * Vector3::UnitX();
    EXPECT_GT(ForceOfAPush(passed, opposite, -Vector3::UnitX()), 0.5) << representation;
    const Vector3 beside = 12.0 * Vector3::UnitY();
    EXPECT_EQ(ForceOfAPush(passed, beside, -Vector3::UnitY()),
              ForceOfAPush(kept, beside, -Vector3::UnitY()))
        << representation;
  }
}

TEST_F(SceneBuilderTest, DrilledStructuresKeepTheirCuts)
{
  std::filesystem::path file;
  const auto folder = FolderWithACutBall(file);
  SceneStructure entry = this->Entry(file, true);
  EXPECT_EQ(this->Make({entry}).Touched.front().Touch.Cuts.size(), 1U);
  entry.Drill.Wear = 0.1;
  EXPECT_TRUE(this->Make({entry}).Touched.front().Touch.Cuts.empty());
}

TEST_F(SceneBuilderTest, NamesStructuresThatTheBorderCuts)
{
  test::LabelGrid grid;
  grid.Size = {{20, 20, 20}};
  std::vector<SceneStructure> entries;
  for (const auto& [name, middle] : {std::pair("whole", 9.5), std::pair("ended", 2.0)})
  {
    const auto file = this->Folder / (std::string(name) + ".nii.gz");
    WriteImage(file,
               test::MakeLabelImage(grid, [middle = middle](double x, double y, double z)
                                    { return std::hypot(x - middle, y - 9.5, z - 9.5) < 6.0; }));
    entries.push_back(this->Entry(file, true));
  }
  const std::vector<std::string> warnings = this->Make(entries).Warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().find("ended is cut by the border"), std::string::npos) << warnings[0];
  entries.back().IsTouchable = false;
  EXPECT_TRUE(this->Make(entries).Warnings.empty());
}

TEST_F(SceneBuilderTest, TouchesAModelOfThreeCoordinates)
{
  WriteModel(this->Folder / "ring.json", {test::OpenRing(8), {}});
  const BuiltScene made = this->Make({this->Entry(this->Folder / "ring.json", true)});
  ASSERT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.Touched[0].Represented, "surface harmonics of degree 8, nearest point");
  const Eigen::AlignedBox3d bounds = made.Touched[0].Touch.Model->BoundsWorld();
  EXPECT_TRUE(bounds.contains(test::OpenRing(8).Point(Vector3::UnitX())));
  SceneStructure radial = this->Entry(this->Folder / "ring.json", true);
  radial.Mode = RadialContactMode::Radial;
  EXPECT_THROW(this->Make({radial}), InputError);
}

TEST_F(SceneBuilderTest, FitsHarmonicsToASurfaceFile)
{
  const auto ring = DrawModel(test::OpenRing(8), 20);
  WriteSurface(this->Folder / "ring.stl", ring);
  SceneStructure entry = this->Entry(this->Folder / "ring.stl", true);
  EXPECT_EQ(this->Make({entry}).Touched.at(0).Represented.find("harmonics"), std::string::npos);
  entry.Representation = TouchRepresentation::Harmonics;
  entry.Degree = 8;
  const BuiltScene made = this->Make({entry});
  ASSERT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.Touched[0].Represented, "surface harmonics of degree 8, nearest point");
  const Eigen::AlignedBox3d bounds = made.Touched[0].Touch.Model->BoundsWorld();
  EXPECT_TRUE(bounds.contains(test::OpenRing(8).Point(Vector3::UnitX())));
  // One triangle less: it is open.
  ring->BuildCells();
  ring->DeleteCell(0);
  ring->RemoveDeletedCells();
  WriteSurface(this->Folder / "open.stl", ring);
  entry.File = this->Folder / "open.stl";
  EXPECT_THROW(this->Make({entry}), InputError);
}

TEST_F(SceneBuilderTest, DoesNotOpenFilesOfUntouchedStructures)
{
  SceneStructure smooth = this->Entry(this->ModelPath, false);
  smooth.SetNumber("texture_n", 0.2);
  smooth.SetImage("texture_image", this->Folder / "missing.nrrd");
  const BuiltScene made =
      this->Make({this->Entry(this->Missing, false), smooth, this->Entry(this->ModelPath, true)});
  EXPECT_EQ(made.Touched.size(), 1u);
  ASSERT_EQ(made.Account.Structures.size(), 3u);
  const SceneStructureAccount& untouched = made.Account.Structures[0];
  EXPECT_EQ(untouched.Name, "missing");
  EXPECT_EQ(untouched.Contact.WhyNot, "not touched in the scene");
  EXPECT_TRUE(untouched.Contact.Is.empty());
  int unread = 0;
  for (const SceneFileAccount& file : made.Account.Files)
  {
    unread += file.Reading.Is.empty() ? 1 : 0;
    EXPECT_NE(file.Reading.Is.empty(), file.Reading.WhyNot.empty());
  }
  EXPECT_EQ(unread, 2);
  EXPECT_THROW(this->Make({this->Entry(this->Missing, true)}), InputError);
}

TEST_F(SceneBuilderTest, AccountHasTheBytesOfContactModels)
{
  SceneStructure sphere = this->Entry(this->MaskPath, true);
  sphere.Labels = {"3"};
  sphere.Degree = 2;
  for (const char* const representation :
       {TouchRepresentation::SubVoxel, TouchRepresentation::Facets, TouchRepresentation::Harmonics})
  {
    sphere.Representation = representation;
    const BuiltScene made = this->Make({sphere});
    ASSERT_EQ(made.Touched.size(), 1u);
    EXPECT_EQ(made.Account.Structures[0].Contact.Bytes, made.Touched[0].Touch.Model->Bytes());
    EXPECT_GT(made.Account.Structures[0].Contact.Bytes, 0u);
  }
}

// A sphere of 5 mm and a tool of 2 mm in an image of 100 mm: 14³ of 100³ voxels, plus a margin.
TEST_F(SceneBuilderTest, TextureKeepsTheImageWithinReachOfTheTool)
{
  test::LabelGrid grid;
  grid.Size = {{100, 100, 100}};
  grid.CenterOnOrigin();
  SceneStructure sphere = this->Entry(this->ModelPath, true);
  const std::uintmax_t smooth = this->Make({sphere}).Account.Structures[0].Contact.Bytes;
  sphere.SetNumber("texture_n", 0.2);
  sphere.SetImage("texture_image", this->Folder / "image.nrrd");
  WriteImage(this->Folder / "image.nrrd",
             test::MakeLabelImage(grid, [](double x, double y, double z)
                                  { return x > 0.0 && y > 0.0 && z > 0.0; }));
  const BuiltScene made = this->Make({sphere});
  ASSERT_EQ(made.Touched.at(0).Touch.Effects.size(), 1U);
  const auto texture =
      std::dynamic_pointer_cast<const SurfaceTexture>(made.Touched[0].Touch.Effects[0]);
  ASSERT_NE(texture, nullptr);
  const Vector3 bright = Vector3::Constant(0.5); // a node next to the centre
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GT(texture->BrightnessAt(bright), texture->BrightnessAt(bright - Vector3::Unit(axis)));
  }
  const std::uintmax_t textured = made.Account.Structures[0].Contact.Bytes;
  EXPECT_GT(textured, smooth + 4 * 14 * 14 * 14);
  EXPECT_LT(textured, smooth + 4 * 100 * 100 * 100 / 10);
}

TEST_F(SceneBuilderTest, ReadsASharedFileOnce)
{
  SceneSettings settings = this->RowOf(this->MaskPath, Spheres, 3);
  for (SceneStructure& structure : settings.Structures)
  {
    structure.IsTouchable = true;
  }
  const BuiltScene made = BuildScene(settings, GoOn);
  EXPECT_EQ(made.Touched.size(), 1u * Spheres);
  EXPECT_EQ(made.Account.Files.size(), 1u);
}

TEST_F(SceneBuilderTest, MakesOnlyTheTouchedStructureWithEqualForces)
{
  const SceneSettings all = this->RowOf(this->MaskPath, Spheres, 3);
  SceneSettings alone = all;
  alone.Structures = {all.Structures[2]};
  const BuiltScene made = BuildScene(all, GoOn);
  EXPECT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.Account.Structures.size(), 1u * Spheres);
  TouchScript script;
  script.Duration = 0.5;
  const auto file = this->Folder / "session.touch";
  RunTouch(PrepareTouch(all, script, GoOn), {true, file, {}, {}}, GoOn);
  EXPECT_EQ(CompareTouch(PrepareTouch(alone, script, GoOn), file).DifferentTicks, 0u);
}

TEST_F(SceneBuilderTest, ProgressNamesTheStructureAndTheCount)
{
  SceneSettings settings = this->RowOf(this->MaskPath, 2, 2);
  settings.Structures[1].Representation = TouchRepresentation::Facets;
  std::set<std::string> stages;
  BuildScene(settings,
             [&stages](double fraction, const std::string& stage)
             {
               EXPECT_TRUE(fraction >= 0.0 && fraction <= 1.0) << fraction;
               stages.insert(stage);
               return true;
             });
  EXPECT_EQ(stages.count("balls.nii.gz: read"), 1U);
  EXPECT_EQ(stages.count("balls.nii.gz, structure 2 of 2: label 2: surface"), 1U);
}

TEST_F(SceneBuilderTest, RejectsSceneWithoutTouchableStructures)
{
  SceneSettings settings;
  settings.Structures = {this->Entry(this->ModelPath, false)};
  EXPECT_THROW(PrepareTouch(settings, {}, GoOn), InputError);
}

TEST_F(SceneBuilderTest, MakesOnlyTheTouchedStructureOfAnAtlas)
{
  const std::filesystem::path atlas = "/usr/share/mricron/templates/aal.nii.gz";
  PALPATE_REQUIRE_FILE(atlas);
  constexpr int Structures = 116;
  const BuiltScene made = BuildScene(this->RowOf(atlas, Structures, 37), GoOn);
  ASSERT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.Account.Structures.size(), 1u * Structures);
  EXPECT_EQ(made.Account.Files.size(), 1u);
  std::uintmax_t bytes = 0;
  for (const SceneStructureAccount& structure : made.Account.Structures)
  {
    bytes += structure.Contact.Bytes;
  }
  EXPECT_EQ(bytes, made.Touched[0].Touch.Model->Bytes());
}
} // namespace
} // namespace palpate::scene_builder_test
