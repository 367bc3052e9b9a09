#include "TaskRun.h"

#include "DecimalText.h"
#include "InputError.h"
#include "Refusal.h"
#include "TaskEvents.h"
#include "TaskFile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace palpate
{
namespace
{
constexpr const char* LogRemedy = "restore the file, or give the participant another number";

void RequireAnswers(const TaskSettings& task, const TaskParticipant& participant)
{
  for (const auto& [key, answer] : participant.Answers)
  {
    const auto question =
        std::find_if(task.Questions.begin(), task.Questions.end(),
                     [&key = key](const TaskQuestion& one) { return one.Key == key; });
    if (question == task.Questions.end())
    {
      throw InputError("the task does not ask for " + key + "; leave it out.");
    }
    const auto& words = question->Choices;
    const double number = ParseNumber(answer).value_or(std::nan(""));
    const bool isAllowed = words.empty()
                               ? number >= question->Least && number <= question->Most
                               : std::find(words.begin(), words.end(), answer) != words.end();
    if (!answer.empty() && !isAllowed)
    {
      throw InputError("the answer to " + key + " is not one that the task allows; choose " +
                       (words.empty() ? "a number from " + SignificantText(question->Least) +
                                            " to " + SignificantText(question->Most)
                                      : "one of its words") +
                       ".");
    }
  }
}

int CheckedNumber(int number)
{
  if (number < 1 || number > MostParticipants)
  {
    throw InputError("a participant has a number from 1 to " + std::to_string(MostParticipants) +
                     "; choose one.");
  }
  return number;
}
} // namespace

std::filesystem::path TaskRun::LogName(int participant)
{
  const std::string number = std::to_string(participant);
  return "participant-" + std::string(4 - std::min<std::size_t>(4, number.size()), '0') + number +
         ".jsonl";
}

TaskRun::TaskRun(const TaskSettings& task, const TaskParticipant& participant,
                 const std::filesystem::path& folder)
    : Task(task), Trials(PlanOf(task, CheckedNumber(participant.Number))),
      Log(folder / LogName(participant.Number))
{
  RequireAnswers(task, participant);
  if (this->Log.Lines().empty())
  {
    this->Log.Append(TaskBeginLine(task, participant));
  }
  else
  {
    this->Replay(folder / LogName(participant.Number), participant);
  }
}

void TaskRun::Replay(const std::filesystem::path& path, const TaskParticipant& participant)
{
  const std::vector<std::string>& lines = this->Log.Lines();
  const TaskBeginning beginning = ReadTaskBeginning(lines.front(), path);
  if (beginning.Digest != TaskDigest(this->Task))
  {
    Refuse(path, "was begun with another task, or another version of it",
           "use that task, or another folder");
  }
  if (beginning.Participant.Number != participant.Number ||
      beginning.Participant.SimulatedLevel != participant.SimulatedLevel ||
      beginning.Participant.SimulationSeed != participant.SimulationSeed)
  {
    Refuse(path, "is of another participant, simulated hand or seed", "use another folder");
  }
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    this->Take(lines[i], path, i + 1);
  }
  this->Now = this->Now == TaskState::Running ? TaskState::Ready : this->Now;
}

void TaskRun::Take(const std::string& line, const std::filesystem::path& path, std::size_t number)
{
  const TaskEvent event = ReadTaskEvent(line, path, number, this->Task.Kind);
  const auto require = [&](bool isRight)
  {
    if (!isRight)
    {
      Refuse(path, "has an event in line " + std::to_string(number) + " that cannot be there",
             LogRemedy);
    }
  };
  const bool isOfTrial = this->Now != TaskState::Finished && event.Trial == this->Trial()->Number;
  switch (event.Is)
  {
  case TaskEvent::Kind::Start:
    // A crash may have come between.
    require(isOfTrial && this->Now != TaskState::Paused && event.Attempt == this->Begun + 1);
    ++this->Begun;
    this->Now = TaskState::Running;
    break;
  case TaskEvent::Kind::End:
    require(isOfTrial && this->Now == TaskState::Running);
    this->Finish();
    break;
  case TaskEvent::Kind::Pause:
    require(this->Now == TaskState::Ready || this->Now == TaskState::Running);
    this->Now = TaskState::Paused;
    break;
  case TaskEvent::Kind::Resume:
    require(this->Now == TaskState::Paused);
    this->Now = TaskState::Ready;
    break;
  }
}

const TaskTrial* TaskRun::Trial() const
{
  return this->Next < this->Trials.size() ? &this->Trials[this->Next] : nullptr;
}

void TaskRun::Require(TaskState state) const
{
  if (this->Now != state)
  {
    throw std::logic_error("TaskRun: not in this state");
  }
}

void TaskRun::Start()
{
  this->Require(TaskState::Ready);
  this->Log.Append(TaskStartLine(this->Task, *this->Trial(), this->Begun + 1));
  ++this->Begun;
  this->Now = TaskState::Running;
}

// A pause that is due is a part of the end, so that no crash can come between.
void TaskRun::Finish()
{
  this->Now = this->Trial()->EndsBlock ? TaskState::Paused : TaskState::Ready;
  this->Begun = 0;
  ++this->Next;
  this->Now = this->Trial() == nullptr ? TaskState::Finished : this->Now;
}

TaskScore TaskRun::End(const TaskAnswer& answer, const TaskConduct& conduct)
{
  this->Require(TaskState::Running);
  const TaskScore score =
      ScoreOf(this->Task.Kind, this->Task.Targets[this->Trial()->Target], answer, conduct);
  this->Log.Append(TaskEndLine(this->Task, *this->Trial(), this->Begun, answer, conduct, score));
  this->Finish();
  return score;
}

void TaskRun::Interrupt()
{
  this->Require(TaskState::Running);
  this->Now = TaskState::Ready;
}

bool TaskRun::IsPauseDue() const
{
  return this->Now == TaskState::Paused && this->Next > 0 && this->Begun == 0 &&
         this->Trials[this->Next - 1].EndsBlock;
}

void TaskRun::Pause()
{
  this->Require(TaskState::Ready);
  this->Log.Append(TaskPauseLine(true));
  this->Now = TaskState::Paused;
}

void TaskRun::Resume()
{
  this->Require(TaskState::Paused);
  this->Log.Append(TaskPauseLine(false));
  this->Now = TaskState::Ready;
}
} // namespace palpate
