#include "CompletionCommand.h"

#include "CompletionScript.h"
#include "Console.h"

#include <CLI/CLI.hpp>
#include <ostream>

namespace palpate::cli
{
std::string CompletionCommand::Examples() const
{
  return "  source <(palpate completion bash)            for this bash\n"
         "  source <(palpate completion zsh)             for this zsh, after compinit\n"
         "  palpate completion fish | source             for this fish";
}

void CompletionCommand::DeclareOptions(CLI::App& app)
{
  this->Root = app.get_parent();
  app.add_option("SHELL", this->Shell, "Shell to complete for")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

int CompletionCommand::Run(Console& console)
{
  const CompletionScript script(*this->Root);
  if (this->Shell == "bash")
  {
    console.Output() << script.Bash();
  }
  else if (this->Shell == "zsh")
  {
    console.Output() << script.Zsh();
  }
  else
  {
    console.Output() << script.Fish();
  }
  return 0;
}
} // namespace palpate::cli
