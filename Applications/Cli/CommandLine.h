#pragma once

#include "Command.h"

#include <memory>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace palpate::cli
{
class Console;

/// The whole command line: commands, options, and the mapping of failures to an exit code and a
/// message. 0 is success, 1 a failure, 2 bad input or a bad command line; an interrupted command
/// gives Interruption::ExitCode.
class CommandLine
{
public:
  explicit CommandLine(std::vector<std::unique_ptr<Command>> commands);
  ~CommandLine();

  /// Parses `arguments` (without the program's name) and runs the command that they name.
  int Run(const std::vector<std::string>& arguments, Console& console);

private:
  int Parse(std::vector<std::string> arguments, Console& console);
  int RunParsed(Console& console);
  /// Message on the first unknown option or command, with the nearest known one; empty if all are
  /// known.
  std::string WhatIsUnknown() const;

  std::vector<std::unique_ptr<Command>> Commands;
  std::unique_ptr<CLI::App> App;
  bool Quiet = false;
  bool HasNoCache = false;
  bool IsForSlicer = false;
  bool IsAnonymous = false;
};
} // namespace palpate::cli
