#include "IcosahedronDirections.h"
#include "ImageIndexToWorld.h"
#include "SegmentationFile.h"
#include "TutorialWindow.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

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
  void Run(const std::vector<std::string>& words)
  {
    const test::CommandRun run = test::RunPalpate(words, this->Phantom.Folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
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
    WaitUntil([this] { return this->Study->Current().Drawn().Prior() != nullptr; });
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
  // Where the mask that a person would see ends, on the line from the middle to a mark.
  Vector3 EdgeTowards(const Vector3& mark) const
  {
    const Vector3 out = (mark - this->Middle).normalized();
    vtkImageData* mask = this->Truth.Layers[0];
    const IndexToWorld toWorld = IndexToWorldOf(mask);
    const int* size = mask->GetDimensions();
    Vector3 edge = this->Middle;
    for (double r = 0.0; r < 60.0; r += 0.1)
    {
      const Vector3 index = toWorld.Axes.inverse() * (this->Middle + r * out - toWorld.Origin);
      const std::array<int, 3> voxel{{static_cast<int>(std::lround(index.x())),
                                      static_cast<int>(std::lround(index.y())),
                                      static_cast<int>(std::lround(index.z()))}};
      const bool isInside = voxel[0] >= 0 && voxel[0] < size[0] && voxel[1] >= 0 &&
                            voxel[1] < size[1] && voxel[2] >= 0 && voxel[2] < size[2] &&
                            mask->GetScalarComponentAsDouble(voxel[0], voxel[1], voxel[2], 0) > 0.0;
      edge = isInside ? this->Middle + r * out : edge;
    }
    return edge;
  }

  // Touches where the outline leaves the edge most, as an eye sees it.
  void TouchTheWorst()
  {
    const ShapeCompletion* drawn = this->Study->Current().Drawn().Organ().Completion();
    const RadialModel model = drawn->Model();
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
  double DiceOf(vtkImageData* mask) const
  {
    double both = 0.0;
    double sum = 0.0;
    for (vtkIdType n = 0; n < mask->GetNumberOfPoints(); ++n)
    {
      const bool one = mask->GetPointData()->GetScalars()->GetTuple1(n) > 0.0;
      const bool other = this->Truth.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n) > 0.0;
      both += one && other ? 2.0 : 0.0;
      sum += (one ? 1.0 : 0.0) + (other ? 1.0 : 0.0);
    }
    return both / sum;
  }

  Segmentation Truth;
  Vector3 Middle = Vector3::Zero();
};

TEST_F(DrawingTutorial, SixStepsLeadToAMask)
{
  ASSERT_NO_FATAL_FAILURE(this->MakePrior());
  this->Truth = ReadSegmentation(this->File("patient/mask.nii.gz"));
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
  ASSERT_EQ(kept.Layers[0]->GetNumberOfPoints(), this->Truth.Layers[0]->GetNumberOfPoints());
  EXPECT_GT(this->DiceOf(kept.Layers[0]), 0.92) << "12 touches";
}
} // namespace
} // namespace palpate::drawing_tutorial_test
