#include "SceneTissue.h"

#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "ModelSoftening.h"
#include "Progress.h"
#include "SceneFile.h"
#include "SurfacePhantoms.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"
#include "WholeFile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::scene_tissue_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A gland of 14 mm, and in another file a lesion of 5 mm in its left half.
class SceneTissueTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->WriteBall(this->GlandPath, 0.0, 14.0);
    this->WriteBall(this->LesionPath, 7.0, 5.0);
  }

  void WriteBall(const std::filesystem::path& path, double x0, double radius, int label = 1) const
  {
    test::LabelGrid grid;
    grid.Size = {{26, 26, 26}};
    grid.Spacing = {{1.25, 1.25, 1.25}};
    grid.CenterOnOrigin();
    WriteImage(path, test::MakeLabelImage(
                         grid,
                         [x0, radius](double x, double y, double z)
                         { return std::hypot(x - x0, y, z) < radius; },
                         label));
  }
  // With few elements, since that is quick.
  SceneStructure Gland() const
  {
    SceneStructure gland;
    gland.Id = 1;
    gland.File = this->GlandPath;
    gland.Labels = {"1"};
    gland.Degree = 4;
    gland.Representation = TouchRepresentation::Elastic;
    gland.SetNumber(TissueKey::Elements, 4.0);
    return gland;
  }
  SceneStructure Lesion(double kilopascal) const
  {
    SceneStructure lesion;
    lesion.Id = 2;
    lesion.File = this->LesionPath;
    lesion.IsVisible = false;
    lesion.IsTouchable = false;
    lesion.SetNumber(TissueKey::Inclusion, kilopascal);
    return lesion;
  }
  static SceneSettings SceneOf(const std::vector<SceneStructure>& structures)
  {
    SceneSettings scene;
    scene.Structures = structures;
    scene.Fit.Frequency = 8;
    scene.Tool.Radius = 4.0;
    return scene;
  }
  static BuiltScene Build(const std::vector<SceneStructure>& structures)
  {
    return BuildScene(SceneOf(structures), GoOn);
  }
  // About the largest stiffness that the tool meets, N/mm.
  static double StiffnessOf(const std::vector<SceneStructure>& structures)
  {
    const ToolShape tool = ToolShape::Sphere(4.0);
    return Build(structures).Touched.at(0).Touch.Model->OwnStiffness(tool);
  }
  static std::string RefusalOf(const std::vector<SceneStructure>& structures)
  {
    try
    {
      Build(structures);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }

  test::TemporaryFolder Folder;
  std::filesystem::path GlandPath = Folder / "gland.nii.gz";
  std::filesystem::path LesionPath = Folder / "lesion.nii.gz";
};

TEST_F(SceneTissueTest, LabelYieldsMoreThanARigidOne)
{
  const auto forceOf = [](SceneStructure gland, const std::string& representation)
  {
    gland.Representation = representation;
    TouchScript script;
    script.Duration = 0.5;
    const PreparedTouch touch = PrepareTouch(SceneOf({gland}), script, GoOn);
    return static_cast<double>(RunTouch(touch, {}, GoOn).Trace.Whole().Force.Most);
  };
  const double rigid = forceOf(this->Gland(), TouchRepresentation::Harmonics);
  const double soft = forceOf(this->Gland(), TouchRepresentation::Elastic);
  EXPECT_GT(soft, 0.01);
  EXPECT_LT(soft, 0.8 * rigid);
}

TEST_F(SceneTissueTest, InclusionsStiffenAlthoughTheyAreNotTouched)
{
  const double alone = StiffnessOf({this->Gland()});
  const double with = StiffnessOf({this->Lesion(100.0), this->Gland()});
  EXPECT_GT(with, 1.03 * alone);
  EXPECT_EQ(StiffnessOf({this->Lesion(0.0), this->Gland()}), alone);
}

