#include "CommandLine.h"
#include "CommandRegistry.h"
#include "Console.h"

#include <iostream>
#include <unistd.h>

int main(int argc, char* argv[])
{
  palpate::cli::Console console(std::cout, std::cerr, isatty(STDERR_FILENO) == 1);
  palpate::cli::CommandLine line(palpate::cli::MakeCommands());
  return line.Run(std::vector<std::string>(argv + 1, argv + argc), console);
}
