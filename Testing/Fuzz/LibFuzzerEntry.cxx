#include "FuzzTarget.h"
#include "InputError.h"
#include "InputLimits.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

// Entry points for libFuzzer. The environment variable PALPATE_FUZZ_TARGET names the target, whose
// mutations are used in addition to libFuzzer's.
extern "C"
{
  std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);
  int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
  std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                      unsigned seed);
}

namespace
{
using namespace palpate::test;

const FuzzTarget& Target()
{
  const char* name = std::getenv("PALPATE_FUZZ_TARGET");
  try
  {
    static const FuzzTarget& target = FindFuzzTarget(name == nullptr ? "" : name);
    return target;
  }
  catch (const std::invalid_argument& error)
  {
    std::cerr << "PALPATE_FUZZ_TARGET: " << error.what() << "\n";
    std::exit(2);
  }
}

std::string Mutated(const std::uint8_t* data, std::size_t size, Random& random)
{
  static const std::vector<std::string> seeds = Target().MakeSeeds();
  std::string bytes(reinterpret_cast<const char*>(data), size);
  // libFuzzer starts with an empty input or a single line break.
  if (size < 2 || Below(random, 64) == 0)
  {
    bytes = Choose(seeds, random);
  }
  Target().Mutate(bytes, random);
  return bytes;
}
} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const InputReader read = Target().MakeReader();
  try
  {
    read({reinterpret_cast<const char*>(data), size});
  }
  catch (const palpate::InputError&)
  {
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                    unsigned seed)
{
  Random random(seed);
  if (size > 2 && Below(random, 2) == 0)
  {
    return LLVMFuzzerMutate(data, size, largest);
  }
  const std::string bytes = Mutated(data, size, random);
  const std::size_t count = std::min(bytes.size(), largest);
  std::memcpy(data, bytes.data(), count);
  return count;
}
