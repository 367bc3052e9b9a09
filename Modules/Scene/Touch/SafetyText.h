#pragma once

#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <string>

namespace palpate
{
/// State of the safety chain, in one or two sentences for the user.
PALPATESCENE_EXPORT std::string SafetyText(const TouchState& state);
} // namespace palpate
