#include "ExceptionMessage.h"

#include "AvailableMemory.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace palpate
{
std::string MessageOf(const std::exception& problem)
{
  if (SaysMemoryIsShort(problem))
  {
    return "there is not enough memory for this; use a smaller image, degree or frequency";
  }
  if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&problem))
  {
    return file->path1().string() + " cannot be used (" + file->code().message() +
           "); check its name and its rights";
  }
  if (const auto* system = dynamic_cast<const std::system_error*>(&problem))
  {
    return "the system refused this (" + system->code().message() + ")";
  }
  const bool isOurs = dynamic_cast<const std::runtime_error*>(&problem) != nullptr &&
                      dynamic_cast<const std::range_error*>(&problem) == nullptr &&
                      dynamic_cast<const std::overflow_error*>(&problem) == nullptr;
  return isOurs ? problem.what()
                : "this failed within the program, for a reason that it does not know; please "
                  "report it with the input";
}
} // namespace palpate
