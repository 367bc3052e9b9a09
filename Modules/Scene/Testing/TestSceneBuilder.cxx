#include "SceneBuilder.h"

#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "TouchRun.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palpate
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
               {SphericalHarmonicModel(0, {5.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
  }

  SceneStructure Entry(const std::filesystem::path& file, bool isSeen, bool isTouched) const
  {
    SceneStructure entry;
    entry.File = file;
    entry.IsVisible = isSeen;
    entry.IsTouchable = isTouched;
    return entry;
  }
  // One entry per sphere, of which `touched` is touched.
  SceneSettings RowOf(const std::filesystem::path& file, int count, int touched) const
  {
    SceneSettings settings;
    for (int label = 1; label <= count; ++label)
    {
      settings.Structures.push_back(this->Entry(file, false, label == touched));
      settings.Structures.back().Labels = {std::to_string(label)};
    }
    return settings;
  }
  BuiltScene Make(const std::vector<SceneStructure>& entries, bool isSeen = true) const
  {
    SceneSettings settings;
    settings.Structures = entries;
    return BuildScene(settings, isSeen, GoOn);
  }

  test::TemporaryFolder Folder;
  std::filesystem::path MaskPath = Folder / "balls.nii.gz";
  std::filesystem::path ModelPath = Folder / "ball.json";
  std::filesystem::path Missing = Folder / "missing.nii.gz";
};

TEST_F(SceneBuilderTest, RefusesToDisplayALabelWithoutAnyShape)
{
  test::LabelGrid grid;
  grid.Size = {{20, 12, 12}};
  const auto oneVoxel = test::MakeLabelImage(grid, [](double x, double y, double z)
                                             { return x == 5.0 && y == 5.0 && z == 5.0; });
  WriteImage(this->Folder / "voxel.nii.gz", oneVoxel);
  SceneStructure entry = this->Entry(this->Folder / "voxel.nii.gz", true, false);
  entry.Representation = TouchRepresentation::ModelOrField;
  // The field is tried after the surface was refused, and the segmentation released.
  EXPECT_THROW(this->Make({entry}), InputError);
}

TEST_F(SceneBuilderTest, DoesNotOpenFilesOfUnneededStructures)
{
  SceneStructure smooth = this->Entry(this->ModelPath, true, false);
  smooth.SetNumber("texture_n", 0.2);
  smooth.SetImage("texture_image", this->Folder / "missing.nrrd");
  const BuiltScene made = this->Make(
      {this->Entry(this->Missing, false, false), smooth, this->Entry(this->ModelPath, true, true)});
  EXPECT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.OnlyDisplayed.size(), 1u);
  ASSERT_EQ(made.Account.Structures.size(), 3u);
  const SceneStructureAccount& neither = made.Account.Structures[0];
  EXPECT_EQ(neither.Name, "missing");
  EXPECT_NE(neither.Contact.WhyNot.find("neither"), std::string::npos);
  EXPECT_TRUE(neither.Contact.Is.empty() && neither.Drawing.Is.empty());
  int unread = 0;
  for (const SceneFileAccount& file : made.Account.Files)
  {
    unread += file.Reading.Is.empty() ? 1 : 0;
    EXPECT_NE(file.Reading.Is.empty(), file.Reading.WhyNot.empty());
  }
  EXPECT_EQ(unread, 2);
  EXPECT_THROW(this->Make({this->Entry(this->Missing, true, false)}), InputError);
  EXPECT_THROW(this->Make({this->Entry(this->Missing, false, true)}), InputError);
}

TEST_F(SceneBuilderTest, MakesNoDisplayWithoutViewer)
{
  const BuiltScene made = this->Make(
      {this->Entry(this->Missing, true, false), this->Entry(this->ModelPath, true, true)}, false);
  EXPECT_TRUE(made.OnlyDisplayed.empty());
  ASSERT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.Touched[0].Looks.Surface, nullptr);
  EXPECT_EQ(made.Touched[0].Looks.Model, nullptr);
  EXPECT_EQ(made.Account.Structures[1].Drawing.WhyNot, "nothing is displayed here");
}

TEST_F(SceneBuilderTest, OnlyDisplayedHasNeitherFieldNorContact)
{
  SceneStructure sphere = this->Entry(this->MaskPath, true, false);
  sphere.Labels = {"3"};
  SceneStructure bright = this->Entry(this->MaskPath, true, false);
  bright.Iso = 2.5;
  std::vector<SceneStructure> entries{bright};
  for (const char* const representation :
       {TouchRepresentation::Automatic, TouchRepresentation::Facets, TouchRepresentation::Harmonics,
        TouchRepresentation::SubVoxel})
  {
    sphere.Representation = representation;
    sphere.Degree = 2;
    entries.push_back(sphere);
  }
  for (const SceneStructure& entry : entries)
  {
    const BuiltScene made = this->Make({entry});
    ASSERT_EQ(made.OnlyDisplayed.size(), 1u);
    EXPECT_EQ(made.OnlyDisplayed[0].Touch.Model, nullptr);
    EXPECT_EQ(made.OnlyDisplayed[0].Looks.Field, nullptr);
    ASSERT_NE(made.OnlyDisplayed[0].Looks.Surface, nullptr);
    EXPECT_EQ(made.Account.Structures[0].Contact.Bytes, 0u);
    EXPECT_GT(made.Account.Structures[0].Drawing.Bytes, 0u);
  }
}

