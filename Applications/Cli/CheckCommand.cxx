#include "CheckCommand.h"

#include "CaseProcesses.h"
#include "CaseTally.h"
#include "CheckFiles.h"
#include "CheckGroupFile.h"
#include "CheckJson.h"
#include "CheckText.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "ProcessorCount.h"

#include <CLI/CLI.hpp>
#include <ostream>

namespace palpate::cli
{
std::string CheckCommand::Examples() const
{
  return "  palpate check masks --output checked        a folder of masks of one patient\n"
         "  palpate check labels.nii.gz --json          all structures of a label map\n"
         "  palpate check clean --make-group group.json what clean cases look like\n"
         "  palpate check new --group group.json        new cases, the worst first\n"
         "  palpate check new --group group.json --false-alarms 2 --strict";
}

void CheckCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("INPUT", this->Inputs,
                 "Masks, label maps, folders of masks that are one segmentation, or folders of "
                 "cases")
      ->required()
      ->check(FileType::Input("label"));
  app.add_option("--group", this->GroupFile,
                 "Clean cases to compare with, as --make-group wrote them (default: fixed limits)")
      ->type_name("FILE")
      ->check(FileType::Input("file", ".json"));
  app.add_option("--make-group", this->GroupToMake,
                 "Write what these clean cases look like, instead of judging them")
      ->type_name("FILE")
      ->check(FileType::Output("file", ".json"));
  app.add_flag("--names", this->ShowsNames,
               "With --make-group: name the odd cases that are dropped, which are numbered "
               "otherwise");
  app.add_option("--false-alarms", this->Percent,
                 "With --group: how many clean cases may get a verdict other than plausible, "
                 "percent")
      ->type_name("PERCENT")
      ->check(FiniteNumber::Between(0.1, 50.0))
      ->capture_default_str();
  app.add_option("--as", this->Settings.As,
                 "Whether the masks of a folder are structures of one patient or cases (default: "
                 "by their grids and overlaps)")
      ->check(CLI::IsMember({"structures", "cases"}));
  this->Images.Declare(app, "folder");
  this->Images.DeclareValues(app);
  app.add_option("--output", this->Output,
                 "Folder for report.html, structures.csv and check.json (default: write nothing)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({"report.html", "structures.csv", "check.json"}));
  app.add_option("--jobs", this->Jobs, "Cases at a time (default: one per processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--strict", this->IsStrict, "Exit with 1 if something is implausible");
  app.add_flag("--json", this->Json, "Print one JSON object");
}

int CheckCommand::MakeGroup(const MaskChecks& measured, Console& console) const
{
  std::vector<CheckedCase> patients;
  std::vector<std::string> names;
  for (const CaseCheck& one : measured.Cases)
  {
    if (one.IsChecked())
    {
      patients.push_back(one.Patient);
      names.push_back(one.Name);
    }
  }
  const CheckGroup group = CheckGroup::Of(patients, this->Settings.Jobs);
  if (group.Organs.empty())
  {
    throw InputError(FewCasesText(patients.size()));
  }
  WriteCheckGroup(group, this->GroupToMake);
  for (const CheckGroup::Odd& odd : group.Dropped)
  {
    console.Note((this->ShowsNames ? names[odd.Case] : "case " + std::to_string(odd.Case + 1)) +
                 " does not count: " + OddCaseText(odd));
  }
  for (const GroupOrgan& organ : group.Organs)
  {
    console.Output() << organ.Name << ": " << organ.Cases << " cases\n";
  }
  console.Output() << "false alarms from " << FixedText(100.0 * group.LeastRate(), 1)
                   << " % of cases on\n";
  return 0;
}

const CheckGroup* CheckCommand::UsableGroup(const CheckGroup& group, Console& console) const
{
  const std::string tooFew = TooFewCasesText(group, this->Settings.Rate);
  if (tooFew.empty())
  {
    return &group;
  }
  console.Note(tooFew);
  return nullptr;
}

int CheckCommand::Run(Console& console)
{
  const Interruption interruption;
  if (!this->Output.empty())
  {
    CheckOutputFolder(this->Output);
  }
  if (!this->GroupFile.empty() && !this->GroupToMake.empty())
  {
    throw InputError("--make-group describes clean cases and --group judges others; give one");
  }
  this->Settings.Images = this->Images.Choice();
  this->Settings.Rate = this->Percent / 100.0;
  this->Settings.Jobs = this->Jobs > 0 ? static_cast<std::size_t>(this->Jobs) : ProcessorCount();
  CheckGroup group;
  if (!this->GroupFile.empty())
  {
    group = ReadCheckGroup(this->GroupFile);
    this->Settings.Group = this->UsableGroup(group, console);
  }
  const ProgressFunction progress = [&](double fraction, const std::string& stage)
  {
    console.Progress(fraction, stage);
    return !Interruption::WasAsked();
  };
  const bool makes = !this->GroupToMake.empty();
  const MaskChecks checks = makes ? MaskChecks::Measure(this->Inputs, this->Settings, progress)
                                  : MaskChecks::Of(this->Inputs, this->Settings, progress);
  console.EndProgress();
  CaseTally tally;
  bool isImplausible = false;
  for (const std::string& note : checks.Notes)
  {
    console.Note(note);
  }
  for (const CaseCheck& one : checks.Cases)
  {
    tally.Add(one.IsChecked() ? FitResult::Outcome::Fitted : FitResult::Outcome::BadInput);
    if (!one.IsChecked())
    {
      console.Error(one.Message);
    }
    for (const RefusedMask& mask : one.Refused)
    {
      tally.Add(FitResult::Outcome::BadInput);
      console.Error(mask.Message);
    }
    isImplausible = isImplausible || one.Worst() == OrganJudgement::Verdict::Implausible;
  }
  if (makes)
  {
    const int code = tally.Conclude(console, "were not measured");
    return code == 2 ? code : this->MakeGroup(checks, console);
  }
  if (!this->Output.empty())
  {
    WriteCheckFiles(checks, this->Output);
  }
  console.Output() << (this->Json ? CheckJson(checks, this->Output.string()) + "\n"
                                  : CheckText(checks));
  const int code = tally.Conclude(console, "were not checked");
  return code == 0 && this->IsStrict && isImplausible ? 1 : code;
}
} // namespace palpate::cli
