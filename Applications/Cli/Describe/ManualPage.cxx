#include "ManualPage.h"

#include "DeclaredCommand.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace palpate::cli
{
namespace
{
// Escapes what roff would interpret; hyphens are kept as such, so that options can be copied.
std::string Roff(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    const bool startsLine = result.empty() || result.back() == '\n';
    result += startsLine && (c == '.' || c == '\'') ? "\\&" : "";
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return result;
}

std::string ValueOf(const DeclaredOption& option)
{
  std::string values;
  for (const std::string& value : option.Values)
  {
    values += (values.empty() ? "" : "|") + value;
  }
  return values.empty() ? option.Word : values;
}

std::string OptionText(const DeclaredOption& option)
{
  std::string names = option.Place;
  for (const std::string& name : option.Names)
  {
    names += (names.empty() || option.IsPositional() ? "" : ", ") + name;
  }
  std::ostringstream text;
  text << ".TP\n\\fB" << Roff(names) << "\\fR";
  if (option.TakesValue() && !option.IsPositional())
  {
    text << " \\fI" << Roff(ValueOf(option)) << "\\fR";
  }
  text << "\n" << Roff(option.Help) << ".";
  if (!option.Default.empty())
  {
    text << " Default: " << Roff(option.Default) << ".";
  }
  if (option.IsRequired)
  {
    text << " Required.";
  }
  text << "\n";
  return text.str();
}

std::string Synopsis(const DeclaredCommand& command)
{
  std::string text = "\\fBpalpate " + command.Name + "\\fR [\\fIOPTIONS\\fR]";
  for (const DeclaredOption& option : command.Options)
  {
    if (option.IsPositional())
    {
      const std::string name = "\\fI" + Roff(option.Place) + "\\fR" + (option.IsList ? "..." : "");
      text += option.IsRequired ? " " + name : " [" + name + "]";
    }
  }
  return text;
}

// Footers start with a line "Examples:", which is a heading here.
std::string Examples(const std::string& footer)
{
  const std::size_t line = footer.find('\n');
  return line == std::string::npos
             ? std::string()
             : ".PP\nExamples:\n.PP\n.nf\n" + Roff(footer.substr(line + 1)) + "\n.fi\n";
}
} // namespace

std::string ManualPage(const CLI::App& root, const std::string& version)
{
  const DeclaredCommand program(root);
  std::ostringstream page;
  page << ".TH PALPATE 1 \"\" \"palpate " << version << "\" \"User Commands\"\n"
       << ".SH NAME\npalpate, palpate\\-dicom\\-decoder, palpate\\-falcon\\-guard \\- "
          "spherical\\-harmonic organ models from segmentations\n"
       << ".SH SYNOPSIS\n\\fBpalpate\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n"
       << ".SH DESCRIPTION\n"
       << Roff(program.Help)
       << "\nResults go to standard output; notes, progress and errors to standard error.\n"
       << "palpate runs \\fBpalpate\\-dicom\\-decoder\\fR, which decodes compressed DICOM images, "
          "and \\fBpalpate\\-falcon\\-guard\\fR, which takes the force from a Falcon when the "
          "program dies; they are of no use alone.\n"
       << ".SH OPTIONS\nThese may also follow the command.\n";
  for (const DeclaredOption& option : program.Options)
  {
    page << OptionText(option);
  }
  page << Examples(program.Footer) << ".SH COMMANDS\n";
  for (const DeclaredCommand& command : DeclaredCommands(root))
  {
    page << ".SS " << command.Name << "\n"
         << Synopsis(command) << "\n.PP\n"
         << Roff(command.Help) << ".\n";
    for (const DeclaredOption& option : command.Options)
    {
      if (!option.HasName("--help"))
      {
        page << OptionText(option);
      }
    }
    page << Examples(command.Footer);
  }
  page << ".SH EXIT STATUS\n0: done. 1: something failed, or some of several cases did. "
          "2: a bad command line, or only bad input. A command that a signal ends returns 128 and "
          "the number of the signal.\n"
       << ".SH SEE ALSO\n\\fBpalpate\\-viewer\\fR(1)\n";
  return page.str();
}
} // namespace palpate::cli
