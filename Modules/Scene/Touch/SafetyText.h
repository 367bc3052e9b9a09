#pragma once

#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <string>

namespace palpate
{
/// What the safety chain does, in one or two sentences for the person at the device.
PALPATESCENE_EXPORT std::string SafetyText(const TouchState& state);
} // namespace palpate
