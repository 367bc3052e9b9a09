#pragma once

#include "PalpateReportModule.h"

namespace palpate
{
/// Resident memory of this process, MiB; 0 if the system does not report it (Linux:
/// /proc/self/statm).
PALPATEREPORT_EXPORT double ResidentMebibytes();
} // namespace palpate
