#pragma once

#include <cstddef>
#include <cstdint>

/// What reading one input may take, by the size of the input and not by what it claims.
namespace palpate::test::InputLimits
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// The sanitizers' own checks, shadow and quarantine.
constexpr double TimeFactor = 10.0;
constexpr std::uint64_t MemoryFactor = 4;
#else
constexpr double TimeFactor = 1.0;
constexpr std::uint64_t MemoryFactor = 1;
#endif

/// Longer ones are cut. Enough for nesting that overflows a stack of 8 MB.
constexpr std::size_t LargestInput = std::size_t{256} << 10;
/// What libraries load and map when they are first used, and the frames and tables of formats that
/// are larger than a header says, up to what any desktop has to spare.
constexpr std::uint64_t FixedBytes = std::uint64_t{64} << 20;
/// Deflate packs at most 1,032 bytes into one.
constexpr std::uint64_t BytesPerByte = 1100;
/// Threads' stacks and arenas reserve addresses that they never use, so addresses are limited only
/// as far as a machine needs it.
constexpr std::uint64_t Addresses = std::uint64_t{2} << 30;
/// Of processor time, for every 64 kB that have begun.
constexpr double SecondsPerPart = 1.0;
constexpr std::size_t Part = std::size_t{64} << 10;
/// Of a wait that takes no processor time.
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
