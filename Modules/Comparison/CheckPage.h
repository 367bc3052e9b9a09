#pragma once

#include "MaskChecks.h"

#include <string>

namespace palpate
{
/// `report.html`: a table of all structures, the worst first, and a picture of each that is not
/// plausible, with its place marked.
std::string CheckPage(const MaskChecks& checks);
} // namespace palpate
