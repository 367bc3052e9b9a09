#include "IcosahedronDirections.h"
#include "SegmentationFile.h"
#include "TrueMask.h"
#include "TutorialWindow.h"

namespace palpate::drawing_tutorial_test
{
namespace
{
// Documentation/Tutorial/DrawAnOrgan.md.
class DrawingTutorial : public test::TutorialWindow
{
protected:
  void MakePrior()
  {
    std::filesystem::create_directories(this->File("masks"));
    for (const std::string seed : {"1", "2", "3"})
    {
      this->Run({"phantom", "--seed", seed, "--spacing", "2,2,3", "--output", "other"});
      std::filesystem::copy_file(this->File("other/mask.nii.gz"),
                                 this->File("masks/" + seed + ".nii.gz"));
    }
    this->Run({"cohort", "out", "--masks", "masks", "--label", "1", "--model", "radial", "--prior",
               "prior.json"});
    this->Run({"phantom", "--seed", "9", "--output", "patient"});
  }
  void OpenVolume()
  {
    this->DropFiles({"patient/volume.nii.gz"});
    WaitUntil([this] { return !this->Study->State().VolumeFile.empty(); });
    this->Settle();
    DrawAll(*this->Window->Views());
    this->Action("Draw by touch")->trigger();
    this->Opened = QStringList{QString::fromStdString(this->File("prior.json").string())};
    this->Button("draw-choose-prior")->click();
    WaitUntil([this] { return this->Study->Current().Drawn().HasPrior(); });
    EXPECT_EQ(this->Messages(), "");
  }
  // In the axial slice through it.
  void ClickAt(const Vector3& world)
  {
    this->Window->Contents().Crosshair()->SetPositionWorld(world.data());
    DrawAll(*this->Window->Views());
    const SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
    Click(axial->Canvas(), PlaceIn(*axial, world));
  }
  Vector3 EdgeTowards(const Vector3& mark) const { return this->Seen.EdgeFrom(this->Middle, mark); }

  // Touches where the outline leaves the edge most, as an eye sees it.
  void TouchTheWorst()
  {
    const auto model = std::get<RadialModel>(this->Study->Current().Drawn().Organ().Model());
    Vector3 worst = Vector3::Zero();
    double largest = 0.0;
    for (const Vector3& u : IcosahedronDirections(4).Directions())
    {
      const Vector3 surface = model.CenterWorld() + model.Radius(u) * u;
      const Vector3 edge = this->EdgeTowards(surface);
      if ((edge - surface).norm() > largest)
      {
        largest = (edge - surface).norm();
        worst = edge;
      }
    }
    this->ClickAt(worst);
  }
  test::TrueMask Seen;
  Vector3 Middle = Vector3::Zero();
};

TEST_F(DrawingTutorial, SixStepsLeadToAMask)
{
  ASSERT_NO_FATAL_FAILURE(this->MakePrior());
  this->Seen.Truth = ReadSegmentation(this->File("patient/mask.nii.gz"));
  ASSERT_NO_FATAL_FAILURE(this->OpenVolume());
  const DrawnOrgan& organ = this->Study->Current().Drawn().Organ();
  this->ClickAt(this->Middle);
  ASSERT_EQ(organ.Next().size(), 6U);
  this->ExpectBaseline("tutorial-draw-marks.png");
  while (!organ.Next().empty())
  {
    this->ClickAt(this->EdgeTowards(organ.Next().front()));
  }
  for (int n = 0; n < 6; ++n)
  {
    this->TouchTheWorst();
  }
  ASSERT_EQ(this->Study->State().Drawing.Touches.size(), 12U);
  this->Window->Contents().Crosshair()->SetPositionWorld(this->Middle.data());
  this->ExpectBaseline("tutorial-draw-organ.png");
  this->Chosen = QString::fromStdString(this->File("gland").string());
  this->Button("draw-keep")->click();
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  const Segmentation kept = ReadSegmentation(this->File("gland/mask.nii.gz"));
  ASSERT_EQ(kept.Layers[0]->GetNumberOfPoints(), this->Seen.Truth.Layers[0]->GetNumberOfPoints());
  EXPECT_GT(this->Seen.DiceOf(kept.Layers[0]), 0.92) << "12 touches";
}
} // namespace
} // namespace palpate::drawing_tutorial_test
