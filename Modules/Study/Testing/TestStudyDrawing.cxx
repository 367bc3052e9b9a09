#include "InputError.h"
#include "ShapePriorFile.h"
#include "StudyDrawnCase.h"
#include "StudyJson.h"
#include "StudyRecovery.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::study_drawing_test
{
namespace
{
const Vector3 Middle(5.0, -3.0, 2.0);

// Touches of an ellipsoid of 22, 18 and 15 mm.
std::vector<SurfaceTouch> Ellipsoid(int count)
{
  std::vector<SurfaceTouch> touches;
  for (int n = 0; n < count; ++n)
  {
    const Vector3 u = test::DirectionAt(n, count);
    const double radius = 1.0 / Vector3(u.x() / 22.0, u.y() / 18.0, u.z() / 15.0).norm();
    touches.push_back({Middle + radius * u});
  }
  return touches;
}

StudyDrawing DrawingOf(int count)
{
  StudyDrawing drawing;
  drawing.Touches = Ellipsoid(count);
  return drawing;
}

// Of organs near a sphere of 18 mm.
ShapePrior SomePrior()
{
  const ShapePrior smooth = ShapePrior::Smooth(18.0);
  ShapePrior prior;
  EXPECT_TRUE(ShapePrior::Of(smooth.Mean(), 0.5 * smooth.Covariance(), 7, prior).IsOk());
  return prior;
}

const Eigen::VectorXd& ShapeOf(const DrawnOrgan& organ)
{
  return std::get<std::shared_ptr<ShapeCompletion>>(*organ.Completion())->Surface().Coefficients;
}

TEST(StudyDrawing, StrokesGetFreeNumbersAndNormalsALength)
{
  StudyDrawing drawing;
  const SurfaceTouch one{{1, 2, 3}, 1.0, Vector3(0.0, 0.0, -5.0), 7};
  ASSERT_TRUE(AddTouches(drawing, {one, one, {{4, 5, 6}}}).IsOk());
  ASSERT_TRUE(AddTouches(drawing, {one}).IsOk());
  ASSERT_EQ(drawing.Touches.size(), 4U);
  EXPECT_EQ(drawing.Touches[1].Stroke, 1);
  EXPECT_EQ(drawing.Touches[2].Stroke, 0);
  EXPECT_EQ(drawing.Touches[3].Stroke, 2) << "another stroke";
  EXPECT_EQ(*drawing.Touches[0].Normal, Vector3(0.0, 0.0, -1.0));
}

TEST(StudyDrawing, RefusesTouchesThatASessionCouldNotKeep)
{
  StudyDrawing drawing = DrawingOf(3);
  const StudyDrawing before = drawing;
  EXPECT_FALSE(AddTouches(drawing, {{{1, 2, 3}, 0.0}}).IsOk());
  EXPECT_FALSE(AddTouches(drawing, {{{1, 2, 3}, std::nan("")}}).IsOk());
  EXPECT_FALSE(AddTouches(drawing, Ellipsoid(298)).IsOk());
  std::vector<SurfaceTouch> withNormals = Ellipsoid(100);
  for (SurfaceTouch& touch : withNormals)
  {
    touch.Normal = Vector3::UnitX();
  }
  EXPECT_FALSE(AddTouches(drawing, withNormals).IsOk()) << "three rows each";
  EXPECT_EQ(drawing, before);
  EXPECT_TRUE(AddTouches(drawing, Ellipsoid(297)).IsOk());
}

TEST(StudyDrawing, StrokeIsRemovedAsAWhole)
{
  StudyDrawing drawing = DrawingOf(1);
  const std::vector<Vector3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4.5, 0, 0}};
  const std::vector<SurfaceTouch> stroke = TouchesOfStroke(line, 2.0, 0.7);
  ASSERT_EQ(stroke.size(), 3U) << "at 0, 2 and 4.5 mm";
  ASSERT_TRUE(AddTouches(drawing, stroke).IsOk());
  ASSERT_TRUE(AddTouches(drawing, {{{9, 9, 9}}}).IsOk());
  RemoveTouch(drawing, 2);
  ASSERT_EQ(drawing.Touches.size(), 2U);
  EXPECT_EQ(drawing.Touches[1].PointWorld, Vector3(9, 9, 9));
  RemoveTouch(drawing, 2);
  EXPECT_EQ(drawing.Touches.size(), 2U) << "there is no such touch";
}

TEST(StudyDrawing, NewSigmaReplacesTheFormerOneOnly)
{
  StudyDrawing drawing = DrawingOf(2);
  drawing.Touches[1].Deviation = 0.3;
  SetSigma(drawing, 2.0);
  EXPECT_EQ(drawing.Touches[0].Deviation, 2.0);
  EXPECT_EQ(drawing.Touches[1].Deviation, 0.3);
  EXPECT_EQ(drawing.Sigma, 2.0);
}

