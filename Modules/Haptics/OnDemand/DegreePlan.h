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
  std::size_t Missing = 0;        ///< bytes by which those that are within the way do not fit
};

/// Which structures are to be at hand where the tool may come as far as `way` (mm) until they are:
/// all within it, if `room` (bytes) is enough. What is farther stays as long as there is room, the
/// farthest goes first. Where those within the way do not fit, the lowest by `height(candidate)`
/// (mm, how far the tool is from its surface) are taken; what is at hand stays unless another one
/// is nearer by half of the way.
DegreeChoice ChooseDegrees(const std::vector<DegreeCandidate>& candidates, double way,
                           std::size_t room, const std::function<double(std::size_t)>& height);
} // namespace palpate
