#pragma once

#include <cstdlib>

namespace palpate::test
{
/// Number of cases of a slow proof: all of them if the environment variable PALPATE_PROVE is set,
/// as by Utilities/prove.sh, otherwise a few.
inline int ProofCount(int few, int all)
{
  return std::getenv("PALPATE_PROVE") != nullptr ? all : few;
}
} // namespace palpate::test
