#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// Touch recordings; Falcon replies, firmware and calibration.
std::vector<FuzzTarget> DeviceTargets();
} // namespace palpate::test
