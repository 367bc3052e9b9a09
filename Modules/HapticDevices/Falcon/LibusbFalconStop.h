#pragma once

#include "Status.h"

#include <string>

namespace palpate
{
/// Claims the Falcon at this bus path, sets its chip to the running firmware's rate, sends 0 N to
/// the board three times, and releases it. For a device that no program has claimed. Takes
/// milliseconds, or a second if the device takes no data.
Status StopFalcon(const std::string& busPath);
} // namespace palpate
