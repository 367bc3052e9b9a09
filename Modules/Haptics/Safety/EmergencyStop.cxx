#include "EmergencyStop.h"

namespace palpate
{
std::atomic<bool> EmergencyStop::Wanted{false};
} // namespace palpate
