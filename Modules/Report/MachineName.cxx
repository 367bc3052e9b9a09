#include "MachineName.h"

#include <fstream>

namespace palpate
{
std::string MachineName()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t value = line.find(": ");
    if (line.rfind("model name", 0) == 0 && value != std::string::npos)
    {
      return line.substr(value + 2);
    }
  }
  return "an unknown processor";
}
} // namespace palpate
