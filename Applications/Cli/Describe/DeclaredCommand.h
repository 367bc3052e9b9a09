#pragma once

#include "DeclaredOption.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// A command of the command line with its options, as they were declared.
struct DeclaredCommand
{
  explicit DeclaredCommand(const CLI::App& app);

  std::string Name; ///< of the program for the program itself
  std::string Help;
  std::string Footer; ///< examples
  std::vector<DeclaredOption> Options;

  /// Whether 3D Slicer can run it as a module: it writes a file that the user chooses.
  bool IsModule() const;
};

/// The commands of a program.
std::vector<DeclaredCommand> DeclaredCommands(const CLI::App& root);
} // namespace palpate::cli
