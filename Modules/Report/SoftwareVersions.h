#pragma once

#include "PalpateReportModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Names and versions of the program, the libraries that its numbers depend on, and the compiler.
PALPATEREPORT_EXPORT std::vector<std::pair<std::string, std::string>> SoftwareVersions();
} // namespace palpate
