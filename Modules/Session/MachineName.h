#pragma once

#include "PalpateSessionModule.h"

#include <string>

namespace palpate
{
/// The processor's name as the system states it, or "an unknown processor".
PALPATESESSION_EXPORT std::string MachineName();
} // namespace palpate
