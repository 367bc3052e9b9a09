#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace palpate
{
/// Allocator aligned to cache lines, so that vector loads of any width stay within one line.
template <typename T>
struct CacheLineAllocator
{
  using value_type = T;
  static constexpr std::align_val_t Line{64};

  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) noexcept
  {
  }
  T* allocate(std::size_t count)
  {
    return static_cast<T*>(::operator new(count * sizeof(T), Line));
  }
  void deallocate(T* block, std::size_t) noexcept { ::operator delete(block, Line); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
  friend bool operator!=(const CacheLineAllocator&, const CacheLineAllocator&) { return false; }
};

/// Contiguous numbers that start on a cache line, as the kernels require.
template <typename T>
using CacheLineVector = std::vector<T, CacheLineAllocator<T>>;
} // namespace palpate
