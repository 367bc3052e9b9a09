#pragma once

#include "DeclaredCommand.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// Completion scripts of a command line with sub-commands, made from what is declared.
class CompletionScript
{
public:
  explicit CompletionScript(const CLI::App& root);

  std::string Bash() const;
  std::string Zsh() const;
  std::string Fish() const;

private:
  /// Lines of the bash case statement: a command's words, and the values of its options.
  static std::string BashWords(const DeclaredCommand& command);
  static std::string BashValues(const DeclaredCommand& command);
  const DeclaredCommand& Program() const { return this->Commands.front(); }

  std::vector<DeclaredCommand> Commands; ///< the program itself first
};
} // namespace palpate::cli
