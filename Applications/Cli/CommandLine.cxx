#include "CommandLine.h"

#include "AvailableMemory.h"
#include "Console.h"
#include "DeclaredCommand.h"
#include "ExceptionMessage.h"
#include "FileType.h"
#include "FilterRun.h"
#include "InputError.h"
#include "Interruption.h"
#include "NearestWord.h"
#include "NeutralInputs.h"
#include "OutputCheck.h"
#include "ProgramVersion.h"
#include "SlicerModule.h"
#include "SofteningCache.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <ostream>
#include <set>

namespace palpate::cli
{
namespace
{
constexpr int Success = 0;
constexpr int BadInput = 2;
constexpr int ParsedWithoutHelp = -1;

constexpr const char* SlicerFlag = "--slicer";
constexpr const char* OptionGroup = "Options";

std::string ProgramExamples()
{
  return "Examples:\n"
         "  palpate info mask.nii.gz                contents of a file\n"
         "  palpate fit mask.nii.gz --output case1  a model, its quality and a report\n"
         "  palpate fit --help                      options of one command";
}

// CLI11 ends some messages with a full stop or a line break, and starts some in lower case.
std::string AsClause(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && (message.back() == ' ' || message.back() == '.'))
  {
    message.pop_back();
  }
  return message;
}
// "--degre" of "--degre=5"; empty if the word is not an option, such as a negative number.
std::string OptionOf(const std::string& word)
{
  const bool isOption =
      word.size() > 1 && word[0] == '-' && (word[1] == '-' || std::isalpha(word[1]) != 0);
  return isOption ? word.substr(0, word.find('=')) : std::string();
}

// "--max-degree" of "--max_degree", for which 3D Slicer's descriptions have no hyphen.
void ReadUnderscoresAsHyphens(std::vector<std::string>& arguments)
{
  for (std::string& word : arguments)
  {
    if (word.rfind("--", 0) == 0)
    {
      const auto end = word.begin() + static_cast<std::ptrdiff_t>(OptionOf(word).size());
      std::replace(word.begin(), end, '_', '-');
    }
  }
}

// --xml answers before required options are missed, like --help.
void DeclareDescription(CLI::App& app)
{
  app.add_flag_callback(
         "--xml",
         [&app]
         { throw CLI::CallForVersion(SlicerModule(DeclaredCommand(app), VersionNumber()), 0); },
         "Print 3D Slicer's description of this command and exit")
      ->trigger_on_parse();
}

// Whether results of a command name its inputs; a cohort's cases are renamed by the command.
bool NamesInputs(const std::string& command)
{
  static const std::set<std::string> commands{
      "fit",   "compare",  "relate",   "mesh",  "evaluate", "convert", "soften",
      "touch", "tradeoff", "register", "check", "complete", "measure", "correct"};
  return commands.count(command) > 0;
}

void DeclareAnonymous(CLI::App& app, bool& isAnonymous)
{
  CLI::Option* flag =
      app.add_flag("--anonymous", isAnonymous,
                   "Number the inputs in results instead of naming their files: input-1, and "
                   "case-001 of a folder, in the order of names");
  for (const char* ofNames : {"--manifest", "--case", "--pairs"})
  {
    if (CLI::Option* option = app.get_option_no_throw(ofNames))
    {
      flag->excludes(option);
    }
  }
}

// From here on the command knows its inputs by neutral names.
void HideNames(CLI::App& command, NeutralInputs& names)
{
  for (CLI::Option* option : command.get_options())
  {
    const std::optional<FileType::Declared> type = FileType::Of(*option);
    if (!type || type->IsOutput || option->count() == 0)
    {
      continue;
    }
    const std::vector<std::string> inputs = option->results();
    option->clear();
    for (const std::string& input : inputs)
    {
      option->add_result(names.Of(input).string());
    }
    option->run_callback();
  }
}

// The same headings by all versions of CLI11, and examples as they were written: from 2.5 on it has
// headings in capitals and fills the examples' lines.
void ArrangeHelp(CLI::App& app)
{
  app.option_defaults()->group(OptionGroup);
  app.get_help_ptr()->group(OptionGroup);
  app.group("Subcommands");
  app.get_formatter()->label("POSITIONALS", "Positionals");
#if CLI11_VERSION_MAJOR > 2 || CLI11_VERSION_MINOR >= 5
  app.get_formatter()->enable_footer_formatting(false);
#endif
}

std::vector<std::string> OptionsOf(const std::vector<const CLI::App*>& apps)
{
  std::vector<std::string> names;
  for (const CLI::App* app : apps)
  {
    for (const CLI::Option* option : app->get_options())
    {
      for (const std::string& name : option->get_lnames())
      {
        names.push_back("--" + name);
      }
    }
  }
  return names;
}

std::string UnknownWord(const std::string& kind, const std::string& word,
                        const std::vector<std::string>& known)
{
  const std::string nearest = NearestWord(word, known);
  return "unknown " + kind + " '" + word + "'" +
         (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)");
}
} // namespace