TEST(DrawnOrgan, IsThereFromTheThirdTouchOnWithoutAPrior)
{
  DrawnOrgan organ;
  organ.Update(DrawingOf(2), {});
  EXPECT_EQ(organ.Surface(), nullptr);
  EXPECT_EQ(organ.Refusal(), "");
  StudyDrawing outside = DrawingOf(3);
  outside.Touches[0].IsOutside = true;
  organ.Update(outside, {});
  EXPECT_EQ(organ.Surface(), nullptr) << "two touches on the surface";
  organ.Update(DrawingOf(3), {});
  ASSERT_NE(organ.Surface(), nullptr);
  EXPECT_EQ(organ.Surface()->GetNumberOfPoints(), 642);
}

TEST(DrawnOrgan, IsThereFromItsMiddleOnWithAPrior)
{
  const auto prior = std::make_shared<const ShapePrior>(SomePrior());
  StudyDrawing drawing;
  drawing.CenterWorld = Middle;
  DrawnOrgan organ;
  organ.Update(drawing, prior);
  ASSERT_NE(organ.Surface(), nullptr);
  // Of a sphere; its triangles' points are on it.
  EXPECT_NEAR((Vector3(organ.Surface()->GetPoint(5)) - Middle).norm(), 18.0, 1e-6);
  EXPECT_EQ(organ.Next().size(), 6U);
  EXPECT_NEAR((organ.Next()[0] - Middle).norm(), 18.0, 1e-6);
}

TEST(DrawnOrgan, IsWhatTheKernelCompletes)
{
  DrawnOrgan organ;
  for (int count = 3; count <= 12; ++count)
  {
    organ.Update(DrawingOf(count), {});
    std::unique_ptr<ShapeCompletion> alone;
    ASSERT_TRUE(CompleteSurface(Ellipsoid(count), nullptr, std::nullopt, alone).IsOk());
    EXPECT_EQ(ShapeOf(organ), alone->Surface().Coefficients) << count;
    // The maps are kept although each smooth prior is another one.
    const Eigen::VectorXd deviations =
        DeviationMap(alone->Prior(), DrawnOrgan::Frequency).Evaluate(*alone);
    vtkDataArray* shown = organ.Surface()->GetPointData()->GetArray(DrawnOrgan::DeviationArray);
    ASSERT_EQ(shown->GetNumberOfTuples(), deviations.size());
    EXPECT_NEAR(shown->GetComponent(300, 0), deviations[300], 1e-9) << count;
  }
  EXPECT_NEAR(organ.Milliliters(), 4.0 / 3.0 * 3.14159265 * 22.0 * 18.0 * 15.0 / 1000.0, 1.0);
}