TEST_F(SceneTissueTest, LaterInclusionsCountWhereTheyOverlap)
{
  SceneStructure other = this->Lesion(20.0);
  other.Id = 3;
  const double hard = StiffnessOf({other, this->Gland(), this->Lesion(100.0)});
  EXPECT_EQ(hard, StiffnessOf({this->Gland(), this->Lesion(100.0)}));
  EXPECT_LT(StiffnessOf({this->Lesion(100.0), this->Gland(), other}), hard);
}

TEST_F(SceneTissueTest, NeighboursHold)
{
  this->WriteBall(this->Folder / "wall.nii.gz", 15.0, 6.0); // through the gland's surface
  SceneStructure wall = this->Lesion(0.0);
  wall.File = this->Folder / "wall.nii.gz";
  const double alone = StiffnessOf({this->Gland(), wall});
  EXPECT_EQ(alone, StiffnessOf({this->Gland()}));
  wall.SetNumber(TissueKey::Neighbour, 50.0);
  EXPECT_GT(StiffnessOf({this->Gland(), wall}), 1.05 * alone);
}

TEST_F(SceneTissueTest, NumbersReachTheTissue)
{
  const double usual = StiffnessOf({this->Gland()});
  const auto with = [this](const char* key, double number)
  {
    SceneStructure gland = this->Gland();
    gland.SetNumber(key, number);
    return StiffnessOf({gland});
  };
  EXPECT_GT(with(TissueKey::Modulus, 40.0), 1.5 * usual);
  EXPECT_LT(with(TissueKey::PoissonRatio, 0.1), usual);
  EXPECT_GT(with(TissueKey::Support, 10.0), usual);
  EXPECT_NE(with(TissueKey::ComplianceDegree, 2.0), usual);
  EXPECT_NE(with(TissueKey::MapDegree, 2.0), usual);
  EXPECT_EQ(with(TissueKey::MapDegree, 20.0), usual) << "the default";
  // The free side yields more, but the stiffest place does not.
  EXPECT_NE(with(TissueKey::FreeSide, 3.0), usual);
}

TEST_F(SceneTissueTest, ElastographyReplacesTheTissue)
{
  test::LabelGrid grid;
  grid.Size = {{20, 20, 20}};
  grid.Spacing = {{2.0, 2.0, 2.0}};
  grid.CenterOnOrigin();
  const auto everywhere = [](double, double, double) { return true; };
  WriteImage(this->Folder / "mre.nii.gz", test::MakeLabelImage<float>(grid, everywhere, 40));
  SceneStructure gland = this->Gland();
  gland.SetImage(TissueKey::Elastography, this->Folder / "mre.nii.gz");
  SceneStructure same = this->Gland();
  same.SetNumber(TissueKey::Modulus, 40.0);
  const double expected = StiffnessOf({same});
  EXPECT_NEAR(StiffnessOf({gland}), expected, 1e-3 * expected);
}

TEST_F(SceneTissueTest, RepresentationTellsTheModuli)
{
  const BuiltScene built = Build({this->Gland(), this->Lesion(60.0)});
  EXPECT_EQ(built.Touched.at(0).Represented,
            "elastic, 20 kPa, inclusions of 60 kPa, harmonics of degree 4");
  EXPECT_TRUE(built.Touched.at(0).Yields);
  this->WriteBall(this->LesionPath, 15.6, 1.5);
  EXPECT_EQ(Build({this->Gland(), this->Lesion(60.0)}).Touched.at(0).Represented,
            "elastic, 20 kPa, harmonics of degree 4")
      << "it lies outside";
}

TEST_F(SceneTissueTest, WarnsOfInclusionsThatLieOutside)
{
  EXPECT_TRUE(Build({this->Gland(), this->Lesion(60.0)}).Warnings.empty());
  EXPECT_TRUE(Build({this->Gland()}).Warnings.empty());
  this->WriteBall(this->LesionPath, 15.6, 1.5);
  const std::vector<std::string> outside = Build({this->Gland(), this->Lesion(60.0)}).Warnings;
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_NE(outside.front().find("lesion.nii.gz lies outside of gland"), std::string::npos)
      << outside.front();
  TouchScript script;
  script.Duration = 0.1;
  EXPECT_EQ(PrepareTouch(SceneOf({this->Gland(), this->Lesion(60.0)}), script, GoOn).Warnings,
            outside);
}

