#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// Models that yield; what is read is also touched.
std::vector<FuzzTarget> ElasticTargets();
} // namespace palpate::test
