#include "FieldNodes.h"
#include "ForbiddenPhantom.h"
#include "InputError.h"
#include "ManualClock.h"
#include "Study.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::study_drilled_test
{
namespace
{
using test::ForbiddenPhantom;

constexpr std::uintmax_t Largest = 1 << 28;

class StudyDrilledTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Open.OpenSegmentation(this->Phantom.File);
    Settle(this->Open);
    this->Open.Change("drill", ForbiddenPhantom::Drilled(this->Open.State()));
    Settle(this->Open);
    Follow(this->Open);
    this->Open.Save(this->File);
  }
  static void Settle(Study& study)
  {
    while (study.Jobs().WaitForResult())
    {
      study.Deliver();
    }
  }
  static StudyDrill& DrillOf(Study& study) { return study.Touch().Drill(); }
  // As the begin of a touch does.
  static void Follow(Study& study)
  {
    DrillOf(study).Follow(study.State(), study.Contacts(),
                          ForbiddenOf(study.State(), study.Pipeline()));
  }
  // As a servo does.
  void Order(const CutOrder& order)
  {
    CutOrder next = order;
    next.Number = this->Orders++;
    const auto editor = DrillOf(this->Open).Editor();
    ASSERT_TRUE(editor->Link()->Orders.Push(next));
    editor->Take();
    DrillOf(this->Open).Finish();
  }
  void Command(DrillCommand command)
  {
    CutOrder order;
    order.Command = command;
    this->Order(order);
  }
  // A stroke from outside to this depth (mm).
  void Cut(double depth)
  {
    CutOrder order;
    order.Site = 0;
    order.From.PositionWorld = Vector3(ForbiddenPhantom::BoneRadius + 2.0, 1.0, 0.3 * depth);
    order.To.PositionWorld = Vector3(ForbiddenPhantom::BoneRadius - depth, 0.0, 0.0);
    this->Order(order);
    this->Command(DrillCommand::EndStroke);
  }
  // The voxels of the drilled bone.
  static std::vector<float> Voxels(Study& study)
  {
    const auto& drilled = DrillOf(study).Last().Drilled;
    return drilled.empty() ? std::vector<float>() : NodesOf(*drilled.at(0).Field, 0);
  }
  static double Removed(Study& study)
  {
    const auto& drilled = DrillOf(study).Last().Drilled;
    return drilled.empty() ? 0.0 : drilled.at(0).RemovedVolume;
  }
  std::filesystem::path DrilledFile() const { return this->Phantom.Folder / "case.palpate.drill"; }

  ForbiddenPhantom Phantom;
  std::filesystem::path File = Phantom.Folder / "case.palpate.json";
  ManualClock Time;
  Study Open{this->Time};
  Study Again{this->Time};
  std::uint64_t Orders = 0;
};

TEST_F(StudyDrilledTest, SessionRestoresTheSameVoxels)
{
  this->Cut(3.0);
  this->Cut(5.0);
  ASSERT_GT(Removed(this->Open), 20.0);
  this->Open.Save(this->File);
  this->Again.Open(this->File);
  Settle(this->Again);
  EXPECT_EQ(Voxels(this->Again), Voxels(this->Open));
  EXPECT_EQ(Removed(this->Again), Removed(this->Open));
  EXPECT_EQ(this->Again.DrilledProblem(), "");
  EXPECT_FALSE(this->Again.IsChanged());
  EXPECT_GT(DrillOf(this->Again).Last().Drilled.at(0).Cut->GetNumberOfCells(), 50);
}

TEST_F(StudyDrilledTest, IsChangedUntilSavedOrUndone)
{
  EXPECT_FALSE(this->Open.IsChanged());
  this->Cut(3.0);
  EXPECT_TRUE(this->Open.IsChanged());
  this->Command(DrillCommand::Undo);
  EXPECT_FALSE(this->Open.IsChanged());
  this->Command(DrillCommand::Redo);
  EXPECT_TRUE(this->Open.IsChanged());
  this->Open.Save(this->File);
  EXPECT_FALSE(this->Open.IsChanged());
  this->Command(DrillCommand::Undo);
  EXPECT_TRUE(this->Open.IsChanged());
  this->Command(DrillCommand::Redo);
  EXPECT_FALSE(this->Open.IsChanged());
  this->Command(DrillCommand::Reset);
  EXPECT_TRUE(this->Open.IsChanged());
}

