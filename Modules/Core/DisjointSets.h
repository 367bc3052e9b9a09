#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace palpate
{
/// Sets of the numbers from 0, each a tree (Galler and Fischer, Communications of the ACM 7 (1964)
/// 301), whose root is its smallest number, whatever the order in which they were joined.
class DisjointSets
{
public:
  /// Each of `count` numbers is a set.
  explicit DisjointSets(std::size_t count) : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), std::size_t{0});
  }

  /// The smallest number of the set. Halves the path on its way.
  std::size_t Root(std::size_t i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  void Join(std::size_t a, std::size_t b)
  {
    a = this->Root(a);
    b = this->Root(b);
    this->Parents[a < b ? b : a] = a < b ? a : b;
  }

private:
  std::vector<std::size_t> Parents;
};
} // namespace palpate
