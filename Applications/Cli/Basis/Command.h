#pragma once

#include <string>

namespace CLI
{
class App;
}

namespace palpate::cli
{
class Console;

/// One sub-command of `palpate`. It declares its options, then runs; it throws InputError for bad
/// input (exit code 2) and any other exception for a failure (exit code 1), and writes nothing to
/// standard streams except through the console.
class Command
{
public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  virtual std::string Name() const = 0;
  /// One line for the list of commands.
  virtual std::string Summary() const = 0;
  /// Example calls with explanations, shown at the end of --help.
  virtual std::string Examples() const = 0;
  virtual void DeclareOptions(CLI::App& app) = 0;
  /// Returns the exit code.
  virtual int Run(Console& console) = 0;
};
} // namespace palpate::cli
