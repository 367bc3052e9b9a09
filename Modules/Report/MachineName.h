#pragma once

#include "PalpateReportModule.h"

#include <string>

namespace palpate
{
/// The processor's name as the system states it, or "an unknown processor".
PALPATEREPORT_EXPORT std::string MachineName();
} // namespace palpate