TEST_F(SceneTissueTest, WarnsOfInclusionsThatLieMostlyOutside)
{
  this->WriteBall(this->LesionPath, 15.0, 3.0);
  const std::vector<std::string> warnings = Build({this->Gland(), this->Lesion(60.0)}).Warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().find(" % of "), std::string::npos) << warnings.front();
  EXPECT_NE(warnings.front().find("lies in gland"), std::string::npos) << warnings.front();
}

TEST_F(SceneTissueTest, InclusionInOneOfTwoOrgansIsNoWarning)
{
  const std::filesystem::path other = this->Folder / "other.nii.gz";
  this->WriteBall(other, -10.0, 5.0);
  SceneStructure small = this->Gland();
  small.Id = 3;
  small.File = other;
  EXPECT_TRUE(Build({this->Gland(), small, this->Lesion(60.0)}).Warnings.empty());
}

TEST_F(SceneTissueTest, WarnsOfAnElastographyImageWithoutEffect)
{
  test::LabelGrid grid;
  grid.Size = {{20, 20, 20}};
  grid.CenterOnOrigin();
  const auto nowhere = [](double, double, double) { return false; };
  WriteImage(this->Folder / "mre.nii.gz", test::MakeLabelImage<float>(grid, nowhere, 40));
  SceneStructure gland = this->Gland();
  gland.SetImage(TissueKey::Elastography, this->Folder / "mre.nii.gz");
  const std::vector<std::string> warnings = Build({gland}).Warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().find("mre.nii.gz has no moduli"), std::string::npos);
}

TEST_F(SceneTissueTest, SoftensOnceWithACache)
{
  const std::filesystem::path folder = this->Folder / "cache";
  SofteningCache::UseInProcess(folder);
  const double made = StiffnessOf({this->Gland(), this->Lesion(60.0)});
  const auto count = [&folder]
  { return std::distance(std::filesystem::directory_iterator(folder), {}); };
  EXPECT_EQ(count(), 1);
  EXPECT_EQ(StiffnessOf({this->Gland(), this->Lesion(60.0)}), made);
  EXPECT_EQ(count(), 1);
  EXPECT_NE(StiffnessOf({this->Gland(), this->Lesion(90.0)}), made);
  EXPECT_EQ(count(), 2);
  SofteningCache::UseInProcess({});
}

