#pragma once

#include <cstddef>
#include <cstdint>

/// Limits of memory and time for one input. They depend on its size, not on what its header claims.
namespace palpate::test::InputLimits
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// Overhead of the sanitizers: checks, shadow memory, quarantine.
constexpr double TimeFactor = 10.0;
constexpr std::uint64_t MemoryFactor = 4;
#else
constexpr double TimeFactor = 1.0;
constexpr std::uint64_t MemoryFactor = 1;
#endif

/// Longer inputs are truncated. Enough for nesting that overflows a stack of 8 MB.
constexpr std::size_t LargestInput = std::size_t{256} << 10;
/// Buffers and tables of the libraries that do not depend on the input; any desktop has that much.
constexpr std::uint64_t FixedBytes = std::uint64_t{64} << 20;
/// Deflate compresses by at most 1,032:1.
constexpr std::uint64_t BytesPerByte = 1100;
/// Address space, which only protects the machine: stacks and arenas of threads reserve addresses
/// that they never use.
constexpr std::uint64_t Addresses = std::uint64_t{2} << 30;
/// Processor time for each part of the input, complete or not.
constexpr double SecondsPerPart = 1.0;
constexpr std::size_t Part = std::size_t{64} << 10;
/// Wall-clock limit, for waits that take no processor time.
constexpr unsigned HangSeconds = 60;

constexpr double Seconds(std::size_t inputSize)
{
  return TimeFactor * SecondsPerPart * static_cast<double>(1 + inputSize / Part);
}
constexpr std::uint64_t Bytes(std::size_t inputSize)
{
  return MemoryFactor * (FixedBytes + BytesPerByte * inputSize);
}
} // namespace palpate::test::InputLimits
