#include "KuhnNeighborhood.h"

namespace palpate
{
namespace
{
using Links = std::array<unsigned, KuhnNeighbors>;

bool IsKuhnStep(const std::array<int, 3>& step)
{
  for (int n = 0; n < KuhnNeighbors; ++n)
  {
    if (KuhnStep(n) == step)
    {
      return true;
    }
  }
  return false;
}

// For each neighbour the set of neighbours next to it.
Links LinksOfNeighbors()
{
  Links links{};
  for (int a = 0; a < KuhnNeighbors; ++a)
  {
    for (int b = 0; b < KuhnNeighbors; ++b)
    {
      const std::array<int, 3> from = KuhnStep(a);
      const std::array<int, 3> to = KuhnStep(b);
      if (IsKuhnStep({to[0] - from[0], to[1] - from[1], to[2] - from[2]}))
      {
        links[static_cast<std::size_t>(a)] |= 1u << b;
      }
    }
  }
  return links;
}

// Whether a set of neighbours is one connected part; an empty set is not.
bool IsOnePart(unsigned set, const Links& links)
{
  unsigned reached = set & (~set + 1); // the lowest
  unsigned before = 0;
  while (reached != before)
  {
    before = reached;
    for (std::size_t n = 0; n < links.size(); ++n)
    {
      if ((before >> n & 1) != 0)
      {
        reached |= links[n] & set;
      }
    }
  }
  return set != 0 && reached == set;
}

// Of the simplices whose lowest corner is corner 0 of a cube: alternating sum of those whose
// corners are all in `corners`, a set of bits.
int EulerTerm(unsigned corners)
{
  if ((corners & 1) == 0)
  {
    return 0;
  }
  int sum = 1;
  for (unsigned a = 1; a < 8; ++a)
  {
    for (unsigned b = 0; b < 8 && (corners >> a & 1) != 0; ++b)
    {
      const bool isLonger = (a & b) == a && a != b && (corners >> b & 1) != 0;
      // Chains 0 < a (edges), 0 < a < b (triangles), and those that end at 7 after a one-axis a
      // and a two-axes b (tetrahedra).
      sum -= b == 0 ? 1 : 0;
      sum += isLonger ? 1 : 0;
      const bool isPath = isLonger && b != 7 && (corners >> 7 & 1) != 0;
      sum -= isPath ? 1 : 0;
    }
  }
  return sum;
}

std::array<signed char, 256> EulerTerms()
{
  std::array<signed char, 256> terms{};
  for (unsigned corners = 0; corners < terms.size(); ++corners)
  {
    terms[corners] = static_cast<signed char>(EulerTerm(corners));
  }
  return terms;
}
} // namespace

KuhnOffsets OffsetsOf(const ShapeGrid& grid)
{
  KuhnOffsets offsets{};
  const auto row = static_cast<std::ptrdiff_t>(grid.Offset(0, 1, 0));
  const auto slice = static_cast<std::ptrdiff_t>(grid.Offset(0, 0, 1));
  for (int n = 0; n < KuhnNeighbors; ++n)
  {
    const std::array<int, 3> step = KuhnStep(n);
    offsets[static_cast<std::size_t>(n)] = step[0] + step[1] * row + step[2] * slice;
  }
  return offsets;
}

const SimpleNodes& SimpleNodes::Get()
{
  static const SimpleNodes table;
  return table;
}

SimpleNodes::SimpleNodes()
{
  const Links links = LinksOfNeighbors();
  constexpr unsigned all = (1u << KuhnNeighbors) - 1;
  for (unsigned inside = 0; inside <= all; ++inside)
  {
    if (IsOnePart(inside, links) && IsOnePart(all & ~inside, links))
    {
      this->Bits[inside >> 6] |= std::uint64_t{1} << (inside & 63);
    }
  }
}

long long EulerCharacteristic(const ShapeGrid& grid, const std::vector<unsigned char>& inside)
{
  static const std::array<signed char, 256> terms = EulerTerms();
  const std::size_t row = grid.Offset(0, 1, 0);
  const std::size_t slice = grid.Offset(0, 0, 1);
  long long sum = 0;
  for (std::size_t at = 0; at + slice + row + 1 < inside.size(); ++at)
  {
    const auto column = [&](std::size_t x)
    {
      return static_cast<unsigned>(inside[x] | inside[x + row] << 2 | inside[x + slice] << 4 |
                                   inside[x + slice + row] << 6);
    };
    sum += terms[column(at) | column(at + 1) << 1];
  }
  return sum;
}
} // namespace palpate
