#include "TutorialWindow.h"
#include "YieldingSurface.h"

#include "vtkPointData.h"

#include <fstream>

namespace palpate::lesion_tutorial_test
{
namespace
{
// Documentation/Tutorial/FeelALesion.md.
class LesionTutorialTest : public test::TutorialWindow
{
protected:
  void Open();
  void Soften();
  void Feel();
  void FeelByCommandLine();

  SceneStructure& GlandOf(StudyState& state) { return state.Structures[0]; }
  // N/mm; friction decides how deep a hand comes to rest.
  double Stiffness() const { return this->Force() / this->Study->Reading().Newest.Depth; }
  vtkSurfaceDisplay* Gland() const { return this->Window->Contents().Surfaces().at(1); }
};

void LesionTutorialTest::Open()
{
  this->DropFiles({"lesion/volume.nii.gz", "lesion/mask.nii.gz"});
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  this->Settle();
  this->Opened = QStringList{QString::fromStdString(this->File("lesion/nodule.nii.gz").string())};
  this->Action("Add structures of a segmentation")->trigger();
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
  this->Settle();
  EXPECT_EQ(this->Messages(), "");
}

// As the dialog *Details* of each structure does.
void LesionTutorialTest::Soften()
{
  StudyState next = this->Study->State();
  this->GlandOf(next).Representation = TouchRepresentation::Elastic;
  this->GlandOf(next).SetNumber("modulus_kpa", 20.0);
  this->GlandOf(next).SetNumber("free_side", 3.0); // posterior
  this->GlandOf(next).SetNumber("elements_across", 12.0);
  this->GlandOf(next).Appearance = SceneAppearance::StiffnessMap;
  next.Structures[1].SetNumber("inclusion_kpa", 80.0);
  next.Structures[1].IsTouchable = false;
  next.Tool.Kind = TouchToolSettings::Shape::Sphere;
  next.Tool.Radius = 8.0;
  this->Study->Change("Let the gland yield", next);
  WaitUntil(
      [this]
      {
        return !this->Study->IsBusy() && this->Study->Current().Pipeline().Newest<FitResult>(
                                             SceneStep::Elasticity, 1) != nullptr;
      });
  this->Settle();
  EXPECT_EQ(this->Messages(), "");
  ASSERT_STREQ(this->Gland()->GetColorArray(), YieldingSurface::StiffnessArray);
  this->Action("Posterior")->trigger();
  this->ExpectBaseline("lesion-stiffness.png");
}

void LesionTutorialTest::Feel()
{
  StudyState next = this->Study->State();
  this->GlandOf(next).Appearance = SceneAppearance::Automatic;
  this->Study->Change("Show the model", next);
  this->BeginTouch();
  const RadialModel& gland = *this->Fit().Radial();
  this->Press(gland.CenterWorld(), 0.3); // by mouse; from here on to exact places
  const Vector3 over = gland.PointWorld(Vector3::UnitY()) + 5.0 * Vector3::UnitY();
  this->HoldStill(over, Vector3::UnitY()); // 3 mm deep
  const double atNodule = this->Stiffness();
  EXPECT_GT(this->Study->Reading().Newest.PatchRadius, 1.0);
  this->ExpectBaseline("lesion-touch.png");
  const Vector3 aside = (Vector3::UnitY() + 0.8 * Vector3::UnitX()).normalized();
  const Vector3 beside = gland.Normal(aside);
  this->HoldStill(gland.PointWorld(aside) + 5.0 * beside, beside);
  EXPECT_GT(atNodule, 1.2 * this->Stiffness());
  this->Button("start-touch")->click();
}

void LesionTutorialTest::FeelByCommandLine()
{
  const auto run = [this](const std::vector<std::string>& arguments)
  { return test::RunPalpate(arguments, this->Phantom.Folder.Path()); };
  ASSERT_EQ(
      run({"fit", "lesion/mask.nii.gz", "--model", "radial", "--output", "lesion/gland"}).Code, 0);
  const test::CommandRun soft =
      run({"soften", "lesion/gland/model.json", "--lesion", "lesion/nodule.nii.gz",
           "--lesion-modulus", "80kPa", "--free", "posterior", "--elements", "12", "--output",
           "lesion/soft.json", "--report", "lesion/soft.html"});
  ASSERT_EQ(soft.Code, 0) << soft.Errors;
  EXPECT_NE(soft.Output.find("A ball of 8 mm"), std::string::npos) << soft.Output;
  EXPECT_TRUE(std::filesystem::exists(this->File("lesion/soft.html")));
}

TEST_F(LesionTutorialTest, StepsLeadToAFeltNodule)
{
  const test::CommandRun run = test::RunPalpate(
      {"phantom", "--output", "lesion", "--nodule", "10,2"}, this->Phantom.Folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  ASSERT_NO_FATAL_FAILURE(this->Open());
  ASSERT_NO_FATAL_FAILURE(this->Soften());
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  ASSERT_NO_FATAL_FAILURE(this->FeelByCommandLine());
}
} // namespace
} // namespace palpate::lesion_tutorial_test
