#include "CommandLine.h"
#include "CommandRegistry.h"
#include "Console.h"
#include "SofteningCache.h"

#include <csignal>
#include <iostream>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

namespace
{
// What one step has freed the next one takes: memory that is given back to the system in between
// has to be cleared again, which is a tenth of a fit's time.
void KeepFreedMemory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}
} // namespace

int main(int argc, char* argv[])
{
  KeepFreedMemory();
  // A file that exceeds a size limit fails with a message, as on a full disk, and is written whole
  // or not at all.
  std::signal(SIGXFSZ, SIG_IGN);
  palpate::SofteningCache::UseInProcess(palpate::SofteningCache::UserFolder());
  palpate::cli::Console console(std::cout, std::cerr, isatty(STDERR_FILENO) == 1);
  palpate::cli::CommandLine line(palpate::cli::MakeCommands());
  return line.Run(std::vector<std::string>(argv + 1, argv + argc), console);
}
