#include "FieldNodes.h"
#include "ForbiddenPhantom.h"
#include "InputError.h"
#include "ManualClock.h"
#include "Study.h"
#include "StudyFile.h"
#include "StudyRecovery.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::study_recovery_test
{
namespace
{
using test::ForbiddenPhantom;

// A saved study of a drilled bone, of which changes are kept.
class StudyRecoveryTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Open.OpenSegmentation(this->Phantom.File);
    Settle(this->Open);
    this->Open.Change("drill", ForbiddenPhantom::Drilled(this->Open.State()));
    Settle(this->Open);
    this->Open.Touch().Drill().Follow(this->Open.State(), this->Open.Contacts(),
                                      ForbiddenOf(this->Open.State(), this->Open.Pipeline()));
    this->Open.Save(this->File);
  }
  static void Settle(Study& study)
  {
    while (study.Jobs().WaitForResult())
    {
      study.Deliver();
    }
  }
  void Cut(double depth)
  {
    CutOrder order;
    order.Number = this->Orders++;
    order.Site = 0;
    order.From.PositionWorld = Vector3(ForbiddenPhantom::BoneRadius + 2.0, 1.0, 0.3 * depth);
    order.To.PositionWorld = Vector3(ForbiddenPhantom::BoneRadius - depth, 0.0, 0.0);
    const auto editor = this->Open.Touch().Drill().Editor();
    ASSERT_TRUE(editor->Link()->Orders.Push(order));
    editor->Take();
    this->Open.Touch().Drill().Finish();
  }
  void Measure(const std::string& name)
  {
    StudyState next = this->Open.State();
    StudyMeasurement line;
    line.Name = name;
    line.PointsWorld = {Vector3(1.0, 2.0, 3.0), Vector3(0.1, -5.0, 1e-7)};
    next.Measurements.push_back(line);
    this->Open.Change("Measure", next);
  }
  void Keep()
  {
    this->Recovery.Keep();
    this->Recovery.Finish();
    EXPECT_EQ(this->Recovery.Problem(), "");
  }
  static std::vector<float> Voxels(Study& study)
  {
    const auto& drilled = study.Touch().Drill().Last().Drilled;
    return drilled.empty() ? std::vector<float>() : NodesOf(*drilled.at(0).Field, 0);
  }
  std::filesystem::path Session() const { return RecoverySession(this->Recovery.Folder()); }

  ForbiddenPhantom Phantom;
  std::filesystem::path File = Phantom.Folder / "case.palpate.json";
  ManualClock Time;
  Study Open{this->Time};
  Study Again{this->Time};
  StudyRecovery Recovery{this->Open, this->Phantom.Folder / "recovery" / "one"};
  std::uint64_t Orders = 0;
};

TEST_F(StudyRecoveryTest, RecoversStateMeasurementsAndVoxels)
{
  const std::string saved = ReadWholeFile(this->File, 1 << 20);
  this->Measure("a width");
  this->Cut(5.0);
  this->Keep();
  this->Again.Recover(this->Recovery.Folder());
  Settle(this->Again);
  EXPECT_EQ(this->Again.State(), this->Open.State());
  EXPECT_EQ(this->Again.State().Measurements.size(), 1U);
  EXPECT_EQ(Voxels(this->Again), Voxels(this->Open));
  EXPECT_EQ(this->Again.DrilledProblem(), "");
  EXPECT_EQ(ReadWholeFile(this->File, 1 << 20), saved);
}

TEST_F(StudyRecoveryTest, RecoveredStudyIsChangedAndProposesItsFormerFile)
{
  this->Measure("a width");
  this->Keep();
  this->Again.Recover(this->Recovery.Folder());
  Settle(this->Again);
  EXPECT_TRUE(this->Again.IsChanged());
  EXPECT_TRUE(this->Again.File().empty());
  EXPECT_EQ(this->Again.ProposedFile(), this->File);
  this->Again.Save(this->Phantom.Folder / "other.palpate.json");
  EXPECT_FALSE(this->Again.IsChanged());
  EXPECT_EQ(this->Again.ProposedFile(), this->Phantom.Folder / "other.palpate.json");
  this->Again.New();
  EXPECT_TRUE(this->Again.ProposedFile().empty());
}

TEST_F(StudyRecoveryTest, KeepsOnlyChanges)
{
  this->Recovery.Keep();
  EXPECT_FALSE(this->Recovery.IsWriting()) << "it is saved";
  this->Measure("a width");
  EXPECT_TRUE(this->Recovery.IsDue());
  this->Keep();
  EXPECT_FALSE(this->Recovery.IsDue());
  this->Cut(3.0);
  EXPECT_TRUE(this->Recovery.IsDue());
  this->Keep();
  EXPECT_FALSE(this->Recovery.IsDue());
  this->Measure("another");
  EXPECT_TRUE(this->Recovery.IsDue());
}

TEST_F(StudyRecoveryTest, FolderIsOfTheUserAlone)
{
  this->Measure("a width");
  this->Keep();
  EXPECT_EQ(std::filesystem::status(this->Recovery.Folder()).permissions(),
            std::filesystem::perms::owner_all);
}

TEST_F(StudyRecoveryTest, ForgetRemovesWhatIsKeptAndWhatIsBeingWritten)
{
  this->Measure("a width");
  this->Cut(3.0);
  this->Keep();
  ASSERT_TRUE(std::filesystem::exists(this->Session()));
  this->Recovery.Forget();
  EXPECT_TRUE(std::filesystem::is_empty(this->Recovery.Folder()));
  EXPECT_FALSE(this->Recovery.HasKept());
  this->Recovery.Keep();
  ASSERT_TRUE(this->Recovery.IsWriting());
  this->Recovery.Forget();
  this->Recovery.Finish();
  EXPECT_TRUE(std::filesystem::is_empty(this->Recovery.Folder()));
  EXPECT_TRUE(this->Recovery.IsDue());
}

TEST_F(StudyRecoveryTest, FailureHasAMessageAndIsTriedAgain)
{
  WriteWholeFile(this->Phantom.Folder / "recovery", "a file in place of the folder");
  this->Measure("a width");
  this->Recovery.Keep();
  this->Recovery.Finish();
  EXPECT_NE(this->Recovery.Problem().find("recovery"), std::string::npos);
  EXPECT_TRUE(this->Recovery.IsDue());
  std::filesystem::remove(this->Phantom.Folder / "recovery");
  this->Keep();
  EXPECT_TRUE(this->Recovery.HasKept());
}

TEST_F(StudyRecoveryTest, DamagedRecoveryLeavesTheOpenStudy)
{
  this->Measure("a width");
  this->Keep();
  WriteWholeFile(this->Session(), "{\"format\": \"palpate-study\"");
  const StudyState before = this->Open.State();
  EXPECT_THROW(this->Open.Recover(this->Recovery.Folder()), InputError);
  EXPECT_EQ(this->Open.State(), before);
}
} // namespace
} // namespace palpate::study_recovery_test
