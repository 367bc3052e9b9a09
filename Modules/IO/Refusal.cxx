#include "Refusal.h"

#include "InputError.h"

#include <sstream>

namespace palpate
{
void Refuse(const std::filesystem::path& file, const std::string& fact, const std::string& wayOut)
{
  throw InputError(file.string() + " " + fact + "; " + wayOut + ".");
}

std::string NumberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
} // namespace palpate
