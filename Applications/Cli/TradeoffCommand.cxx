#include "TradeoffCommand.h"

#include "CancelDeadline.h"
#include "CommandProgress.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"
#include "SceneFile.h"
#include "ScreenText.h"
#include "SofteningCache.h"
#include "SteadyClock.h"
#include "TextTable.h"
#include "TradePage.h"
#include "TradeText.h"
#include "Units.h"
#include "WholeFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr double Mega = 1e6;

// Two significant digits, without exponents for ordinary numbers.
std::string Short(double number)
{
  if (!std::isfinite(number))
  {
    return {};
  }
  return std::abs(number) >= 10.0 ? FixedText(number, 0) : SignificantText(number, 2);
}

void PrintStructure(const TradeStructureResult& structure, std::ostream& out)
{
  TextTable table;
  table.AlignRight({1, 2, 3, 4, 5, 6, 7, 8});
  const bool yields = !structure.Rows.empty() && structure.Rows.front().Yields;
  table.AddRow({"", "us per tick", "99.9 %", yields ? "N off" : "mm off", "JND", "degrees", "MB",
                "build s", "cost s"});
  int parted = 0;
  double uncertainty = 0.0; // mm
  for (const TradeRow& row : structure.Rows)
  {
    const std::string name = Printable(Describe(row));
    if (row.State == TradeRow::Outcome::Refused)
    {
      continue;
    }
    table.AddRow({name, Short(MicrosecondsPerNanosecond * row.TickMean),
                  Short(MicrosecondsPerNanosecond * row.TickRare),
                  Short(yields ? row.ForceRare : row.BeyondPositionRare),
                  Short(row.BeyondNoticeableRare), Short(row.BeyondDirectionRare),
                  Short(row.Bytes / Mega), Short(row.BuildSeconds), Short(row.CostSeconds)});
    parted += row.Parted > 0.0 ? 1 : 0;
    uncertainty = std::max(uncertainty, row.UncertaintyMean);
  }
  out << table.Text();
  for (const std::string& message : RefusalsOf(structure))
  {
    out << Printable(message) << '\n';
  }
  if (!structure.Rows.empty())
  {
    out << "Errors (99 %) are against " << Printable(structure.Rows.front().Truth) << ".\n"
        << (uncertainty > 0.0 ? "They are those beyond its uncertainty, on average " +
                                    Short(uncertainty) + " mm.\n"
                              : "")
        << (parted > 0 ? "With " + std::to_string(parted) +
                             " settings the hand parted from the tool on some strokes, which are "
                             "left out.\n"
                       : "")
        << (yields ? "The structure yields: errors are those of its force, not of positions.\n"
                   : "");
  }
  out << Printable(structure.Name) << ": " << structure.Advice.Message << ".\n";
}
} // namespace

std::string TradeoffCommand::Examples() const
{
  return "  palpate tradeoff knee.scene.json --output trade    a table, a page, and advice\n"
         "  palpate tradeoff mask.seg.nrrd --label 1 --tool-radius 3\n"
         "  palpate tradeoff soft.json --tool-radius 8        a model that yields\n"
         "  palpate tradeoff ct.nrrd --iso 300 --tool-radius 1 --seconds 60 --output trade";
}

void TradeoffCommand::DeclareOptions(CLI::App& app)
{
  app.add_option(
         "SCENE", this->Input,
         "A scene (.scene.json), or a model, a surface, a segmentation, an image with --iso")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--label", this->Labels,
                 "Structures of a segmentation by number or name (default: all)")
      ->type_name("N|NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--iso", this->Iso,
                 "Treat the file as an image, and touch the iso-surface of this value")
      ->expected(1)
      ->check(FiniteNumber::Any());
  app.add_option("--tool-radius", this->ToolRadius,
                 "Radius of the spherical tool, mm, if the input is not a scene")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--structure", this->Structures, "Structures of the scene, by name (default: all)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--seed", this->Seed, "Random seed of the path; equal seeds give equal paths")
      ->capture_default_str();
  app.add_option("--seconds", this->Seconds, "Minimum duration of the path, s")
      ->type_name("S")
      ->check(FiniteNumber::Between(0.5, 3600.0))
      ->capture_default_str();
  app.add_option("--runs", this->Runs, "Runs of the path; a tick's time is the shortest of them")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("-o,--output", this->OutputFolder,
                 "Folder for tradeoff.csv, tradeoff.json, tradeoff.html, and advised.scene.json, "
                 "the scene with the advised settings")
      ->type_name("DIR")
      ->check(FileType::OutputFolder(
          {"tradeoff.html", "tradeoff.json", "tradeoff.csv", "advised.scene.json"}));
  app.add_flag("--json", this->Json, "Print all numbers as one JSON object");
}

SceneSettings TradeoffCommand::Scene() const
{
  if (IsSceneFile(this->Input))
  {
    if (!this->Labels.empty() || !this->Iso.empty())
    {
      throw InputError(this->Input + " is a scene, which defines labels and values itself; choose "
                                     "structures with --structure");
    }
    return ReadScene(this->Input);
  }
  SceneSettings scene;
  scene.Tool.Radius = this->ToolRadius;
  SceneStructure structure;
  structure.File = this->Input;
  structure.Labels = this->Labels;
  if (!this->Iso.empty())
  {
    structure.Iso = this->Iso.front();
  }
  scene.Structures.push_back(structure);
  return scene;
}

TradeRunSettings TradeoffCommand::Settings() const
{
  TradeRunSettings settings;
  settings.Scene = this->Scene();
  settings.Structures = this->Structures;
  settings.Measurement.Path.Seed = this->Seed;
  settings.Measurement.Path.Seconds = this->Seconds;
  settings.Measurement.Runs = this->Runs;
  settings.Program = ProgramVersion();
  return settings;
}

void TradeoffCommand::Write(const TradeResult& result, Console& console) const
{
  if (this->Json)
  {
    console.Output() << TradeJson(result);
  }
  else
  {
    for (const TradeStructureResult& structure : result.Structures)
    {
      PrintStructure(structure, console.Output());
    }
  }
  if (!this->OutputFolder.empty())
  {
    WriteOutputSet(this->OutputFolder,
                   [&](const std::filesystem::path& stage)
                   {
                     WriteWholeFile(stage / "tradeoff.csv", TradeCsv(result));
                     WriteWholeFile(stage / "tradeoff.json", TradeJson(result));
                     WriteWholeFile(stage / "tradeoff.html", TradePage(result));
                     WriteWholeFile(stage / "advised.scene.json",
                                    SceneText(result.Advised, this->OutputFolder));
                   });
    console.Note((this->OutputFolder / "tradeoff.html").string());
  }
}

int TradeoffCommand::Run(Console& console)
{
  SofteningCache::UseInProcess({}); // its build times are measured
  const Interruption interruption;
  const TradeRunSettings settings = this->Settings();
  if (!this->OutputFolder.empty())
  {
    CheckOutputFolder(this->OutputFolder); // told before the long work
  }
  const SteadyClock clock;
  const TradeResult result =
      Cancellably(console, [&] { return RunTrade(settings, clock, ProgressOn(console)); });
  console.EndProgress();
  this->Write(result, console);
  return 0;
}
} // namespace palpate::cli