CommandLine::CommandLine(std::vector<std::unique_ptr<Command>> commands)
    : Commands(std::move(commands)),
      App(std::make_unique<CLI::App>(
          "From segmentations to spherical-harmonic organ models: fit, measure, draw.", "palpate"))
{
  ArrangeHelp(*this->App);
  this->App->set_version_flag("--version", ProgramVersion());
  this->App->add_flag("--quiet", this->Quiet,
                      "Suppress notes and progress; results and errors are still printed");
  this->App->add_flag("--no-cache", this->HasNoCache,
                      "Neither read nor keep results in the user's cache folder (organs that "
                      "yield)");
  this->App->add_flag(SlicerFlag, this->IsForSlicer,
                      "For calls by 3D Slicer: prints progress on standard output in its format, "
                      "and reads underscores in names of options as hyphens");
  this->App->footer(ProgramExamples());
  this->App->require_subcommand(1);
  for (const auto& command : this->Commands)
  {
    CLI::App* sub = this->App->add_subcommand(command->Name(), command->Summary());
    sub->get_help_ptr()->group(OptionGroup); // made before the defaults are inherited
    // --quiet and --no-cache may also follow the command.
    sub->fallthrough();
    sub->footer("Examples:\n" + command->Examples());
    command->DeclareOptions(*sub);
    if (NamesInputs(command->Name()))
    {
      DeclareAnonymous(*sub, this->IsAnonymous);
    }
    if (DeclaredCommand(*sub).IsModule())
    {
      DeclareDescription(*sub);
    }
  }
}

CommandLine::~CommandLine() = default;

int CommandLine::Run(const std::vector<std::string>& arguments, Console& console)
{
  const int parsed = this->Parse(arguments, console);
  if (parsed != ParsedWithoutHelp)
  {
    return parsed;
  }
  console.SetQuiet(this->Quiet);
  if (this->HasNoCache)
  {
    SofteningCache::UseInProcess({});
  }
  if (this->IsForSlicer)
  {
    console.StartSlicerProgress("palpate " + this->App->get_subcommands().front()->get_name());
  }
  const int code = this->RunParsed(console);
  console.EndProgress();
  console.EndSlicerProgress();
  console.Output().flush();
  if (code == Success && !console.Output())
  {
    console.Error("the results could not be written to standard output; is its disk full?");
    return EXIT_FAILURE;
  }
  return code;
}

int CommandLine::Parse(std::vector<std::string> arguments, Console& console)
{
  if (std::find(arguments.begin(), arguments.end(), SlicerFlag) != arguments.end())
  {
    ReadUnderscoresAsHyphens(arguments);
  }
  // CLI11 consumes a vector from its end.
  std::reverse(arguments.begin(), arguments.end());
  try
  {
    this->App->parse(std::move(arguments));
    return ParsedWithoutHelp;
  }
  catch (const CLI::ParseError& error)
  {
    const auto chosen = this->App->get_subcommands();
    const std::string unknown = this->WhatIsUnknown();
    const bool isAsked = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    // For an unknown command, CLI11 would print the program's help: report the command instead.
    if (isAsked && (unknown.empty() || !chosen.empty()))
    {
      return this->App->exit(error, console.Output(), console.Output());
    }
    const std::string subject =
        chosen.empty() ? "palpate" : "palpate " + chosen.front()->get_name();
    console.Error((unknown.empty() ? AsClause(error.what()) : unknown) + "; see " + subject +
                  " --help");
    return BadInput;
  }
}

// Reported before a missing required option, which the mistyped word (--ouput) may explain.
std::string CommandLine::WhatIsUnknown() const
{
  const auto chosen = this->App->get_subcommands();
  std::vector<const CLI::App*> apps{this->App.get()};
  apps.insert(apps.end(), chosen.begin(), chosen.end());
  const std::vector<std::string> words = this->App->remaining(true);
  for (const std::string& word : words)
  {
    if (const std::string option = OptionOf(word); !option.empty())
    {
      return UnknownWord("option", option, OptionsOf(apps));
    }
  }
  if (!chosen.empty() || words.empty())
  {
    return {};
  }
  std::vector<std::string> names;
  for (const auto& command : this->Commands)
  {
    names.push_back(command->Name());
  }
  return UnknownWord("command", words.front(), names);
}

int CommandLine::RunParsed(Console& console)
{
  const std::string name = this->App->get_subcommands().front()->get_name();
  const auto command = std::find_if(this->Commands.begin(), this->Commands.end(),
                                    [&](const auto& c) { return c->Name() == name; });
  try
  {
    CLI::App& chosen = *this->App->get_subcommands().front();
    CheckOutputs(chosen);
    std::optional<NeutralInputs> names;
    if (this->IsAnonymous)
    {
      HideNames(chosen, names.emplace());
    }
    const int code = (*command)->Run(console);
    return Interruption::WasAsked() ? Interruption::ExitCode() : code;
  }
  catch (const Cancelled&)
  {
    console.Error("cancelled; what was finished is kept");
    return Interruption::ExitCode();
  }
  // A filter refuses its input: a structure that is too thin, for example.
  catch (const FilterError& error)
  {
    console.Error(error.what());
    return BadInput;
  }
  catch (const InputError& error)
  {
    console.Error(error.what());
    return BadInput;
  }
  catch (const std::exception& error)
  {
    console.Error(SaysMemoryIsShort(error)
                      ? "not enough memory for this; try a smaller image, or lower --degree or "
                        "--frequency where the command has them"
                      : AsClause(MessageOf(error)));
    return EXIT_FAILURE;
  }
}
} // namespace palpate::cli