// Within the last step of a completion that goes on from another one, 0.005 mm of 18.
TEST(DrawnOrgan, GoesOnFromTheLastTouchWithAPrior)
{
  const auto prior = std::make_shared<const ShapePrior>(SomePrior());
  DrawnOrgan organ;
  StudyDrawing drawing;
  drawing.CenterWorld = Middle + Vector3(2.0, 1.0, -2.0);
  for (const SurfaceTouch& touch : Ellipsoid(10))
  {
    drawing.Touches.push_back(touch);
    organ.Update(drawing, prior);
  }
  DrawnOrgan atOnce;
  atOnce.Update(drawing, prior);
  EXPECT_NE(ShapeOf(organ), ShapeOf(atOnce));
  EXPECT_LT((ShapeOf(organ) - ShapeOf(atOnce)).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(DrawnOrgan, DeviationsAreThoseOfTheNewPrior)
{
  const auto deviation = [](const DrawnOrgan& organ)
  {
    return organ.Surface()
        ->GetPointData()
        ->GetArray(DrawnOrgan::DeviationArray)
        ->GetComponent(300, 0);
  };
  const auto prior = std::make_shared<const ShapePrior>(SomePrior());
  DrawnOrgan changed;
  changed.Update(DrawingOf(5), {});
  const double smooth = deviation(changed);
  changed.Update(DrawingOf(5), prior);
  DrawnOrgan fresh;
  fresh.Update(DrawingOf(5), prior);
  EXPECT_EQ(deviation(changed), deviation(fresh));
  EXPECT_LT(deviation(changed), smooth) << "its variance is half of that";
}

TEST(DrawnOrgan, RemovedTouchLeavesNoTrace)
{
  const auto prior = std::make_shared<const ShapePrior>(SomePrior());
  for (const auto& given : {std::shared_ptr<const ShapePrior>(), prior})
  {
    StudyDrawing drawing = DrawingOf(8);
    drawing.CenterWorld = Middle;
    DrawnOrgan organ;
    organ.Update(drawing, given);
    const Eigen::VectorXd before = ShapeOf(organ);
    StudyDrawing wrong = drawing;
    wrong.Touches.push_back({Middle + Vector3(40.0, 0.0, 0.0)});
    organ.Update(wrong, given);
    EXPECT_NE(ShapeOf(organ), before);
    organ.Update(drawing, given);
    EXPECT_EQ(ShapeOf(organ), before);
  }
}

TEST(DrawnOrgan, ListsPlacesUntilTheSixthTouch)
{
  DrawnOrgan organ;
  for (int count = 3; count <= 8; ++count)
  {
    organ.Update(DrawingOf(count), {});
    EXPECT_EQ(organ.Next().size(), static_cast<std::size_t>(std::max(0, 6 - count)));
  }
}

TEST(DrawnOrgan, RefusesWhatIsNotStarShapedWhileItHolds)
{
  // Two balls of 8 mm, 50 mm apart.
  StudyDrawing drawing;
  for (int n = 0; n < 40; ++n)
  {
    const double side = n % 2 == 0 ? -25.0 : 25.0;
    drawing.Touches.push_back({Vector3(side, 0.0, 0.0) + 8.0 * test::DirectionAt(n, 40), 0.3});
  }
  DrawnOrgan organ;
  organ.Update(drawing, {});
  EXPECT_NE(organ.Refusal().find("not star-shaped"), std::string::npos) << organ.Refusal();
  organ.Update(DrawingOf(40), {});
  EXPECT_EQ(organ.Refusal(), "");
  StudyDrawing far = DrawingOf(4);
  far.Touches.push_back({Vector3(5000.0, 0.0, 0.0)});
  organ.Update(far, {});
  EXPECT_NE(organ.Refusal().find("1,000 mm"), std::string::npos) << organ.Refusal();
  EXPECT_EQ(organ.Surface(), nullptr);
}

class StudyDrawnTest : public test::StudyDrawnCase
{
protected:
  std::filesystem::path PriorFile() const
  {
    WriteShapePrior(SomePrior(), this->Phantom.Folder / "prior.json");
    return this->Phantom.Folder / "prior.json";
  }
};

TEST_F(StudyDrawnTest, EachTouchIsUndoneAndRedone)
{
  this->Draw(DrawingOf(5));
  const Eigen::VectorXd five = ShapeOf(this->Organ());
  this->Draw(DrawingOf(6));
  const Eigen::VectorXd six = ShapeOf(this->Organ());
  ASSERT_TRUE(this->Open.Undo());
  EXPECT_EQ(ShapeOf(this->Organ()), five);
  ASSERT_TRUE(this->Open.Redo());
  EXPECT_EQ(ShapeOf(this->Organ()), six);
}

TEST_F(StudyDrawnTest, SessionKeepsDrawingAndPrior)
{
  StudyDrawing drawing = DrawingOf(7);
  drawing.PriorFile = this->PriorFile();
  drawing.CenterWorld = Middle;
  drawing.Touches[3].IsOutside = true;
  drawing.Touches[2].Normal = Vector3(0.6, 0.0, -0.8);
  drawing.Touches[5].Stroke = drawing.Touches[6].Stroke = 3;
  drawing.IsSoftened = false;
  this->Draw(drawing);
  this->Open.Save(this->Phantom.Folder / "case.palpate.json");
  Study again(this->Time);
  again.Open(this->Phantom.Folder / "case.palpate.json");
  EXPECT_TRUE(again.Drawn().IsReadingPrior());
  while (again.Jobs().WaitForResult())
  {
    again.Deliver();
  }
  EXPECT_EQ(again.State().Drawing, drawing);
  EXPECT_EQ(again.Drawn().PriorCases(), std::optional<std::size_t>(7));
  EXPECT_EQ(ShapeOf(again.Drawn().Organ()), ShapeOf(this->Organ()));
}

TEST_F(StudyDrawnTest, SessionOfTooManyTouchesIsRefused)
{
  StudyState state;
  state.Drawing = DrawingOf(301);
  const std::string text = StudyText(state, "/folder", "case.palpate.json", {});
  EXPECT_THROW(StudyFromText(text, "/folder", "case.palpate.json", nullptr), InputError);
}

TEST_F(StudyDrawnTest, RecoveryKeepsTouches)
{
  StudyRecovery recovery(this->Open, this->Phantom.Folder / "kept");
  this->Draw(DrawingOf(5));
  ASSERT_TRUE(recovery.IsDue());
  recovery.Keep();
  recovery.Finish();
  this->Draw(DrawingOf(6));
  EXPECT_TRUE(recovery.IsDue()) << "each touch is kept";
  Study again(this->Time);
  again.Recover(recovery.Folder());
  EXPECT_EQ(again.State().Drawing, DrawingOf(5));
  EXPECT_NE(again.Drawn().Organ().Surface(), nullptr);
}

TEST_F(StudyDrawnTest, UnreadablePriorLeavesSmoothness)
{
  StudyDrawing drawing = DrawingOf(5);
  drawing.PriorFile = this->Phantom.Folder / "volume.nii.gz";
  this->Draw(drawing);
  EXPECT_NE(this->Open.Drawn().PriorProblem().find("volume.nii.gz"), std::string::npos);
  ASSERT_NE(this->Organ().Surface(), nullptr);
  const Eigen::VectorXd shape = ShapeOf(this->Organ());
  this->Draw(DrawingOf(5));
  EXPECT_EQ(this->Open.Drawn().PriorProblem(), "");
  EXPECT_EQ(ShapeOf(this->Organ()), shape);
}

TEST_F(StudyDrawnTest, ToolFeelsTheOrganUnlessItIsLeftOutOrRefused)
{
  EXPECT_TRUE(this->Open.Contacts().empty());
  this->Draw(DrawingOf(5));
  ASSERT_EQ(this->Open.Contacts().size(), 1U);
  EXPECT_EQ(this->Open.Contacts()[0].Id, StudyDrawn::StructureId);
  const auto contact = this->Open.Contacts()[0].Contact;
  this->Draw(DrawingOf(6));
  EXPECT_NE(this->Open.Contacts()[0].Contact, contact) << "of the new surface";
  StudyDrawing unfelt = DrawingOf(6);
  unfelt.IsTouchable = false;
  this->Draw(unfelt);
  EXPECT_TRUE(this->Open.Contacts().empty());
}

TEST_F(StudyDrawnTest, KeptOrganIsAStructureAndLeavesNoTouches)
{
  this->Draw(DrawingOf(5));
  const StudyState kept = WithKeptOrgan(this->Open.State(), "gland", "/tmp/gland/model.json");
  ASSERT_EQ(kept.Structures.size(), 1U);
  EXPECT_EQ(kept.Structures[0].Name, "gland");
  EXPECT_EQ(kept.Structures[0].Source(), SceneSource::Model);
  EXPECT_LT(kept.Structures[0].Id, StudyDrawn::StructureId);
  EXPECT_FALSE(kept.Drawing.HasPlaces());
}

// What the tool feels of the drawn organ is softer where it is less sure, never stiffer than
// evenly.
TEST_F(StudyDrawnTest, IsSofterWhereItIsUncertainUnlessTheDrawingSaysNo)
{
  StudyDrawing drawing = DrawingOf(12);
  drawing.Touches.resize(6); // of the lower half
  this->Draw(drawing);
  const double own = SceneStructure().Stiffness;
  const auto effects = [this] { return this->Open.Contacts().at(0).Effects; };
  ASSERT_NE(effects(), nullptr);
  const auto& stiffness = effects()->Made.at("stiffness image");
  vtkDataArray* deviations =
      this->Organ().Surface()->GetPointData()->GetArray(DrawnOrgan::DeviationArray);
  double range[2];
  deviations->GetRange(range);
  ASSERT_GT(range[1], 2.0 * range[0]);
  for (vtkIdType n = 0; n < deviations->GetNumberOfTuples(); ++n)
  {
    const Vector3 place(this->Organ().Surface()->GetPoint(n));
    const double there = stiffness->StiffnessAt(own, place);
    EXPECT_LT(there, own);
    // A voxel has the mean of its points, of deviations that change by less than 0.3 mm in it.
    EXPECT_NEAR(1.0 / there - 1.0 / own, deviations->GetTuple1(n), 0.4);
  }
  EXPECT_EQ(stiffness->LargestStiffness(own), own);
  SceneSettings scene;
  this->Open.Drawn().AddTo(scene);
  const TouchScene felt = MakeTouchScene(scene, this->Open.Contacts(), {});
  EXPECT_EQ(felt.Structures.at(0).Effects.at(0), stiffness);
  drawing.IsSoftened = false;
  this->Draw(drawing);
  EXPECT_EQ(effects(), nullptr);
  ASSERT_TRUE(this->Open.Undo());
  EXPECT_NE(effects(), nullptr);
}
} // namespace
} // namespace palpate::study_drawing_test
