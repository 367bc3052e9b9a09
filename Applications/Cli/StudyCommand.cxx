#include "StudyCommand.h"

#include "CancelDeadline.h"
#include "CaseTally.h"
#include "CommandProgress.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileType.h"
#include "Interruption.h"
#include "JsonSchema.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"
#include "Progress.h"
#include "SofteningNotes.h"
#include "SteadyClock.h"
#include "StudyFiles.h"
#include "TextTable.h"

#include <CLI/CLI.hpp>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <set>
#include <vector>

namespace palpate::cli
{
namespace
{
using Kind = StudyStepState::Kind;
using JsonObject = nlohmann::ordered_json;

constexpr std::array<SceneStep, 7> StructureSteps{
    SceneStep::Surface, SceneStep::Samples, SceneStep::Model,     SceneStep::Elasticity,
    SceneStep::Field,   SceneStep::Touch,   SceneStep::Protection};

bool ShowStep(const StudyStepState& state, const std::string& title, Console& console)
{
  if (state.Is == Kind::Running)
  {
    console.Progress(state.Fraction, title);
  }
  return state.Is == Kind::Running;
}

// Of the first step that runs: a file, or a structure with its number and their count.
void ShowProgress(Study& study, Console& console)
{
  const StudyPipeline& pipeline = study.Pipeline();
  for (const SceneStep step : {SceneStep::Volume, SceneStep::Segmentation})
  {
    if (ShowStep(pipeline.StateOf(step), NameOf(step), console))
    {
      return;
    }
  }
  const std::vector<SceneStructure>& structures = study.State().Structures;
  for (const SceneStep step :
       {SceneStep::Surface, SceneStep::Samples, SceneStep::Model, SceneStep::Elasticity,
        SceneStep::Field, SceneStep::Protection, SceneStep::Touch, SceneStep::Cost})
  {
    for (std::size_t s = 0; s < structures.size(); ++s)
    {
      const std::string title = CountedCase(s + 1, structures.size(), TitleOf(structures[s]));
      if (ShowStep(pipeline.StateOf(step, structures[s].Id), title + ": " + NameOf(step), console))
      {
        return;
      }
    }
  }
}

void MakeAll(Study& study, Console& console)
{
  constexpr std::chrono::milliseconds Glance(50);
  constexpr std::chrono::seconds LongerThanTheDeadline(10);
  while (!study.Jobs().IsIdle())
  {
    if (Interruption::WasAsked())
    {
      static_cast<void>(study.Close(LongerThanTheDeadline));
      throw Cancelled();
    }
    study.Jobs().WaitForResult(Glance);
    study.Deliver();
    ShowProgress(study, console);
  }
}

// Status of a file or a structure of the study: state, details, and why it failed.
struct StepLine
{
  std::string Name;
  std::string State;
  std::string Details;
  std::vector<std::string> Messages;
  bool IsLost = false;
  std::optional<double> TickMicroseconds; ///< of the servo, if measured
};

StepLine LineOf(SceneStep step, const StudyStepState& state)
{
  const bool isLost = state.Is == Kind::Failed;
  return {NameOf(step), NameOf(state.Is),
          {},           isLost ? std::vector{state.Message} : std::vector<std::string>{},
          isLost,       {}};
}

// Its cost per tick, once measured.
void AddMeasures(const SceneStructure& structure, Study& study, StepLine& line)
{
  const StudyPipeline& pipeline = study.Pipeline();
  const auto cost = pipeline.Newest<TouchCost>(SceneStep::Cost, structure.Id);
  if (cost != nullptr && cost->Ticks > 0)
  {
    line.TickMicroseconds = 1e-3 * cost->MedianNanoseconds;
    line.Details += "; " + FixedText(*line.TickMicroseconds, 2) + " us per tick";
  }
}

// The last step that is wanted counts: a refused model is replaced by a field.
StepLine LineOf(const SceneStructure& structure, Study& study)
{
  const StudyPipeline& pipeline = study.Pipeline();
  StepLine line{TitleOf(structure), NameOf(Kind::NotWanted), {}, {}, false, {}};
  std::set<std::string> said;
  for (const SceneStep step : StructureSteps)
  {
    const StudyStepState found = pipeline.StateOf(step, structure.Id);
    if (found.Is != Kind::NotWanted)
    {
      line.State = NameOf(found.Is);
      line.IsLost = found.Is == Kind::Failed;
    }
    if (!found.Message.empty() && said.insert(found.Message).second)
    {
      line.Messages.push_back(found.Message);
    }
  }
  if (const auto contact = pipeline.Newest<TouchContact>(SceneStep::Touch, structure.Id))
  {
    line.Details = contact->Represented;
  }
  const auto fit = pipeline.Newest<FitResult>(SceneStep::Model, structure.Id);
  if (fit != nullptr && fit->State == FitResult::Outcome::Fitted)
  {
    line.Details += (line.Details.empty() ? "" : "; ") + std::string("Dice ") +
                    FixedText(fit->Dice, 4) + ", mean distance to the mask " +
                    FixedText(fit->ModelToMask.Mean, 3) + " mm";
  }
  AddMeasures(structure, study, line);
  if (structure.IsVisible && structure.Appearance != SceneAppearance::Automatic)
  {
    line.Details += (line.Details.empty() ? "" : "; ") + std::string("shown as ") +
                    NameOf(structure.Appearance);
  }
  return line;
}

std::vector<StepLine> LinesOf(Study& study)
{
  std::vector<StepLine> lines;
  for (const SceneStep step : {SceneStep::Volume, SceneStep::Segmentation, SceneStep::Tool})
  {
    const StudyStepState state = study.Pipeline().StateOf(step);
    if (state.Is != Kind::NotWanted)
    {
      lines.push_back(LineOf(step, state));
    }
  }
  const auto products = [&study](SceneStep step, int id)
  { return study.Pipeline().NewestProduct(step, id); };
  const std::vector<SofteningNote> notes = SofteningNotes(study.State(), products);
  for (const SceneStructure& structure : study.State().Structures)
  {
    lines.push_back(LineOf(structure, study));
    for (const SofteningNote& note : notes)
    {
      if (note.Id == structure.Id)
      {
        lines.back().Messages.push_back(note.Text);
      }
    }
  }
  return lines;
}

void Print(const std::vector<StepLine>& lines, bool asJson, Console& console)
{
  TextTable table;
  for (const StepLine& line : lines)
  {
    if (asJson)
    {
      JsonObject object{{JsonSchemaKey, JsonSchemaVersion},
                        {"name", line.Name},
                        {"state", line.State},
                        {"details", line.Details},
                        {"messages", line.Messages}};
      if (line.TickMicroseconds)
      {
        object["tick_us"] = *line.TickMicroseconds;
      }
      console.Output() << object.dump(-1, ' ', false, JsonObject::error_handler_t::replace) << '\n';
    }
    table.AddRow({line.Name, line.State, line.Details});
  }
  if (!asJson)
  {
    console.Output() << table.Text();
  }
}

// Each message once: the structures of a file repeat its message.
CaseTally ReportOnce(const std::vector<StepLine>& lines, Console& console)
{
  CaseTally tally;
  std::set<std::string> reported;
  for (const StepLine& line : lines)
  {
    ++tally.Cases;
    tally.BadInputs += line.IsLost ? 1 : 0;
    for (const std::string& message : line.Messages)
    {
      if (reported.insert(message).second)
      {
        line.IsLost ? console.Error(message) : console.Note(message);
      }
    }
  }
  return tally;
}
} // namespace

std::string StudyCommand::Examples() const
{
  return "  palpate study case1.palpate.json                  result of each step\n"
         "  palpate study case1.palpate.json --output out     models, surfaces, reports, markups\n"
         "  palpate touch out/scene.json                      touch the study's scene";
}

void StudyCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("SESSION", this->Input, "A session file of the application (.palpate.json)")
      ->required()
      ->check(FileType::Input("file", ".palpate.json"));
  app.add_option("--output", this->OutputFolder,
                 "Folder for models, surfaces, reports, scene.json and markups (default: write "
                 "nothing)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({"scene.json"}));
  app.add_flag("--json", this->Json, "Print one JSON object per file or structure");
}

int StudyCommand::Run(Console& console)
{
  const Interruption interruption;
  if (!this->OutputFolder.empty())
  {
    CheckOutputFolder(this->OutputFolder);
  }
  SteadyClock clock;
  Study study(clock);
  study.Open(this->Input);
  Cancellably(console, [&] { MakeAll(study, console); });
  console.EndProgress();
  const std::vector<StepLine> lines = LinesOf(study);
  Print(lines, this->Json, console);
  const CaseTally tally = ReportOnce(lines, console);
  if (!this->OutputFolder.empty() && tally.Lost() < tally.Cases)
  {
    WriteStudyFiles(study.State(), study.Pipeline(), this->OutputFolder, ProgramVersion());
  }
  return tally.Lost() > 0 && tally.Lost() < tally.Cases ? 1 : tally.ExitCode();
}
} // namespace palpate::cli