TEST_F(SceneBuilderTest, OnlyTouchedHasNoDrawing)
{
  SceneStructure sphere = this->Entry(this->MaskPath, false, true);
  sphere.Labels = {"3"};
  sphere.Degree = 2;
  for (const char* const representation :
       {TouchRepresentation::SubVoxel, TouchRepresentation::Facets, TouchRepresentation::Harmonics})
  {
    sphere.Representation = representation;
    const BuiltScene made = this->Make({sphere});
    ASSERT_EQ(made.Touched.size(), 1u);
    const TouchAppearance& looks = made.Touched[0].Looks;
    EXPECT_TRUE(looks.Field == nullptr && looks.Surface == nullptr && looks.Model == nullptr);
    EXPECT_EQ(made.Account.Structures[0].Contact.Bytes, made.Touched[0].Touch.Model->Bytes());
    EXPECT_GT(made.Account.Structures[0].Contact.Bytes, 0u);
    EXPECT_EQ(made.Account.Structures[0].Drawing.Bytes, 0u);
  }
}

// A sphere of 5 mm and a tool of 2 mm in an image of 100 mm: 14³ of 100³ voxels, plus a margin.
TEST_F(SceneBuilderTest, TextureKeepsTheImageWithinReachOfTheTool)
{
  test::LabelGrid grid;
  grid.Size = {{100, 100, 100}};
  grid.CenterOnOrigin();
  SceneStructure sphere = this->Entry(this->ModelPath, false, true);
  const std::uintmax_t smooth = this->Make({sphere}).Account.Structures[0].Contact.Bytes;
  sphere.SetNumber("texture_n", 0.2);
  sphere.SetImage("texture_image", this->Folder / "image.nrrd");
  WriteImage(this->Folder / "image.nrrd",
             test::MakeLabelImage(grid, [](double x, double, double) { return x > 0.0; }));
  const BuiltScene made = this->Make({sphere});
  EXPECT_EQ(made.Touched.at(0).Touch.Effects.size(), 1U);
  const std::uintmax_t textured = made.Account.Structures[0].Contact.Bytes;
  EXPECT_GT(textured, smooth + 4 * 14 * 14 * 14);
  EXPECT_LT(textured, smooth + 4 * 100 * 100 * 100 / 10);
}

TEST_F(SceneBuilderTest, TouchedVoxelsAreDrawnByTheSameField)
{
  SceneStructure sphere = this->Entry(this->MaskPath, true, true);
  sphere.Labels = {"3"};
  const BuiltScene made = this->Make({sphere});
  EXPECT_NE(made.Touched.at(0).Looks.Field, nullptr);
  EXPECT_EQ(made.Account.Structures[0].Drawing.Bytes, 0u);
}

TEST_F(SceneBuilderTest, ReadsASharedFileOnce)
{
  SceneSettings settings = this->RowOf(this->MaskPath, Spheres, 3);
  for (SceneStructure& structure : settings.Structures)
  {
    structure.IsTouchable = true;
  }
  const BuiltScene made = BuildScene(settings, true, GoOn);
  EXPECT_EQ(made.Touched.size(), 1u * Spheres);
  EXPECT_EQ(made.Account.Files.size(), 1u);
}

TEST_F(SceneBuilderTest, MakesOnlyTheTouchedStructureWithEqualForces)
{
  const SceneSettings all = this->RowOf(this->MaskPath, Spheres, 3);
  SceneSettings alone = all;
  alone.Structures = {all.Structures[2]};
  const BuiltScene made = BuildScene(all, true, GoOn);
  EXPECT_EQ(made.Touched.size(), 1u);
  EXPECT_TRUE(made.OnlyDisplayed.empty());
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
  BuildScene(settings, true,
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
  settings.Structures = {this->Entry(this->ModelPath, true, false)};
  EXPECT_THROW(PrepareTouch(settings, {}, GoOn), InputError);
}

TEST_F(SceneBuilderTest, MakesOnlyTheTouchedStructureOfAnAtlas)
{
  const std::filesystem::path atlas = "/usr/share/mricron/templates/aal.nii.gz";
  PALPATE_REQUIRE_FILE(atlas);
  constexpr int Structures = 116;
  const BuiltScene made = BuildScene(this->RowOf(atlas, Structures, 37), true, GoOn);
  ASSERT_EQ(made.Touched.size(), 1u);
  EXPECT_EQ(made.Account.Structures.size(), 1u * Structures);
  EXPECT_EQ(made.Account.Files.size(), 1u);
  std::uintmax_t bytes = 0;
  for (const SceneStructureAccount& structure : made.Account.Structures)
  {
    bytes += structure.Contact.Bytes + structure.Drawing.Bytes;
  }
  EXPECT_EQ(bytes, made.Touched[0].Touch.Model->Bytes());
}
} // namespace
} // namespace palpate
