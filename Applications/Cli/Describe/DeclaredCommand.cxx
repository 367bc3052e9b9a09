#include "DeclaredCommand.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace palpate::cli
{
DeclaredCommand::DeclaredCommand(const CLI::App& app)
    : Name(app.get_name()), Help(app.get_description()), Footer(app.get_footer())
{
  for (const CLI::Option* option : app.get_options())
  {
    this->Options.emplace_back(*option);
  }
}

bool DeclaredCommand::IsModule() const
{
  return std::any_of(this->Options.begin(), this->Options.end(),
                     [](const DeclaredOption& option)
                     { return option.File && option.File->IsOutput; });
}

std::vector<DeclaredCommand> DeclaredCommands(const CLI::App& root)
{
  std::vector<DeclaredCommand> commands;
  for (const CLI::App* sub : root.get_subcommands([](const CLI::App*) { return true; }))
  {
    commands.emplace_back(*sub);
  }
  return commands;
}
} // namespace palpate::cli
