#include "TaskCommand.h"

#include "CommandProgress.h"
#include "Console.h"
#include "FileType.h"
#include "HandSkill.h"
#include "InputError.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "ReadyTask.h"
#include "Refusal.h"
#include "SceneFile.h"
#include "ScreenText.h"
#include "TargetScene.h"
#include "TaskFile.h"
#include "TaskPlan.h"
#include "TaskResults.h"
#include "TaskText.h"
#include "WholeFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr std::uint64_t MostSeed = 1000000000;

TaskKind KindNamed(const std::string& name)
{
  const auto& names = TaskKindNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    std::string list;
    for (const std::string& one : names)
    {
      list += (list.empty() ? "" : ", ") + one;
    }
    throw InputError(name + " is not a kind of task; choose one of " + list + ".");
  }
  return static_cast<TaskKind>(found - names.begin());
}

// Scenes and patches that cannot be read would end a study with people before its first trial.
void CheckScenes(const TaskSettings& task)
{
  for (const TaskTarget& target : task.Targets)
  {
    for (const TaskCondition& condition : task.Conditions)
    {
      CheckTarget(task.Kind, target, ReadScene(target.Scene, condition.Patch));
    }
    if (!target.Image.empty())
    {
      static_cast<void>(InputFileSize(target.Image));
    }
  }
}
} // namespace

std::string TaskCommand::Examples() const
{
  return "  palpate task init landmarks --output study     a task that can be run at once\n"
         "  palpate task check study/task.json\n"
         "  palpate task plan study/task.json --participants 12\n"
         "  palpate task simulate study/task.json --participants 12 --output simulated\n"
         "  palpate task results simulated                 results.csv and analysis.R";
}

void TaskCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("ACTION", this->Action, "Action: init, check, plan, simulate or results")
      ->required()
      ->check(CLI::IsMember({"init", "check", "plan", "simulate", "results"}));
  app.add_option("WHAT", this->Input,
                 "A task (.json); for init a kind: nodule, landmarks, outline, mask, dock or path; "
                 "for results the folder of a study")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--participants", this->Simulation.Participants, "For plan and simulate: how many")
      ->check(CLI::Range(1, MostParticipants))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--level", this->Simulation.Level,
                 "For simulate: how well the hands move, see and feel")
      ->check(CLI::IsMember(HandSkill::Levels()))
      ->capture_default_str();
  app.add_option("--seed", this->Simulation.Seed,
                 "For init: of the phantoms; for simulate: of the hands; for results: of the "
                 "studies that are drawn")
      ->check(CLI::Range(std::uint64_t{0}, MostSeed))
      ->capture_default_str();
  app.add_option("--studies", this->Studies,
                 "For results of a simulation: studies that are drawn to find the power")
      ->check(CLI::Range(100, 100000))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--output", this->Output,
                 "For init and simulate: folder to write into; for results: folder for results.csv "
                 "and analysis.R (default: that of the study)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({"task.json", "results.csv", "analysis.R"}));
  app.add_flag("--json", this->Json, "Print one JSON object");
}

int TaskCommand::Init(Console& console) const
{
  const TaskKind kind = KindNamed(this->Input);
  if (std::filesystem::exists(this->Output / "task.json"))
  {
    throw InputError((this->Output / "task.json").string() +
                     " exists; choose another --output, or remove it.");
  }
  MakeOutputFolder(this->Output);
  WriteReadyTask(kind, this->Simulation.Seed, this->Output, ProgressOn(console));
  console.EndProgress();
  const TaskSettings task = ReadTask(this->Output / "task.json");
  console.Output() << (this->Json ? TaskSummaryJson(task) + "\n"
                                  : Printable((this->Output / "task.json").string()) + "\n" +
                                        TaskSummaryText(task));
  return 0;
}

int TaskCommand::Check(Console& console) const
{
  const TaskSettings task = ReadTask(this->Input);
  CheckScenes(task);
  console.Output() << (this->Json ? TaskSummaryJson(task) + "\n" : TaskSummaryText(task));
  return 0;
}

int TaskCommand::Plan(Console& console) const
{
  const TaskSettings task = ReadTask(this->Input);
  const int participants = this->Simulation.Participants;
  console.Output() << (this->Json ? TaskPlanJson(task, participants) + "\n"
                                  : TaskPlanText(task, participants));
  return 0;
}

int TaskCommand::Simulate(Console& console) const
{
  const TaskSettings task = ReadTask(this->Input);
  MakeOutputFolder(this->Output);
  SimulateTask(task, this->Simulation, this->Output, ProgressOn(console));
  console.EndProgress();
  return this->Evaluate(this->Output, console);
}

int TaskCommand::Evaluate(const std::filesystem::path& folder, Console& console) const
{
  const TaskResults results = ReadTaskResults(folder);
  const TaskComparison comparison =
      CompareConditions(results, this->Studies, this->Simulation.Seed);
  const std::filesystem::path output = this->Output.empty() ? folder : this->Output;
  WriteTaskResults(results, output);
  console.Output() << (this->Json ? TaskResultsJson(results, comparison) + "\n"
                                  : TaskResultsText(results, comparison));
  return 0;
}

int TaskCommand::Run(Console& console)
{
  const Interruption interruption;
  const bool needsOutput = this->Action == "init" || this->Action == "simulate";
  if (needsOutput && this->Output.empty())
  {
    throw InputError("palpate task " + this->Action + " writes a folder; give --output.");
  }
  if (!this->Output.empty())
  {
    CheckOutputFolder(this->Output);
  }
  return this->Action == "init"       ? this->Init(console)
         : this->Action == "check"    ? this->Check(console)
         : this->Action == "plan"     ? this->Plan(console)
         : this->Action == "simulate" ? this->Simulate(console)
                                      : this->Evaluate(this->Input, console);
}
} // namespace palpate::cli
