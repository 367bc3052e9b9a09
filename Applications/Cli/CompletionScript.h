#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// Completion scripts of a command line with sub-commands. An option's fixed values are those of
/// its IsMember check.
class CompletionScript
{
public:
  explicit CompletionScript(const CLI::App& root);

  std::string Bash() const;
  std::string Zsh() const;
  std::string Fish() const;

private:
  struct Option
  {
    std::vector<std::string> Names; ///< with dashes; empty for a positional
    std::string Help;
    std::vector<std::string> Values;
    bool TakesValue;
  };
  struct Command
  {
    std::string Name; ///< empty for the program itself
    std::string Help;
    std::vector<Option> Options;
  };

  static Command Describe(const CLI::App& app);
  /// Lines of the bash case statement: a command's words, and the values of its options.
  static std::string BashWords(const Command& command);
  static std::string BashValues(const Command& command);
  const Command& Program() const { return this->Commands.front(); }

  std::vector<Command> Commands; ///< the program itself first
};
} // namespace palpate::cli
