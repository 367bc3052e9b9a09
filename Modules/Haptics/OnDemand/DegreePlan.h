#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace palpate
{
/// A structure that is in memory only where the tool is near.
struct DegreeCandidate
{
  double Away = 0.0;     ///< mm, from the tool's centre to where the structure may be in its reach
  std::size_t Bytes = 0; ///< that it takes at hand
  bool IsAtHand = false;
};

/// What is to be done; the first come first.
struct DegreeChoice
{
  std::vector<std::size_t> Drop;  ///< farthest first
  std::vector<std::size_t> Bring; ///< nearest first
};

/// How far the tool may come until what is wanted is at hand, and what may be at hand at once.
struct DegreeBounds
{
  double Way = 0.0;     ///< mm
  double Stay = 0.0;    ///< mm by which another structure has to be nearer than one that is at hand
  std::size_t Room = 0; ///< bytes
};

/// Which structures are to be at hand: all within the way, if there is room enough. What is farther
/// stays as long as there is room, the farthest goes first. Where those within the way do not fit,
/// the lowest by `height(candidate)` (mm, how far the tool is from its surface) are taken.
DegreeChoice ChooseDegrees(const std::vector<DegreeCandidate>& candidates,
                           const DegreeBounds& bounds,
                           const std::function<double(std::size_t)>& height);
} // namespace palpate
