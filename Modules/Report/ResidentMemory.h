#pragma once

#include "PalpateReportModule.h"

namespace palpate
{
/// MiB of this process that are in memory now; 0 where the system does not say (it is Linux's
/// /proc/self/statm that does).
PALPATEREPORT_EXPORT double ResidentMebibytes();
} // namespace palpate
