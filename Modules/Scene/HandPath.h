#pragma once

#include "PalpateSceneModule.h"
#include "TouchScene.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace palpate
{
/// Where a hand wants to be over time: straight from place to place, still before the first and
/// after the last. World, mm.
class PALPATESCENE_EXPORT HandPath
{
public:
  struct Place
  {
    double Time; ///< s, rising
    Vector3 PointWorld;
  };

  HandPath() = default;
  explicit HandPath(std::vector<Place> places) : Places(std::move(places)) {}

  bool IsEmpty() const noexcept { return this->Places.empty(); }
  double Duration() const noexcept { return this->IsEmpty() ? 0.0 : this->Places.back().Time; }
  /// For a servo: neither allocates nor throws.
  Vector3 At(double time) const noexcept;
  const std::vector<Place>& List() const noexcept { return this->Places; }

private:
  std::vector<Place> Places;
};

/// Reads "time_s,x_mm,y_mm,z_mm" a line, after a line of these names. Throws InputError.
PALPATESCENE_EXPORT HandPath ReadHandPath(const std::filesystem::path& path);

/// A way round everything that a scene lets be touched: along a spiral from pole to pole, `depth`
/// mm below where the tool first touches, at `speed` mm/s, and off again. Parts of the spiral that
/// meet nothing lead round the outside. Refuses a scene that cannot be felt.
PALPATESCENE_EXPORT Status SweepOf(const TouchScene& scene, double depth, double speed,
                                   HandPath& path);

/// How a scene is pressed here and there.
struct HandPresses
{
  int Count = 24;         ///< directions from the scene's middle, chosen by the seed
  std::uint64_t Seed = 1; ///< equal seeds press the same places
  double Depth = 2.0;     ///< mm below where the tool first touches
  double Aside = 5.0;     ///< mm along the surface there, and from outside to there
  double Speed = 50.0;    ///< mm/s
};

/// In, along and out again at each of the places; directions that meet nothing are left out.
/// Refuses a scene that cannot be felt.
PALPATESCENE_EXPORT Status PressesOf(const TouchScene& scene, const HandPresses& presses,
                                     HandPath& path);
} // namespace palpate
