#pragma once

#include "FreePlace.h"
#include "PalpateTaskModule.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace palpate
{
/// Searches the free side of an organ for a nodule with one finger: sweeps a raster of places,
/// comes back to the hardest ones, and reports the hardest of them if it is noticeably harder than
/// most of the organ. It is blind: it knows only where it pressed and what it felt.
class PALPATETASK_EXPORT PalpationSearch
{
public:
  struct Technique
  {
    double Spacing = 5.0;   ///< of the raster, mm
    double Reach = 18.0;    ///< of the raster from the middle of the free side, mm
    int Sweeps = 2;         ///< presses of each place
    int Suspects = 3;       ///< places to come back to
    int Returns = 12;       ///< presses of each of them, which alone decide
    double Threshold = 1.0; ///< difference that is reported, just noticeable differences
  };
  struct Finding
  {
    FreePlace Place;
    double Contrast; ///< just noticeable differences above the median of all places
    double Usual;    ///< that median, N
  };
  /// Presses at a place and returns the force that was felt, N.
  using Press = std::function<double(const FreePlace& place)>;

  explicit PalpationSearch(const Technique& technique) : Way(technique) {}
  PalpationSearch() : PalpationSearch(Technique{}) {}

  /// The seed shifts and turns the raster, so that a nodule lies anywhere between its places.
  std::optional<Finding> Search(const Press& press, std::uint64_t seed) const;

  /// Square, of all places within reach.
  std::vector<FreePlace> Raster(std::uint64_t seed) const;

private:
  Technique Way;
};
} // namespace palpate
