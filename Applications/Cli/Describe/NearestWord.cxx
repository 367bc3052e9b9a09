#include "NearestWord.h"

#include <algorithm>

namespace palpate::cli
{
namespace
{
constexpr std::size_t LongestWord = 64; // longer words are not mistyped options

// The optimal string alignment distance: Levenshtein's with exchanges of neighbours.
std::size_t Distance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> cost(a.size() + 1,
                                             std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = 0; i <= a.size(); ++i)
  {
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}
} // namespace

std::string NearestWord(const std::string& mistyped, const std::vector<std::string>& words)
{
  std::string nearest;
  if (mistyped.size() > LongestWord)
  {
    return nearest;
  }
  std::size_t least = std::max<std::size_t>(1, mistyped.size() / 3) + 1;
  for (const std::string& word : words)
  {
    const std::size_t distance = Distance(mistyped, word);
    if (distance < least)
    {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}
} // namespace palpate::cli
