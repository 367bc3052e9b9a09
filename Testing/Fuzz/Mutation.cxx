#include "Mutation.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace palpate::test
{
namespace
{
struct Range
{
  std::size_t First;
  std::size_t Count;
};

Range PartOf(const std::string& bytes, std::size_t longest, Random& random)
{
  const std::size_t first = Below(random, bytes.size());
  return {first, 1 + Below(random, std::min(longest, bytes.size() - first))};
}

void FlipBytes(std::string& bytes, Random& random)
{
  for (std::size_t flips = 1 + Below(random, 4); flips > 0; --flips)
  {
    bytes[Below(random, bytes.size())] = static_cast<char>(random() % 256);
  }
}

void CutEnd(std::string& bytes, Random& random)
{
  bytes.resize(Below(random, bytes.size()));
}

void RepeatPart(std::string& bytes, Random& random)
{
  const Range part = PartOf(bytes, 4096, random);
  bytes.insert(part.First, bytes.substr(part.First, part.Count));
}

void RemovePart(std::string& bytes, Random& random)
{
  const Range part = PartOf(bytes, 64, random);
  bytes.erase(part.First, part.Count);
}

void CopyPart(std::string& bytes, Random& random)
{
  const Range part = PartOf(bytes, 64, random);
  const std::size_t target = Below(random, bytes.size() - part.Count + 1);
  bytes.replace(target, part.Count, bytes.substr(part.First, part.Count));
}

void AddBytes(std::string& bytes, Random& random)
{
  bytes.append(1 + Below(random, 2048), static_cast<char>(random() % 256));
}
} // namespace

std::size_t Below(Random& random, std::size_t count)
{
  return count == 0 ? 0 : random() % count;
}

Mutator OneOf(std::vector<Mutator> mutators)
{
  return [list = std::move(mutators)](std::string& bytes, Random& random)
  { Choose(list, random)(bytes, random); };
}

Mutator Behind(std::string mark, Mutator mutator)
{
  return [end = std::move(mark), change = std::move(mutator)](std::string& bytes, Random& random)
  {
    const std::size_t found = bytes.find(end);
    const std::size_t first = found == std::string::npos ? 0 : found + end.size();
    std::string rest = bytes.substr(first);
    change(rest, random);
    bytes.replace(first, std::string::npos, rest);
  };
}

void MutateBytes(std::string& bytes, Random& random)
{
  if (bytes.empty())
  {
    AddBytes(bytes, random);
    return;
  }
  static constexpr void (*Paths[])(std::string&, Random&) = {
      FlipBytes, FlipBytes, FlipBytes, CutEnd, RepeatPart, RemovePart, CopyPart, AddBytes};
  Choose(Paths, random)(bytes, random);
}

std::uint64_t OddInteger(std::uint64_t present, Random& random)
{
  // 46341 squared, 0x55555556 times 3, 0x40000001 times 4 and 1291 cubed just overflow 32 bits.
  static constexpr std::uint64_t Odd[] = {0,
                                          1,
                                          2,
                                          3,
                                          127,
                                          128,
                                          255,
                                          256,
                                          1291,
                                          32767,
                                          32768,
                                          46341,
                                          65535,
                                          65536,
                                          0x00FFFFFF,
                                          0x20000001,
                                          0x40000001,
                                          0x55555556,
                                          0x7FFFFFFF,
                                          0x80000000,
                                          0xFFFFFFFE,
                                          0xFFFFFFFF,
                                          0x100000000,
                                          0x2000000000000001,
                                          0x7FFFFFFFFFFFFFFF,
                                          0x8000000000000000,
                                          0xFFFFFFFFFFFFFFFF};
  switch (Below(random, 9))
  {
  case 0:
    return present + 1;
  case 1:
    return present - 1;
  case 2:
    return 2 * present;
  case 3:
    return std::uint64_t{0} - present;
  case 4:
    return random();
  default:
    return Choose(Odd, random);
  }
}

double OddReal(double present, Random& random)
{
  using Limits = std::numeric_limits<double>;
  static constexpr double Odd[] = {0.0,
                                   -0.0,
                                   1.0,
                                   -1.0,
                                   1e-6,
                                   1e6,
                                   2147483648.0,
                                   -2147483649.0,
                                   1.8446744073709552e19,
                                   1e30,
                                   -1e30,
                                   3.5e38,
                                   1e-40,
                                   1e300,
                                   -1e300,
                                   5e-324,
                                   Limits::infinity(),
                                   -Limits::infinity(),
                                   Limits::quiet_NaN()};
  switch (Below(random, 6))
  {
  case 0:
    return -present;
  case 1:
    return present * 1e6;
  case 2:
    return present * 1e-6;
  default:
    return Choose(Odd, random);
  }
}

std::string OddNumberText(Random& random)
{
  static const std::string Odd[] = {"0",
                                    "-0",
                                    "-1",
                                    "1",
                                    "2",
                                    "255",
                                    "256",
                                    "32768",
                                    "46341",
                                    "65536",
                                    "1000000",
                                    "2147483647",
                                    "2147483648",
                                    "-2147483648",
                                    "-2147483649",
                                    "4294967295",
                                    "4294967296",
                                    "4294967297",
                                    "9223372036854775807",
                                    "9223372036854775808",
                                    "-9223372036854775808",
                                    "18446744073709551615",
                                    "18446744073709551616",
                                    "0.5",
                                    "-0.0",
                                    "1e-400",
                                    "5e-324",
                                    "1e308",
                                    "-1e308",
                                    "1e400",
                                    "1e99999999999",
                                    "nan",
                                    "-nan",
                                    "inf",
                                    "-Infinity",
                                    "0x10",
                                    "0x1p1023",
                                    "1,5",
                                    "1.5.5",
                                    "1e",
                                    "+1",
                                    "--1",
                                    ".",
                                    "007",
                                    "1 ",
                                    ""};
  switch (Below(random, 12))
  {
  case 0:
    return std::string(1 + Below(random, 2000), '9');
  case 1:
    return "0." + std::string(1 + Below(random, 2000), '3');
  case 2:
    return std::to_string(random() % 100000);
  default:
    return Choose(Odd, random);
  }
}
} // namespace palpate::test
