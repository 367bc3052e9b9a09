#pragma once

#include <cstddef>

namespace palpate::test
{
/// How often this thread has asked for memory. A program that links AllocationCounter.cxx counts
/// every operator new.
std::size_t AllocationCount() noexcept;
} // namespace palpate::test
