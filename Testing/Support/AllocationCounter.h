#pragma once

#include <cstddef>

namespace palpate::test
{
/// Number of allocations by this thread. A program that links AllocationCounter.cxx counts every
/// operator new.
std::size_t AllocationCount() noexcept;
} // namespace palpate::test
