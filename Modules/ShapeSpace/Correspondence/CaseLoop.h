#pragma once

#include <cstddef>
#include <functional>

namespace palpate
{
/// Calls `work` with 0 to `count` - 1, each once, on several threads; 0 threads: one per processor.
/// What one call computes must not depend on another.
void ForEachCase(std::size_t count, int threads, const std::function<void(std::size_t)>& work);
} // namespace palpate
