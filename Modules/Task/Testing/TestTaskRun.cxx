#include "InputError.h"
#include "MessageOf.h"
#include "TaskCases.h"
#include "TaskResults.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace palpate::task_run_test
{
namespace
{
using namespace palpate::test;

class TaskRunTest : public testing::Test
{
protected:
  TaskRun Open(int number = 1) { return this->Open(this->Task, number); }
  TaskRun Open(const TaskSettings& task, int number)
  {
    return TaskRun(task, {number, {{"hand", "left"}}, "", 0}, this->Folder.Path());
  }
  std::filesystem::path LogFile(int number = 1) const
  {
    return this->Folder.Path() / TaskRun::LogName(number);
  }

  TaskSettings Task = TaskOf(TaskKind::Landmarks);
  TemporaryFolder Folder;
};

TEST_F(TaskRunTest, GoesThroughItsPlanWithPauses)
{
  TaskRun run = this->Open();
  std::vector<int> paused;
  for (int done = 0; run.State() != TaskState::Finished; ++done)
  {
    if (run.State() == TaskState::Paused)
    {
      paused.push_back(done);
      run.Resume();
    }
    EXPECT_EQ(run.State(), TaskState::Ready);
    EXPECT_EQ(run.Trial()->Number, done + 1);
    run.Start();
    EXPECT_EQ(run.State(), TaskState::Running);
    EXPECT_TRUE(run.End(TargetOf(TaskKind::Landmarks).Right, {}).IsSuccess);
  }
  EXPECT_EQ(paused, std::vector<int>{3});
  EXPECT_EQ(run.Trial(), nullptr);
}

TEST_F(TaskRunTest, RefusesStepsOutOfOrder)
{
  TaskRun run = this->Open();
  EXPECT_THROW(run.End({}, {}), std::logic_error);
  EXPECT_THROW(run.Resume(), std::logic_error);
  run.Pause();
  EXPECT_THROW(run.Start(), std::logic_error);
  EXPECT_THROW(run.Pause(), std::logic_error);
  run.Resume();
  run.Start();
  EXPECT_THROW(run.Start(), std::logic_error);
  EXPECT_THROW(run.Pause(), std::logic_error);
}

TEST_F(TaskRunTest, InterruptedTrialBeginsAgainAsAfterACrash)
{
  TaskRun run = this->Open();
  run.Start();
  const std::string log = ReadAll(this->LogFile());
  run.Interrupt();
  EXPECT_EQ(ReadAll(this->LogFile()), log);
  EXPECT_EQ(run.State(), TaskState::Ready);
  EXPECT_EQ(run.Trial()->Number, 1);
  EXPECT_EQ(run.Attempts(), 1);
  EXPECT_THROW(run.Interrupt(), std::logic_error);
  run.Pause();
  EXPECT_FALSE(run.IsPauseDue());
  run.Resume();
  run.Start();
  EXPECT_EQ(run.Attempts(), 2);
}

TEST_F(TaskRunTest, OnlyThePlansPausesAreDue)
{
  TaskRun run = this->Open();
  for (int trial = 1; trial <= 3; ++trial)
  {
    run.Pause();
    EXPECT_FALSE(run.IsPauseDue());
    run.Resume();
    run.Start();
    run.End(TargetOf(TaskKind::Landmarks).Right, {});
  }
  EXPECT_TRUE(run.IsPauseDue());
  run.Resume();
  EXPECT_FALSE(run.IsPauseDue());
}

// What a crash leaves is some first bytes of the log: whole lines, and a part of one.
TEST_F(TaskRunTest, ResumesFromEveryLineAndEveryPartOfOne)
{
  {
    TaskRun run = this->Open();
    run.Pause();
    run.Resume();
    run.Start(); // is interrupted
  }
  {
    TaskRun run = this->Open();
    EXPECT_EQ(run.Attempts(), 1);
    Complete(run, TaskKind::Landmarks);
  }
  const std::string whole = ReadAll(this->LogFile());
  std::size_t cuts = 0;
  for (std::size_t cut = 0; cut <= whole.size(); ++cut)
  {
    const bool isAtALine = cut == 0 || whole[cut - 1] == '\n' || whole[cut] == '\n';
    if (!isAtALine && cut % 499 != 0)
    {
      continue;
    }
    ++cuts;
    WriteAll(this->LogFile(), whole.substr(0, cut));
    {
      TaskRun run = this->Open();
      Complete(run, TaskKind::Landmarks);
    }
    const TaskResults results = ReadTaskResults(this->Folder.Path());
    ASSERT_EQ(results.Rows.size(), 6U) << cut;
    for (std::size_t i = 0; i < results.Rows.size(); ++i)
    {
      const TaskTrial trial = PlanOf(this->Task, 1)[i];
      const TaskEvent& end = results.Rows[i].End;
      EXPECT_EQ(end.Trial, trial.Number);
      EXPECT_EQ(end.Condition, this->Task.Conditions[trial.Condition].Id);
      EXPECT_EQ(end.Target, this->Task.Targets[trial.Target].Id);
      EXPECT_EQ(end.Conduct.Seconds, 2.5);
    }
    EXPECT_EQ(TaskRun(this->Task, {1, {}, "", 0}, this->Folder.Path()).State(),
              TaskState::Finished);
  }
  EXPECT_GT(cuts, 30U);
}

TEST_F(TaskRunTest, APauseThatWasDueOutlivesACrash)
{
  {
    TaskRun run = this->Open();
    while (run.State() == TaskState::Ready)
    {
      run.Start();
      run.End(TargetOf(TaskKind::Landmarks).Right, {});
    }
  }
  EXPECT_EQ(this->Open().State(), TaskState::Paused);
}

TEST_F(TaskRunTest, RefusesAnotherTaskOrParticipant)
{
  this->Open();
  TaskSettings other = this->Task;
  other.Targets[0].Tolerance = 9.0;
  EXPECT_TRUE(Contains(MessageOf([&] { this->Open(other, 1); }), "another version"));
  std::filesystem::copy_file(this->LogFile(1), this->LogFile(2));
  EXPECT_TRUE(Contains(MessageOf([&] { this->Open(2); }), "another participant"));
  EXPECT_TRUE(Contains(MessageOf(
                           [&] {
                             TaskRun(this->Task, {1, {}, "novice", 3}, this->Folder.Path());
                           }),
                       "simulated hand"));
}

TEST_F(TaskRunTest, TwoProgramsDoNotWriteOneLog)
{
  const TaskRun run = this->Open();
  EXPECT_TRUE(Contains(MessageOf([&] { this->Open(); }), "another program"));
}

TEST_F(TaskRunTest, RefusesDamagedLogs)
{
  {
    TaskRun run = this->Open();
    Complete(run, TaskKind::Landmarks);
  }
  const std::string whole = ReadAll(this->LogFile());
  const std::size_t second = whole.find('\n') + 1;
  const std::size_t third = whole.find('\n', second) + 1;
  for (const std::string& text :
       {whole.substr(second), whole + "{}\n", whole + "no json\n",
        whole.substr(0, second) + whole.substr(third), // an end without its start
        whole.substr(0, third) + whole.substr(second), // the same attempt twice
        whole.substr(0, third) + "{\"event\":\"resume\"}\n"})
  {
    WriteAll(this->LogFile(), text);
    const std::string message = MessageOf([&] { this->Open(); });
    EXPECT_TRUE(Contains(message, "participant-0001.jsonl"));
  }
}

TEST_F(TaskRunTest, KeepsOnlyAnswersThatTheTaskAsksFor)
{
  const auto open = [this](const std::map<std::string, std::string>& answers) {
    TaskRun(this->Task, {1, answers, "", 0}, this->Folder.Path());
  };
  EXPECT_THROW(open({{"name", "Ada"}}), InputError);
  EXPECT_THROW(open({{"hand", "Ada Lovelace"}}), InputError);
  EXPECT_THROW(open({{"years", "61"}}), InputError);
  EXPECT_THROW(open({{"years", "many"}}), InputError);
  EXPECT_NO_THROW(open({{"hand", "left"}, {"years", "0.5"}}));
  EXPECT_EQ(ReadAll(this->LogFile()).find("Ada"), std::string::npos);
}

TEST_F(TaskRunTest, ParticipantsAreNumbers)
{
  EXPECT_THROW(this->Open(0), InputError);
  EXPECT_THROW(this->Open(10000), InputError);
  EXPECT_EQ(TaskRun::LogName(7), "participant-0007.jsonl");
  EXPECT_EQ(TaskRun::LogName(9999), "participant-9999.jsonl");
}
} // namespace
} // namespace palpate::task_run_test
