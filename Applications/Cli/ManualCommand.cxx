#include "ManualCommand.h"

#include "Console.h"
#include "ManualPage.h"
#include "ProgramVersion.h"

#include <CLI/CLI.hpp>
#include <ostream>

namespace palpate::cli
{
std::string ManualCommand::Examples() const
{
  return "  palpate manual | man -l -                 read it\n"
         "  palpate manual > palpate.1                for a folder of manual pages";
}

void ManualCommand::DeclareOptions(CLI::App& app)
{
  this->Root = app.get_parent();
}

int ManualCommand::Run(Console& console)
{
  console.Output() << ManualPage(*this->Root, VersionNumber());
  return 0;
}
} // namespace palpate::cli
