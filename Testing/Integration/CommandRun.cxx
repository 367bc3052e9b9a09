#include "CommandRun.h"

#include "StartedCommand.h"

namespace palpate::test
{
CommandRun RunCommand(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder)
{
  return StartedCommand(program, arguments, folder).Finish();
}

CommandRun RunPalpate(const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder)
{
  return RunCommand(PALPATE_PROGRAM, arguments, folder);
}
} // namespace palpate::test