TEST_F(StudyDrilledTest, AskingForChangesEndsNoStroke)
{
  CutOrder order;
  order.Site = 0;
  for (const double y : {0.0, 4.0})
  {
    order.From.PositionWorld = Vector3(ForbiddenPhantom::BoneRadius, y, 0.0);
    order.To.PositionWorld = order.From.PositionWorld;
    this->Order(order);
    EXPECT_TRUE(this->Open.IsChanged());
  }
  this->Command(DrillCommand::Undo);
  EXPECT_EQ(Removed(this->Open), 0.0);
}

TEST_F(StudyDrilledTest, RestoredHoleIsTheFirstStateOfUndo)
{
  this->Cut(3.0);
  this->Open.Save(this->File);
  const std::vector<float> saved = Voxels(this->Open);
  this->Open.Open(this->File);
  Settle(this->Open);
  EXPECT_FALSE(DrillOf(this->Open).Last().CanUndo);
  this->Cut(6.0);
  EXPECT_NE(Voxels(this->Open), saved);
  this->Command(DrillCommand::Undo);
  EXPECT_EQ(Voxels(this->Open), saved);
  EXPECT_FALSE(DrillOf(this->Open).Last().CanUndo);
  EXPECT_FALSE(this->Open.IsChanged());
}

TEST_F(StudyDrilledTest, WritesNoFileIfNothingIsRemoved)
{
  EXPECT_FALSE(std::filesystem::exists(this->DrilledFile()));
  EXPECT_EQ(ReadWholeFile(this->File, Largest).find("\"drilled\""), std::string::npos);
  this->Cut(3.0);
  this->Open.Save(this->File);
  EXPECT_TRUE(std::filesystem::exists(this->DrilledFile()));
  this->Command(DrillCommand::Undo);
  this->Open.Save(this->File);
  this->Again.Open(this->File);
  Settle(this->Again);
  EXPECT_FALSE(DrillOf(this->Again).IsAwaiting());
}

TEST_F(StudyDrilledTest, FileOfACavityIsSmall)
{
  for (double depth = 1.0; depth < 8.0; depth += 1.0)
  {
    this->Cut(depth);
  }
  this->Open.Save(this->File);
  // At most the blocks of 8 x 8 x 8 nodes, of 4 bytes each, that a box around the cavity needs.
  const double box = (8.0 + 2.0 + 2.0 * 8.0) * (6.0 + 2.0 * 8.0) * (9.0 + 2.0 * 8.0);
  EXPECT_LT(std::filesystem::file_size(this->DrilledFile()), 4.0 * box);
}

TEST_F(StudyDrilledTest, FolderCanBeMoved)
{
  this->Cut(3.0);
  const std::filesystem::path folder = this->Phantom.Folder / "a";
  std::filesystem::create_directory(folder);
  this->Open.Save(folder / "case.palpate.json");
  std::filesystem::rename(folder, this->Phantom.Folder / "b");
  this->Again.Open(this->Phantom.Folder / "b" / "case.palpate.json");
  Settle(this->Again);
  EXPECT_EQ(Voxels(this->Again), Voxels(this->Open));
}

TEST_F(StudyDrilledTest, AnotherStudyForgetsWhatWasDrilled)
{
  this->Cut(3.0);
  const StudyState state = this->Open.State();
  this->Open.New(state);
  Settle(this->Open);
  Follow(this->Open);
  EXPECT_EQ(Removed(this->Open), 0.0);
  EXPECT_FALSE(this->Open.IsChanged());
}

TEST_F(StudyDrilledTest, UndoOfARoleBringsBackTheHole)
{
  this->Cut(3.0);
  const std::vector<float> drilled = Voxels(this->Open);
  StudyState next = this->Open.State();
  next.Structures[0].Drill.Wear = 0.0;
  this->Open.Change("Not drilled", next);
  Settle(this->Open);
  Follow(this->Open);
  EXPECT_EQ(Removed(this->Open), 0.0);
  EXPECT_TRUE(this->Open.IsChanged());
  this->Open.Undo();
  Settle(this->Open);
  Follow(this->Open);
  EXPECT_EQ(Voxels(this->Open), drilled);
  this->Open.Save(this->File);
  EXPECT_FALSE(this->Open.IsChanged());
}

TEST_F(StudyDrilledTest, WhatIsNotYetRestoredIsSavedAgain)
{
  this->Cut(3.0);
  this->Open.Save(this->File);
  const std::string saved = ReadWholeFile(this->DrilledFile(), Largest);
  const std::filesystem::path moved = this->Phantom.Folder / "moved.nii.gz";
  std::filesystem::rename(this->Phantom.File, moved);
  this->Again.Open(this->File);
  EXPECT_THROW(this->Again.Save(this->File), InputError) << "it is still being read";
  Settle(this->Again);
  this->Again.Save(this->Phantom.Folder / "b.palpate.json");
  EXPECT_EQ(ReadWholeFile(this->Phantom.Folder / "b.palpate.drill", Largest), saved);
  this->Again.RelocateFile(this->Phantom.File, moved);
  Settle(this->Again);
  EXPECT_EQ(Voxels(this->Again), Voxels(this->Open));
}

