#include "SceneCommand.h"

#include "CommandProgress.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileType.h"
#include "FilterRun.h"
#include "InputError.h"
#include "Interruption.h"
#include "JsonSchema.h"
#include "SceneBuilder.h"
#include "SceneFile.h"
#include "ScreenText.h"
#include "TextTable.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

namespace palpate::cli
{
namespace
{
using JsonObject = nlohmann::ordered_json;

constexpr double Kilo = 1e3;

std::string KilobytesOf(const SceneItem& item)
{
  return FixedText(static_cast<double>(item.Bytes) / Kilo, 1) + " kB";
}

std::string MillisecondsOf(const SceneItem& item)
{
  return FixedText(Kilo * item.Seconds, 1) + " ms";
}

void AddRow(TextTable& table, const std::string& name, const std::string& purpose,
            const SceneItem& item)
{
  if (item.Is.empty())
  {
    table.AddRow({name, purpose, "", "", "not made: " + item.WhyNot});
    return;
  }
  table.AddRow({name, purpose, KilobytesOf(item), MillisecondsOf(item), item.Is});
}

// Sums over everything that was made of a scene.
struct Totals
{
  std::size_t Read = 0;
  std::size_t Touched = 0;
  SceneItem Reading;
  SceneItem Contacts;

  explicit Totals(const SceneAccount& account)
  {
    for (const SceneFileAccount& file : account.Files)
    {
      Add(file.Reading, this->Read, this->Reading);
    }
    for (const SceneStructureAccount& structure : account.Structures)
    {
      Add(structure.Contact, this->Touched, this->Contacts);
    }
  }

private:
  static void Add(const SceneItem& item, std::size_t& count, SceneItem& sum)
  {
    count += item.Is.empty() ? 0 : 1;
    sum.Bytes += item.Is.empty() ? 0 : item.Bytes;
    sum.Seconds += item.Seconds;
  }
};

std::string TextOf(const SceneAccount& account)
{
  TextTable table;
  table.AlignRight({2, 3});
  for (const SceneFileAccount& file : account.Files)
  {
    const SceneItem& reading = file.Reading;
    table.AddRow({Printable(file.File.filename().string()), "read",
                  reading.Is.empty() ? "" : KilobytesOf(reading),
                  reading.Is.empty() ? "" : MillisecondsOf(reading),
                  reading.Is.empty() ? "not opened: " + reading.WhyNot : reading.Is});
  }
  for (const SceneStructureAccount& structure : account.Structures)
  {
    AddRow(table, Printable(structure.Name), "touch", structure.Contact);
  }
  AddRow(table, "servo", "touch", account.Servo);
  const Totals totals(account);
  const auto message =
      [](std::size_t count, std::size_t all, const std::string& what, const SceneItem& item)
  {
    return std::to_string(count) + " of " + std::to_string(all) + " " + what + ", " +
           KilobytesOf(item) + ", " + MillisecondsOf(item) + "\n";
  };
  return table.Text() + message(totals.Read, account.Files.size(), "files read", totals.Reading) +
         message(totals.Touched, account.Structures.size(), "structures touchable",
                 totals.Contacts);
}

JsonObject AsJson(const SceneItem& item)
{
  if (item.Is.empty())
  {
    return {{"made", false}, {"why_not", item.WhyNot}};
  }
  return {{"made", true}, {"is", item.Is}, {"bytes", item.Bytes}, {"seconds", item.Seconds}};
}

JsonObject SumAsJson(std::size_t count, const SceneItem& sum)
{
  return {{"made", count}, {"bytes", sum.Bytes}, {"seconds", sum.Seconds}};
}

JsonObject AsJson(const SceneAccount& account)
{
  JsonObject files = JsonObject::array();
  for (const SceneFileAccount& file : account.Files)
  {
    files.push_back({{"file", file.File.string()}, {"read", AsJson(file.Reading)}});
  }
  JsonObject structures = JsonObject::array();
  for (const SceneStructureAccount& structure : account.Structures)
  {
    structures.push_back({{"name", structure.Name},
                          {"file", structure.File.string()},
                          {"touch", AsJson(structure.Contact)}});
  }
  const Totals totals(account);
  return {{JsonSchemaKey, JsonSchemaVersion},
          {"files", files},
          {"structures", structures},
          {"servo", AsJson(account.Servo)},
          {"total",
           {{"read", SumAsJson(totals.Read, totals.Reading)},
            {"touch", SumAsJson(totals.Touched, totals.Contacts)}}}};
}
} // namespace

std::string SceneCommand::Examples() const
{
  return "  palpate scene explain knee.scene.json\n"
         "  palpate scene explain knee.scene.json --json";
}

void SceneCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("ACTION", this->Action, "Action: explain")
      ->required()
      ->check(CLI::IsMember({"explain"}));
  app.add_option("SCENE", this->Input, "A scene to touch (.scene.json)")
      ->required()
      ->check(FileType::Input("file", ".scene.json"));
  app.add_flag("--json", this->Json, "Print one JSON object");
}

int SceneCommand::Run(Console& console)
{
  const Interruption interruption;
  const SceneSettings settings = ReadScene(this->Input);
  BuiltScene made = BuildScene(settings, ProgressOn(console));
  made.Account.Servo = AccountForServo(made);
  console.EndProgress();
  for (const std::string& warning : made.Warnings)
  {
    console.Note(warning);
  }
  console.Output()
      << (this->Json
              ? AsJson(made.Account).dump(2, ' ', false, JsonObject::error_handler_t::replace) +
                    "\n"
              : TextOf(made.Account));
  return 0;
}
} // namespace palpate::cli
