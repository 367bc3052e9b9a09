#include "MatchingPanel.h"
#include "TransformFile.h"
#include "TutorialWindow.h"

#include <QComboBox>

#include <Eigen/Geometry>
#include <fstream>

namespace palpate::matching_tutorial_test
{
namespace
{
using Phase = HeldOrgan::Phase;

// Documentation/Tutorial/MatchTwoScans.md.
class MatchingTutorial : public test::TutorialWindow
{
protected:
  void Run(const std::vector<std::string>& words)
  {
    const test::CommandRun run = test::RunPalpate(words, this->Phantom.Folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
  }
  void MakeScans()
  {
    this->Run({"phantom", "--seed", "9", "--spacing", "1.5,1.5,3", "--output", "first"});
    this->Run({"phantom", "--seed", "9", "--spacing", "2,2,2", "--output", "later"});
    std::ofstream(this->File("lay.xfm")) << "MNI Transform File\nTransform_Type = Linear;\n"
                                            "Linear_Transform =\n 0.98481 -0.17365 0 6\n"
                                            " 0.17365 0.98481 0 -5\n 0 0 1 4;\n";
    this->Run({"convert", "later/volume.nii.gz", "second.nii.gz", "--transform", "lay.xfm"});
    this->Run({"convert", "later/mask.nii.gz", "second-gland.nii.gz", "--transform", "lay.xfm"});
  }
  void OpenBoth()
  {
    this->DropFiles({"first/volume.nii.gz", "first/mask.nii.gz"});
    WaitUntil([this] { return !this->Study->State().Structures.empty(); });
    this->Settle();
    this->Study->AddVolume(this->File("second.nii.gz"));
    const std::size_t count = this->Study->State().Structures.size();
    this->Study->AddSegmentation(this->File("second-gland.nii.gz"));
    WaitUntil([&] { return this->Study->State().Structures.size() > count; });
    this->Settle();
    WaitUntil([this] { return this->Window->Contents().Surfaces().size() == 2; });
    DrawAll(*this->Window->Views());
  }
  void Drag(const SlicePane& slice, const Vector3& motion)
  {
    const Vector3 from = this->Organ().Middle();
    this->Last = &slice;
    SendMouse(slice.Canvas(), QEvent::MouseButtonPress, PlaceIn(slice, from), Qt::LeftButton,
              Qt::LeftButton);
    for (int n = 1; n <= 10; ++n)
    {
      SendMouse(slice.Canvas(), QEvent::MouseMove, PlaceIn(slice, from + 0.1 * n * motion),
                Qt::NoButton, Qt::LeftButton);
    }
  }
  void LetGo()
  {
    SendMouse(this->Last->Canvas(), QEvent::MouseButtonRelease, QPointF(80, 80), Qt::LeftButton,
              Qt::NoButton);
    WaitUntil([this] { return this->Organ().Is() == Phase::Lying; });
  }
  const HeldOrgan& Organ() const { return this->Window->findChild<MatchingLink*>()->Organ(); }

  const SlicePane* Last = nullptr;
};

TEST_F(MatchingTutorial, SixStepsBringTwoScansTogether)
{
  ASSERT_NO_FATAL_FAILURE(this->MakeScans());
  const Eigen::Affine3d lay = ReadTransform(this->File("lay.xfm"));
  this->OpenBoth();
  this->Action("Hold and match")->trigger();
  ASSERT_EQ(this->Organ().Is(), Phase::Lying) << this->Messages();
  DrawAll(*this->Window->Views());
  this->Drag(*this->Window->Views()->Slice(SliceOrientation::Axial), Vector3(4.0, -3.0, 0.0));
  this->ExpectBaseline("tutorial-match-held.png");
  this->LetGo();
  ASSERT_TRUE(this->Organ().Match());
  this->SavedTo = QString::fromStdString(this->File("match.tfm").string());
  this->Button("match-keep")->click();
  this->Settle();
  EXPECT_EQ(this->Messages(), "");
  // A voxel of 2 mm and one of 3 mm; a gland tells place better than turn.
  const Eigen::Affine3d left = ReadTransform(this->File("match.tfm")) * lay;
  const Vector3 middle = lay.inverse() * this->Organ().Middle();
  EXPECT_LT((left * middle - middle).norm(), 1.0);
  EXPECT_LT(Eigen::AngleAxisd(Eigen::Matrix3d(left.linear())).angle(), 0.07);
  auto* mixing = this->Window->findChild<QComboBox*>("mixing");
  mixing->setCurrentIndex(1);
  Q_EMIT mixing->activated(1);
  this->ExpectBaseline("tutorial-match-kept.png");
  this->Action("Undo")->trigger();
  EXPECT_TRUE(this->Study->State().Volumes.at(0).Transform.empty());
}
} // namespace
} // namespace palpate::matching_tutorial_test
