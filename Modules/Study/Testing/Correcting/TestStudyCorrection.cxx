#include "CorrectedShape.h"
#include "CorrectionFiles.h"
#include "InputError.h"
#include "ManualClock.h"
#include "ModelFile.h"
#include "SegmentationFile.h"
#include "Study.h"
#include "StudyJson.h"
#include "StudyPhantoms.h"
#include "StudyRecovery.h"
#include "StudyStructures.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::study_correction_test
{
namespace
{
const Vector3 Center(-15.0, 0.0, 0.0); // of label 1, a sphere of 9 mm
const Vector3 Top(-15.0, 9.0, 0.0);

SurfacePull Pulled(const Vector3& place, double by, double width = 3.0)
{
  SurfacePull pull;
  pull.PlaceWorld = place;
  pull.Displacement = by;
  pull.Width = width;
  return pull;
}

class StudyCorrectionTest : public testing::Test
{
protected:
  void SetUp() override
  {
    StudyState state = this->Phantom.State();
    state.Structures[0].IsVisible = false; // nothing else has to be made
    state.Structures[0].IsTouchable = false;
    this->Open.New(state);
    this->Settle();
    this->Change([](StudyCorrection& correction) { correction.StructureId = 1; });
  }
  void Settle()
  {
    while (!this->Open.Jobs().IsIdle())
    {
      this->Open.Jobs().WaitForResult();
      this->Open.Deliver();
    }
  }
  template <typename Edit>
  void Change(const Edit& edit)
  {
    StudyState next = this->Open.State();
    edit(next.Correction);
    this->Open.Change("Correct", next);
    this->Settle();
  }
  void Do(const CorrectionStep& step)
  {
    this->Change([&step](StudyCorrection& correction) { correction.Steps.push_back(step); });
  }
  StudyCorrected& Shape() { return this->Open.Corrected(); }
  // How far the surface is from the sphere's centre where it is nearest to a place.
  double RadiusAt(const Vector3& place)
  {
    const SurfaceCorrection& pulls = *this->Shape().Pulls();
    return (pulls.PointNow(pulls.NearestNow(place)) - Center).norm();
  }

  test::StudyPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time};
};

TEST_F(StudyCorrectionTest, PullMovesTheSurfaceAtOnceAndIsMeasuredLater)
{
  const double before = this->RadiusAt(Top);
  EXPECT_NEAR(before, 9.0, 0.7) << "voxels of 1 mm";
  StudyState next = this->Open.State();
  next.Correction.Steps.emplace_back(Pulled(Top, 3.0));
  this->Open.Change("Pull", next);
  EXPECT_TRUE(this->Shape().IsReady()) << "without a job";
  EXPECT_NEAR(this->RadiusAt(Top + Vector3(0, 3, 0)), before + 3.0, 0.1);
  EXPECT_EQ(this->Shape().Change(), nullptr);
  this->Settle();
  const CorrectionChange* change = this->Shape().Change();
  ASSERT_NE(change, nullptr);
  EXPECT_GT(change->AddedVoxels, 20);
  EXPECT_EQ(change->RemovedVoxels, 0);
  EXPECT_LT(change->Dice, 1.0);
  EXPECT_NEAR(change->LargestDistance, 3.0, 0.8);
  EXPECT_NEAR(change->Milliliters - change->StartMilliliters, 1e-3 * change->AddedVoxels, 1e-9);
}

TEST_F(StudyCorrectionTest, UndoHasTheSurfaceFromBefore)
{
  const SurfaceCorrection& pulls = *this->Shape().Pulls();
  this->Do(Pulled(Top, 2.0));
  const Eigen::Matrix3Xd once = this->Shape().Pulls()->Displacements();
  this->Do(Pulled(Center - Vector3(9, 0, 0), -2.0));
  EXPECT_TRUE(this->Open.Undo());
  EXPECT_TRUE(this->Shape().IsReady());
  EXPECT_EQ(this->Shape().Pulls()->Displacements(), once);
  this->Open.Undo();
  EXPECT_TRUE(pulls.Displacements().isZero(0.0)) << "all the way";
  this->Settle();
  EXPECT_EQ(this->Shape().Change(), nullptr);
}

TEST_F(StudyCorrectionTest, PreviewLeavesTheStepsAndEnds)
{
  const vtkSmartPointer<vtkPolyData> before = this->Shape().Surface();
  ASSERT_TRUE(this->Shape().Preview(Pulled(Top, 4.0)).IsOk());
  EXPECT_GT(this->Shape().Surface()->GetBounds()[3], before->GetBounds()[3] + 3.5);
  EXPECT_TRUE(this->Shape().IsMoved());
  this->Shape().EndPreview();
  EXPECT_EQ(this->Shape().Surface()->GetBounds()[3], before->GetBounds()[3]);
  EXPECT_FALSE(this->Shape().IsMoved());
  EXPECT_FALSE(this->Shape().Preview(Pulled(Top, std::nan(""))).IsOk());
}

TEST_F(StudyCorrectionTest, EditsAreDoneByJobsAndUndone)
{
  const std::size_t points = this->Shape().Pulls()->Points().size();
  StudyState next = this->Open.State();
  next.Correction.Steps = {Pulled(Top, 2.0), PlaneCut{Center, Vector3::UnitZ()}};
  this->Open.Change("Pull and cut", next);
  EXPECT_FALSE(this->Shape().IsReady());
  EXPECT_TRUE(this->Shape().IsWorking());
  this->Settle();
  ASSERT_TRUE(this->Shape().IsReady());
  EXPECT_LT(this->Shape().Surface()->GetBounds()[5], 1.5) << "the upper half has gone";
  EXPECT_NEAR(this->Shape().Change()->Dice, 2.0 / 3.0, 0.1);
  this->Open.Undo();
  this->Settle();
  EXPECT_EQ(this->Shape().Pulls()->Points().size(), points);
  EXPECT_GT(this->Shape().Surface()->GetBounds()[5], 8.0);
}

TEST_F(StudyCorrectionTest, RefusesAStepThatCannotBeDoneUntilItIsTakenBack)
{
  this->Do(PlaneCut{Center - Vector3(0, 0, 50), Vector3::UnitZ()});
  EXPECT_NE(this->Shape().Problem().find("step 1"), std::string::npos) << this->Shape().Problem();
  EXPECT_FALSE(this->Shape().IsReady());
  this->Open.Undo();
  this->Settle();
  EXPECT_EQ(this->Shape().Problem(), "");
  EXPECT_TRUE(this->Shape().IsReady());
}

TEST_F(StudyCorrectionTest, NeighbourStopsAPullUnlessItIsTold)
{
  const Vector3 right = Center + Vector3(9, 0, 0);
  this->Do(Pulled(right, 12.0, 4.0));
  const long long stopped = this->Shape().Change()->AddedVoxels;
  this->Change([](StudyCorrection& one) { one.Neighbors = NeighborPolicy::Overwrite; });
  const long long taken = this->Shape().Change()->AddedVoxels;
  this->Change([](StudyCorrection& one) { one.Neighbors = NeighborPolicy::Overlap; });
  EXPECT_GT(taken, stopped);
  EXPECT_EQ(this->Shape().Change()->AddedVoxels, taken);
}

TEST_F(StudyCorrectionTest, ToolFeelsTheResult)
{
  const auto contactOf = [this]
  {
    for (const SceneContact& contact : this->Open.Contacts())
    {
      if (contact.Id == 1)
      {
        return contact.Contact;
      }
    }
    return std::shared_ptr<const TouchContact>();
  };
  StudyState felt = this->Open.State();
  felt.Structures[0].IsTouchable = true;
  this->Open.Change("Feel it", felt);
  this->Settle();
  const auto before = contactOf();
  ASSERT_NE(before, nullptr);
  this->Do(Pulled(Top, 3.0));
  EXPECT_NE(contactOf(), before);
  this->Shape().LetGo(true);
  EXPECT_EQ(contactOf(), nullptr) << "it must not hold back the hand that pulls it";
  this->Shape().LetGo(false);
  this->Open.Undo();
  this->Settle();
  EXPECT_EQ(contactOf(), before);
}

BrushStroke Painted(const Vector3& from, const Vector3& to, bool isInSlice)
{
  BrushStroke stroke;
  stroke.PointsWorld =
      std::make_shared<const BrushStroke::Path>(BrushStroke::Path{from, (from + to) / 3.0, to});
  stroke.Radius = 2.0;
  stroke.SliceNormal = isInSlice ? std::optional<Vector3>(Vector3::UnitZ()) : std::nullopt;
  return stroke;
}

TEST_F(StudyCorrectionTest, StrokesAreDoneByJobsAndUndone)
{
  const std::vector<unsigned char> before = this->Shape().Voxels()->Start().Inside;
  StudyState next = this->Open.State();
  next.Correction.Steps.emplace_back(Painted(Top, Top + Vector3(0, 6, 0), false));
  this->Open.Change("Paint", next);
  EXPECT_FALSE(this->Shape().IsReady());
  EXPECT_NE(this->Shape().Voxels(), nullptr) << "the next stroke need not wait";
  this->Settle();
  EXPECT_GT(this->Shape().Change()->AddedVoxels, 20);
  EXPECT_GT(this->Shape().Surface()->GetBounds()[3], 14.0);
  this->Open.Undo();
  this->Settle();
  CorrectedMask undone = *this->Shape().Voxels();
  EXPECT_EQ(undone.Mask().Inside, before);
  EXPECT_EQ(this->Shape().Change(), nullptr);
}

TEST_F(StudyCorrectionTest, FillsBetweenTheSlicesThatWerePaintedLast)
{
  const IndexToWorld grid{Vector3(0, 0, 5), Vector3(1, 1, 2).asDiagonal()};
  const auto at = [](double z) { return Painted(Vector3(1, 1, z), Vector3(3, 1, z), true); };
  const IndexRun run{{4, 5, 12}, 3};
  const VoxelEdit edit{
      std::make_shared<const std::vector<IndexRun>>(std::vector<IndexRun>{run, {{4, 6, 12}, 1}}),
      false};
  std::vector<CorrectionStep> steps{at(5.0), at(9.1)};
  EXPECT_EQ(FillingBetweenPainted(steps, grid), (SliceFilling{2, 0, 2}));
  steps.emplace_back(SliceCopy{2, 2, 3});
  EXPECT_EQ(FillingBetweenPainted(steps, grid), (SliceFilling{2, 0, 3})) << "2 is next to 3";
  steps.insert(steps.end(), {Pulled(Top, 1.0), Painted(Top, Top, false), edit});
  EXPECT_EQ(FillingBetweenPainted(steps, grid), (SliceFilling{2, 3, 12}));
  EXPECT_EQ(FillingBetweenPainted({at(5.0), at(5.0)}, grid), std::nullopt);
  EXPECT_EQ(FillingBetweenPainted({at(5.0), SliceCopy{1, 2, 9}}, grid), std::nullopt);
  EXPECT_EQ(SliceOfPlane(grid, Vector3::Zero(), Vector3(0, 1, 1)), std::nullopt) << "oblique";
  EXPECT_EQ(NumbersIn(steps), 3U * 9U + 8U);
}

TEST_F(StudyCorrectionTest, SessionAndRecoveryKeepTheSteps)
{
  SurfacePull far = Pulled(Top, 0.0);
  far.TargetWorld = Vector3(0.1, 1.0 / 3.0, -7.0);
  far.SecondWidth = 6.6;
  this->Change(
      [&far](StudyCorrection& correction)
      {
        correction.Steps = {Pulled(Top, 2.0),
                            IslandRemoval{},
                            CavityFilling{},
                            SurfaceSmoothing{1.5},
                            PlaneCut{Center, Vector3(1, 2, 30)},
                            Painted(Top / 3.0, Center, true),
                            Painted(Top, Center + Vector3(1, 2, 3), false),
                            VoxelEdit{std::make_shared<const std::vector<IndexRun>>(
                                          std::vector<IndexRun>{{{13, 20, 14}, 5}}),
                                      true},
                            SliceCopy{2, 14, 15},
                            SliceFilling{0, 12, 15},
                            far};
        correction.Neighbors = NeighborPolicy::Overlap;
      });
  const std::filesystem::path folder = this->Phantom.Folder / "kept";
  StudyRecovery recovery(this->Open, folder);
  recovery.Keep();
  recovery.Finish();
  EXPECT_EQ(ReadRecovery(folder).State.Correction, this->Open.State().Correction);
  Study other(this->Time);
  other.Recover(folder);
  while (!other.Jobs().IsIdle())
  {
    other.Jobs().WaitForResult();
    other.Deliver();
  }
  ASSERT_TRUE(other.Corrected().IsReady()) << other.Corrected().Problem();
  EXPECT_EQ(other.Corrected().Pulls()->Displacements(), this->Shape().Pulls()->Displacements());
}

TEST_F(StudyCorrectionTest, RefusesSessionsWithOtherSteps)
{
  this->Do(Pulled(Top, 2.0));
  const std::filesystem::path file = this->Phantom.Folder / "one.palpate.json";
  const std::string text = StudyText(this->Open.State(), this->Phantom.Folder.Path(), file, {});
  EXPECT_EQ(StudyFromText(text, this->Phantom.Folder.Path(), file).Correction,
            this->Open.State().Correction);
  for (const auto& [good, bad] : std::vector<std::pair<std::string, std::string>>{
           {"\"do\": \"pull\"", "\"do\": \"drill\""},
           {"\"width_mm\": 3.0", "\"width_mm\": \"wide\""},
           {"\"neighbours\": \"stop\"", "\"neighbours\": \"ask\""}})
  {
    std::string changed = text;
    const std::size_t at = changed.find(good);
    ASSERT_NE(at, std::string::npos) << good;
    changed.replace(at, good.size(), bad);
    EXPECT_THROW(StudyFromText(changed, this->Phantom.Folder.Path(), file), InputError) << bad;
  }
  EXPECT_EQ(
      StudyText(this->Phantom.State(), this->Phantom.Folder.Path(), file, {}).find("correction"),
      std::string::npos)
      << "other sessions stay as they were";
}

TEST_F(StudyCorrectionTest, KeptStructureTakesThePlaceOfItsStart)
{
  this->Do(Pulled(Top, 2.0));
  StudyState shown = this->Open.State();
  shown.Structures[0].IsVisible = true;
  const StudyState kept =
      WithKeptCorrection(shown, "corrected", this->Phantom.Folder / "new.nii.gz");
  ASSERT_EQ(kept.Structures.size(), 2U);
  EXPECT_FALSE(kept.Structures[0].IsVisible);
  EXPECT_FALSE(kept.Structures[0].IsTouchable);
  EXPECT_TRUE(kept.Structures[1].IsVisible);
  EXPECT_EQ(kept.Structures[1].Labels, kept.Structures[0].Labels);
  EXPECT_NE(kept.Structures[1].Id, 1);
  EXPECT_EQ(kept.Correction.StructureId, 0);
  EXPECT_TRUE(kept.Correction.Steps.empty());
}

TEST_F(StudyCorrectionTest, VoxelWithoutAShapeCanBePulled)
{
  StudyState next = this->Open.State();
  next.Structures.push_back(
      test::StudyPhantom::Structure(3, TouchRepresentation::SubVoxel, next.SegmentationFile));
  next.Structures.back().IsVisible = next.Structures.back().IsTouchable = false;
  next.Correction.StructureId = 3;
  this->Open.Change("Correct one voxel", next);
  this->Settle();
  ASSERT_TRUE(this->Shape().IsReady()) << this->Shape().Problem();
  const Vector3 top = this->Shape().Pulls()->Points().front();
  SurfacePull wide = Pulled(top, 0.0);
  wide.TargetWorld = top + Vector3(3, 3, 3);
  this->Do(wide);
  EXPECT_TRUE(this->Shape().IsReady());
  EXPECT_NE(this->Shape().Surface(), nullptr);
}

TEST_F(StudyCorrectionTest, StructureThatIsRemovedEndsIt)
{
  this->Do(Pulled(Top, 2.0));
  StudyState next = this->Open.State();
  next.Structures.clear();
  this->Open.Change("Remove", next);
  EXPECT_EQ(this->Shape().Pulls(), nullptr);
  EXPECT_EQ(this->Shape().Surface(), nullptr);
  this->Open.Undo();
  this->Settle();
  EXPECT_TRUE(this->Shape().IsReady());
}

TEST_F(StudyCorrectionTest, ModelIsPulledAndEditsOfVoxelsAreRefused)
{
  const std::filesystem::path file = this->Phantom.Folder / "model.json";
  ModelDocument document;
  document.Surface = RadialModel(0, {9.0 * std::sqrt(4.0 * M_PI)}, Center);
  WriteModel(file, document);
  StudyState next = this->Open.State();
  next.Structures.emplace_back();
  next.Structures.back().Id = 50;
  next.Structures.back().File = file;
  next.Correction.StructureId = 50;
  next.Correction.Steps = {Pulled(Top, 2.0)};
  this->Open.Change("Correct a model", next);
  this->Settle();
  ASSERT_TRUE(this->Shape().IsReady()) << this->Shape().Problem();
  EXPECT_FALSE(this->Shape().IsMask());
  EXPECT_NEAR(this->RadiusAt(Top), 11.0, 0.05);
  EXPECT_NEAR(this->Shape().Change()->LargestDistance, 2.0, 0.2);
  this->Do(CavityFilling{});
  EXPECT_NE(this->Shape().Problem().find("edit of voxels"), std::string::npos);
}

TEST(OffsetOnNormal, IsWhereTheLineOfSightPassesTheNormal)
{
  const Vector3 place(1.0, 2.0, 3.0);
  const auto offset = OffsetOnNormal(place, Vector3::UnitX(), place + Vector3(4, 0, 10),
                                     place + Vector3(4, 0, -10));
  ASSERT_TRUE(offset);
  EXPECT_NEAR(*offset, 4.0, 1e-12);
  const auto slanted = OffsetOnNormal(place, Vector3::UnitX(), place + Vector3(-3, 1, 5),
                                      place + Vector3(-3, 1, 5) + Vector3(1, 0, -1));
  ASSERT_TRUE(slanted);
  EXPECT_NEAR(*slanted, 2.0, 1e-12) << "at height 0 the line is 2 mm from the place";
  EXPECT_FALSE(
      OffsetOnNormal(place, Vector3::UnitZ(), place + Vector3(1, 0, 9), place + Vector3(1, 0, -9)));
}

TEST(PullAt, KeepsBothWidthsWithinTheKernelsLimits)
{
  for (const double width : {-1.0, 0.1, 3.0, 1000.0})
  {
    const SurfacePull pull = PullAt({width, true}, Top);
    EXPECT_GE(pull.Width, SurfaceCorrection::LeastWidth);
    EXPECT_LE(pull.SecondWidth, SurfaceCorrection::LargestWidth);
    EXPECT_EQ(PullAt({width, false}, Top).SecondWidth, 0.0);
  }
}

// Voxels that a pull does not reach, and the source, stay bit for bit.
TEST_F(StudyCorrectionTest, KeptMaskDiffersNearThePullOnlyAndTheSourceStays)
{
  const std::filesystem::path source = this->Phantom.Folder / "mask.nii.gz";
  const Segmentation before = ReadSegmentation(source);
  const CorrectedOrgan organ =
      CorrectedOrgan::OfMask(before, before.Find("1"), {Pulled(Top, 3.0)}, NeighborPolicy::Stop);
  const CorrectionInputs inputs{source, before.Find("1"), NeighborPolicy::Stop};
  EXPECT_THROW(WriteCorrectionFiles(organ, inputs, this->Phantom.Folder.Path(), "test"), InputError)
      << "the source's folder";
  const std::filesystem::path folder = this->Phantom.Folder / "out";
  WriteCorrectionFiles(organ, inputs, folder, "test");
  const Segmentation after = ReadSegmentation(folder / CorrectedFileOf(organ, inputs));
  vtkImageData* image = before.Layers[0];
  long long changed = 0;
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    const double was = image->GetPointData()->GetScalars()->GetTuple1(n);
    const double is = after.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n);
    changed += was != is ? 1 : 0;
    const Vector3 place(image->GetPoint(n));
    if (was != is)
    {
      EXPECT_LT((place - Top).norm(), 4.5 * 3.0) << "the kernel's reach";
      EXPECT_EQ(is, 1.0);
    }
  }
  EXPECT_EQ(changed, organ.AddedVoxels);
  EXPECT_EQ(organ.RemovedVoxels, 0);
  const CorrectionInputs again{folder / "mask.nii.gz", before.Find("1"), NeighborPolicy::Stop};
  EXPECT_THROW(WriteCorrectionFiles(organ, again, folder, "test"), InputError)
      << "also if it is an earlier result";
}
} // namespace
} // namespace palpate::study_correction_test
