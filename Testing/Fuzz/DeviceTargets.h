#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// Recordings of touch, and what a Falcon sends or is given: replies, firmware, calibration.
std::vector<FuzzTarget> DeviceTargets();
} // namespace palpate::test
