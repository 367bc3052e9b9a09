#include "ProgramVersion.h"

namespace palpate::cli
{
std::string ProgramVersion()
{
  return "palpate " PALPATE_VERSION;
}
} // namespace palpate::cli
