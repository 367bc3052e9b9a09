#include "AllocationCounter.h"

#include <cstdlib>
#include <new>

namespace
{
thread_local std::size_t Count = 0;

void* Allocate(std::size_t size, std::size_t alignment)
{
  ++Count;
  // aligned_alloc requires a multiple of the alignment.
  void* block = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (block == nullptr)
  {
    throw std::bad_alloc();
  }
  return block;
}
} // namespace

std::size_t palpate::test::AllocationCount() noexcept
{
  return Count;
}

// The other forms of the standard call one of these.
void* operator new(std::size_t size)
{
  return Allocate(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return Allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept
{
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept
{
  std::free(block);
}
void operator delete(void* block, std::align_val_t) noexcept
{
  std::free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
  std::free(block);
}