TEST_F(SceneTissueTest, ModelThatYieldsKeepsItsOwnElasticity)
{
  SceneStructure rigid;
  rigid.File = this->Folder / "ball.json";
  const RadialModel ball(0, {14.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  WriteModel(rigid.File, {ball, {}});
  rigid.Representation = TouchRepresentation::Elastic;
  rigid.SetNumber(TissueKey::Elements, 4.0);
  rigid.SetNumber(TissueKey::Modulus, 40.0);
  EXPECT_EQ(Build({rigid}).Touched.at(0).Represented, "elastic, 40 kPa, harmonics of degree 0");
  SofteningSettings settings = SofteningSettingsOf(rigid);
  settings.TissueKilopascal = 10.0;
  WriteModel(rigid.File, {ball,
                          {"", "", "", "", {{"tissue_kpa", "10"}}},
                          SoftenModel(ball, "ball", settings, GoOn).Elasticity});
  EXPECT_EQ(Build({rigid}).Touched.at(0).Represented, "elastic, 10 kPa, harmonics of degree 0");
}

TEST_F(SceneTissueTest, RefusesWhatCannotYield)
{
  SceneStructure ring;
  ring.File = this->Folder / "ring.json";
  ring.Representation = TouchRepresentation::Elastic;
  WriteModel(ring.File, {test::OpenRing(8), {}});
  EXPECT_NE(RefusalOf({ring}).find("radial"), std::string::npos) << RefusalOf({ring});
  SceneStructure image = this->Gland();
  image.Labels.clear();
  image.Iso = 0.5;
  EXPECT_NE(RefusalOf({image}).find("since it is an image"), std::string::npos);
  this->WriteBall(this->LesionPath, 7.0, 5.0, 3);
  SceneStructure lesion = this->Lesion(60.0);
  lesion.Labels = {"9"};
  EXPECT_NE(RefusalOf({this->Gland(), lesion}).find("lesion.nii.gz"), std::string::npos);
}

TEST_F(SceneTissueTest, RefusesAbsurdNumbersByNameOfTheStructure)
{
  const std::vector<std::pair<const char*, double>> cases{{TissueKey::Modulus, 1e-9},
                                                          {TissueKey::Support, 1e-9},
                                                          {TissueKey::FreeDegrees, 1e-9},
                                                          {TissueKey::Elements, 5.0},
                                                          {TissueKey::Elements, 2.0}};
  for (const auto& [key, number] : cases)
  {
    SceneStructure gland = this->Gland();
    gland.SetNumber(key, number);
    const std::string refusal = RefusalOf({gland});
    EXPECT_NE(refusal.find("is not a"), std::string::npos) << key << ": " << refusal;
    EXPECT_NE(refusal.find("gland.nii.gz, label 1"), std::string::npos) << refusal;
  }
  EXPECT_NE(RefusalOf({this->Gland(), this->Lesion(1e-9)}).find("modulus"), std::string::npos);
}

TEST_F(SceneTissueTest, SofteningCanBeCancelled)
{
  const auto cancels = [](double, const std::string& stage)
  { return stage.find("elasticity") == std::string::npos; };
  EXPECT_THROW(BuildScene(SceneOf({this->Gland()}), cancels), Cancelled);
}

TEST_F(SceneTissueTest, RoundTripsInSceneFiles)
{
  SceneStructure gland = this->Gland();
  gland.SetNumber(TissueKey::Modulus, 12.5);
  gland.SetNumber(TissueKey::PoissonRatio, 0.45);
  gland.SetNumber(TissueKey::Support, 0.25);
  gland.SetNumber(TissueKey::FreeSide, 3.0);
  gland.SetNumber(TissueKey::FreeDegrees, 45.5);
  gland.SetImage(TissueKey::Elastography, this->Folder / "mre.nii.gz");
  SceneStructure wall = this->Lesion(0.0);
  wall.Id = 3;
  wall.SetNumber(TissueKey::Neighbour, 2.5);
  const SceneSettings scene = SceneOf({gland, this->Lesion(60.0), wall});
  const std::filesystem::path path = this->Folder / "a.scene.json";
  const std::string text = SceneText(scene, this->Folder.Path());
  WriteWholeFile(path, text);
  EXPECT_NE(text.find(R"("free_side": "posterior")"), std::string::npos) << text;
  const SceneSettings back = ReadScene(path);
  EXPECT_TRUE(back.Structures == scene.Structures);
  EXPECT_EQ(SceneText(back, this->Folder.Path()), text);
  EXPECT_EQ(SceneText(SceneOf({SceneStructure(gland)}), this->Folder.Path()).find("inclusion_kpa"),
            std::string::npos)
      << "what is not set is not written";
}

TEST_F(SceneTissueTest, SideIsThatOfThePatient)
{
  SceneStructure gland = this->Gland();
  EXPECT_TRUE(SofteningSettingsOf(gland).FreeSides.empty());
  gland.SetNumber(TissueKey::FreeSide, 1.0);
  EXPECT_EQ(SofteningSettingsOf(gland).FreeSides.at(0), Vector3::UnitX()) << "left";
  gland.SetNumber(TissueKey::FreeSide, 6.0);
  EXPECT_EQ(SofteningSettingsOf(gland).FreeSides.at(0), -Vector3::UnitZ()) << "inferior";
}
} // namespace
} // namespace palpate::scene_tissue_test
