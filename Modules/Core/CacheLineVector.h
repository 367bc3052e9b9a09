#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace palpate
{
/// Allocates on cache lines, so that vectors of any width load without crossing one.
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

/// Numbers in one piece that begins a cache line, as kernels want them.
template <typename T>
using CacheLineVector = std::vector<T, CacheLineAllocator<T>>;
} // namespace palpate
