#include "KnownOrgan.h"
#include "ModelFile.h"
#include "ShapePriorFile.h"
#include "StudyDrawnCase.h"
#include "StudyRecovery.h"
#include "WholeFile.h"
#include "ZonePrior.h"

namespace palpate::study_zone_test
{
namespace
{
// A study of the model of a ball of 9 mm, which is the known organ of a prior.
class StudyZone : public test::StudyDrawnCase
{
protected:
  StudyZone()
  {
    const std::filesystem::path file = this->Phantom.Folder / "ball.json";
    WriteModel(file, {RadialModel(0, {9.0 / ShapePrior::ConstantHarmonic}, Ball), {}});
    this->Open.AddStructure(file);
    this->Finish();
  }
  int BallId() const { return this->Open.State().Structures.front().Id; }
  std::filesystem::path ZoneFile(const std::string& name = "ball") const
  {
    WriteShapePrior(test::ZonePrior(name), this->Phantom.Folder / "zone.json");
    return this->Phantom.Folder / "zone.json";
  }
  StudyDrawing DrawingByPrior() const
  {
    StudyDrawing drawing;
    drawing.PriorFile = this->ZoneFile();
    return drawing;
  }
  const Vector3 Ball{-15.0, 0.0, 0.0};
  const StudyDrawn& Drawn() const { return this->Open.Drawn(); }
  Eigen::VectorXd Shape() const
  {
    const auto& completion =
        std::get<std::shared_ptr<SurfaceCompletion>>(*this->Organ().Completion());
    Eigen::VectorXd all(completion->Posterior().Coefficients().size() + 3);
    all << completion->Posterior().Coefficients(), completion->Posterior().CentroidWorld();
    return all;
  }
  // On the surface as it was before any touch, and `distance` mm beyond.
  std::vector<SurfaceTouch> TouchesBeyond(double distance) const
  {
    std::vector<SurfaceTouch> touches;
    const auto model = std::get<SurfaceModel>(this->Organ().Model());
    for (int n = 0; n < 8; ++n)
    {
      const Vector3 u = test::DirectionAt(n, 8);
      touches.push_back({model.Point(u) + distance * model.Normal(u), 0.5});
    }
    return touches;
  }
};

// mm, of the coefficients together: completions that start elsewhere end within some moves of
// 0.005.
constexpr double EndsElsewhere = 0.05;

TEST_F(StudyZone, LabelOfThePriorsNameIsTheKnownOne)
{
  StudyDrawing drawing;
  drawing.PriorFile = this->ZoneFile("1"); // the ball, as voxels of 1 mm
  this->Draw(drawing);
  EXPECT_EQ(this->Drawn().Known(), nullptr);
  this->Open.OpenSegmentation(this->Phantom.Folder / "mask.nii.gz");
  this->Finish();
  ASSERT_NE(this->Drawn().Known(), nullptr) << "of a file that was opened later";
  EXPECT_EQ(this->Drawn().Known()->Labels, std::vector<std::string>{"1"});
  ASSERT_NE(this->Organ().Surface(), nullptr) << "without a touch";
  EXPECT_EQ(this->Organ().Surface()->GetNumberOfPoints(), 1442);
  EXPECT_EQ(this->Organ().Next().size(), 6U);
  // As palpate complete --known has it, on the same file.
  CompletionRequest request;
  request.Prior = ReadOrganPrior(drawing.PriorFile);
  request.Known = ReadKnownOrgan(this->Phantom.Folder / "mask.nii.gz", "1", {});
  OrganCompletion alone;
  ASSERT_TRUE(CompleteOrgan(request, alone).IsOk());
  EXPECT_EQ(std::get<SurfaceModel>(this->Organ().Model()).Coefficients(1),
            std::get<SurfaceModel>(alone.Model).Coefficients(1));
  EXPECT_EQ(this->Organ().Next(), alone.Next);
  // Behind the ball.
  EXPECT_LT((CenterOf(this->Organ().Model()) - this->Ball - Vector3(0.0, 5.0, 0.0)).norm(), 1.0);
}

TEST_F(StudyZone, KnownOrganIsChosenAndUndone)
{
  StudyDrawing drawing = this->DrawingByPrior();
  this->Draw(drawing);
  drawing.Touches = this->TouchesBeyond(1.0);
  this->Draw(drawing);
  const Eigen::VectorXd given = this->Shape();
  drawing.KnownId = 0;
  this->Draw(drawing);
  EXPECT_EQ(this->Drawn().Known(), nullptr);
  EXPECT_NE(this->Shape(), given) << "from the touches alone";
  ASSERT_TRUE(this->Open.Undo());
  this->Finish();
  EXPECT_LT((this->Shape() - given).norm(), EndsElsewhere);
  drawing.KnownId = 77;
  this->Draw(drawing);
  EXPECT_EQ(this->Drawn().Known(), nullptr) << "there is no such structure";
}

TEST_F(StudyZone, OtherNamesProposeNothing)
{
  StudyDrawing drawing;
  drawing.PriorFile = this->ZoneFile("bladder");
  this->Draw(drawing);
  EXPECT_NE(this->Drawn().Relation(), nullptr);
  EXPECT_EQ(this->Drawn().Known(), nullptr);
  EXPECT_EQ(this->Organ().Surface(), nullptr);
  drawing.KnownId = this->BallId();
  this->Draw(drawing);
  EXPECT_NE(this->Organ().Surface(), nullptr);
}

TEST_F(StudyZone, RemovedTouchLeavesNoTrace)
{
  StudyDrawing drawing = this->DrawingByPrior();
  this->Draw(drawing);
  const Eigen::VectorXd none = this->Shape();
  for (const SurfaceTouch& touch : this->TouchesBeyond(1.5))
  {
    drawing.Touches.push_back(touch);
    this->Draw(drawing);
  }
  EXPECT_GT((this->Shape() - none).norm(), 0.5);
  const Eigen::VectorXd all = this->Shape();
  ASSERT_TRUE(this->Open.Undo());
  ASSERT_TRUE(this->Open.Redo());
  EXPECT_LT((this->Shape() - all).norm(), EndsElsewhere);
  drawing.Touches.clear();
  this->Draw(drawing);
  EXPECT_EQ(this->Shape(), none);
}

TEST_F(StudyZone, SessionAndRecoveryKeepTheKnownOrgan)
{
  StudyDrawing drawing = this->DrawingByPrior();
  drawing.KnownId = this->BallId();
  this->Draw(drawing);
  StudyRecovery recovery(this->Open, this->Phantom.Folder / "kept");
  drawing.Touches = this->TouchesBeyond(1.0);
  this->Draw(drawing);
  recovery.Keep();
  recovery.Finish();
  this->Open.Save(this->Phantom.Folder / "case.palpate.json");
  const auto isSame = [&](Study& again)
  {
    while (again.Jobs().WaitForResult())
    {
      again.Deliver();
    }
    EXPECT_EQ(again.State().Drawing, drawing);
    ASSERT_NE(again.Drawn().Organ().Surface(), nullptr);
    // Touches at once or one after the other: within the last moves.
    EXPECT_NEAR(again.Drawn().Organ().Milliliters(), this->Organ().Milliliters(), 0.01);
  };
  Study again(this->Time);
  again.Open(this->Phantom.Folder / "case.palpate.json");
  isSame(again);
  Study recovered(this->Time);
  recovered.Recover(recovery.Folder());
  isSame(recovered);
}

TEST_F(StudyZone, OrganThatCannotBeMeasuredIsLeftOutAndSaidSo)
{
  WriteWholeFile(this->Phantom.Folder / "none.json", "{}");
  this->Open.AddStructure(this->Phantom.Folder / "none.json");
  StudyDrawing drawing = this->DrawingByPrior();
  drawing.KnownId = this->Open.State().Structures.back().Id;
  drawing.CenterWorld = this->Ball;
  this->Draw(drawing);
  EXPECT_NE(this->Drawn().KnownProblem(), "");
  EXPECT_NE(this->Organ().Surface(), nullptr) << "by the middle";
  drawing.KnownId = this->BallId();
  this->Draw(drawing);
  EXPECT_EQ(this->Drawn().KnownProblem(), "");
}

TEST_F(StudyZone, OrganUnlikeTheGroupsIsRefusedWithTheReason)
{
  const std::filesystem::path file = this->Phantom.Folder / "large.json";
  WriteModel(file, {RadialModel(0, {400.0 / ShapePrior::ConstantHarmonic}, Ball), {}});
  this->Open.AddStructure(file);
  StudyDrawing drawing = this->DrawingByPrior();
  drawing.KnownId = this->Open.State().Structures.back().Id;
  this->Draw(drawing);
  EXPECT_EQ(this->Organ().Surface(), nullptr);
  EXPECT_NE(this->Organ().Refusal().find("those of the prior's group"), std::string::npos)
      << this->Organ().Refusal();
}

TEST_F(StudyZone, ToolFeelsTheNewestSurface)
{
  this->Draw(this->DrawingByPrior());
  const auto contact = [this]() -> std::shared_ptr<const TouchContact>
  {
    for (const SceneContact& one : this->Open.Contacts())
    {
      if (one.Id == StudyDrawn::StructureId)
      {
        return one.Contact;
      }
    }
    return nullptr;
  };
  const auto before = contact();
  ASSERT_NE(before, nullptr);
  EXPECT_EQ(before->Represented, "surface harmonics of degree 3, nearest point");
  StudyDrawing touched = this->DrawingByPrior();
  touched.Touches = this->TouchesBeyond(0.5);
  StudyState next = this->Open.State();
  next.Drawing = touched;
  this->Open.Change("Draw", next);
  EXPECT_EQ(contact(), before) << "the former one, until the new one is made";
  this->Finish();
  ASSERT_NE(contact(), nullptr);
  EXPECT_NE(contact(), before);
  EXPECT_GT(contact()->Model->BoundsWorld().volume(), before->Model->BoundsWorld().volume());
  touched.IsTouchable = false;
  this->Draw(touched);
  EXPECT_EQ(contact(), nullptr);
}
} // namespace
} // namespace palpate::study_zone_test
