#pragma once

#include "Status.h"

#include <string>

namespace palpate
{
/// Claims the Falcon at this bus path, sets its chip to the running firmware's rate, tells the
/// board 0 N three times, and lets it go. For a device that nobody has. It takes milliseconds, and
/// a second where the device takes no data.
Status StopFalcon(const std::string& busPath);
} // namespace palpate
