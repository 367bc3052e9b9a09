#pragma once

#include "MomentKernel.h"

#include <string>
#include <vector>

namespace palpate::moments
{
/// The fastest kernel that this processor can run; asked of the processor once.
const Kernel& FastestKernel() noexcept;

struct NamedKernel
{
  std::string Name;
  const Kernel* Arithmetic;
};

/// Every kernel that this processor can run, for tests and benchmarks; "portable" comes first.
std::vector<NamedKernel> RunnableKernels();
} // namespace palpate::moments
