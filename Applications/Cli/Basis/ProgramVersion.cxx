#include "ProgramVersion.h"

namespace palpate::cli
{
std::string ProgramVersion()
{
  return "palpate " PALPATE_VERSION;
}

std::string VersionNumber()
{
  return PALPATE_VERSION;
}
} // namespace palpate::cli
