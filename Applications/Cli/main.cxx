#include "CommandLine.h"
#include "CommandRegistry.h"
#include "Console.h"
#include "SofteningCache.h"

#include <csignal>
#include <iostream>
#include <unistd.h>

int main(int argc, char* argv[])
{
  // A file that exceeds a size limit fails with a message, as on a full disk, and is written whole
  // or not at all.
  std::signal(SIGXFSZ, SIG_IGN);
  palpate::SofteningCache::UseInProcess(palpate::SofteningCache::UserFolder());
  palpate::cli::Console console(std::cout, std::cerr, isatty(STDERR_FILENO) == 1);
  palpate::cli::CommandLine line(palpate::cli::MakeCommands());
  return line.Run(std::vector<std::string>(argv + 1, argv + argc), console);
}