TEST_F(StudyDrilledTest, OpensWithoutAMalformedFile)
{
  this->Cut(3.0);
  this->Open.Save(this->File);
  const std::string whole = ReadWholeFile(this->DrilledFile(), Largest);
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
  for (const std::string& bytes :
       {whole.substr(0, 10), whole.substr(0, whole.size() / 2), whole.substr(0, whole.size() - 1),
        flipped, whole + "x", std::string(1000, '\0'), std::string("palpate-drill-state 1\n[{}]\n"),
        std::string("palpate-drill-state 1\n[{\"name\":\"a\",\"source\":\"b\",\"bytes\":"
                    "\"999999999999\",\"digest\":\"c\"}]\n")})
  {
    WriteWholeFile(this->DrilledFile(), bytes);
    this->Again.Open(this->File);
    Settle(this->Again);
    EXPECT_EQ(this->Again.State(), this->Open.State());
    const std::string problem = this->Again.DrilledProblem();
    EXPECT_EQ(problem.rfind("The study is open without what was drilled: ", 0), 0U) << problem;
    EXPECT_NE(problem.find("case.palpate.drill"), std::string::npos) << problem;
    Follow(this->Again);
    EXPECT_EQ(Removed(this->Again), 0.0);
    EXPECT_FALSE(this->Again.IsChanged());
  }
  std::filesystem::remove(this->DrilledFile());
  this->Again.Open(this->File);
  Settle(this->Again);
  EXPECT_NE(this->Again.DrilledProblem(), "");
  this->Again.New();
  EXPECT_EQ(this->Again.DrilledProblem(), "");
}

// Each block is checked only against the field that it belongs to.
TEST_F(StudyDrilledTest, LeavesOutDamagedRegion)
{
  this->Cut(3.0);
  std::vector<DrillRecord> records = DrillOf(this->Open).Take().Records;
  ASSERT_EQ(records.size(), 1U);
  records[0].Removed.resize(records[0].Removed.size() - 4);
  this->Open.Save(this->File);
  WriteDrillRecords(this->DrilledFile(), records);
  this->Again.Open(this->File);
  Settle(this->Again);
  EXPECT_EQ(Removed(this->Again), 0.0);
  EXPECT_NE(this->Again.DrilledProblem().find("is damaged"), std::string::npos);
}

TEST_F(StudyDrilledTest, LeavesOutWhatBelongsToOtherVoxels)
{
  this->Cut(3.0);
  std::vector<DrillRecord> records = DrillOf(this->Open).Take().Records;
  records.at(0).Source[0] = records[0].Source[0] == '0' ? '1' : '0';
  this->Open.Save(this->File);
  WriteDrillRecords(this->DrilledFile(), records);
  this->Again.Open(this->File);
  Settle(this->Again);
  EXPECT_EQ(Removed(this->Again), 0.0);
  EXPECT_NE(this->Again.DrilledProblem().find("its voxels"), std::string::npos)
      << this->Again.DrilledProblem();
  EXPECT_TRUE(this->Again.Touch().Drill().IsAwaiting()) << "it is not lost";
}

TEST_F(StudyDrilledTest, ReportsAChosenFileThatDoesNotFit)
{
  this->Cut(3.0);
  const std::vector<float> drilled = Voxels(this->Open);
  const std::filesystem::path chosen = this->Phantom.Folder / "chosen.state";
  WriteDrillRecords(chosen, DrillOf(this->Open).Take().Records);
  this->Command(DrillCommand::Reset);
  std::string message;
  const auto fail = [&message](const std::string& text) { message = text; };
  this->Open.OpenDrilled(chosen, fail);
  Settle(this->Open);
  EXPECT_EQ(message, "");
  EXPECT_EQ(Voxels(this->Open), drilled);
  this->Open.OpenDrilled(this->File, fail);
  Settle(this->Open);
  EXPECT_NE(message, "");
  EXPECT_EQ(Voxels(this->Open), drilled);
  EXPECT_EQ(this->Open.DrilledProblem(), "") << "it is told once";
}
} // namespace
} // namespace palpate::study_drilled_test
