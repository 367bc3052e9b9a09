#pragma once

#include <string>

namespace palpate::bench
{
/// The processor's name as the system states it, or "an unknown processor".
std::string MachineName();
} // namespace palpate::bench
