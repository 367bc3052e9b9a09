#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// Scenes, sessions, scripts, hand paths, states of drilling, and the tables of cohorts.
std::vector<FuzzTarget> SessionTargets();
} // namespace palpate::test
