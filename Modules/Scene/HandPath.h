#pragma once

#include "PalpateSceneModule.h"
#include "TouchScene.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace palpate
{
/// Target position of a hand over time: linear between places, constant before the first and after
/// the last. World, mm.
class PALPATESCENE_EXPORT HandPath
{
public:
  struct Place
  {
    double Time; ///< s, increasing
    Vector3 PointWorld;
  };

  HandPath() = default;
  explicit HandPath(std::vector<Place> places) : Places(std::move(places)) {}

  bool IsEmpty() const noexcept { return this->Places.empty(); }
  double Duration() const noexcept { return this->IsEmpty() ? 0.0 : this->Places.back().Time; }
  /// Neither allocates nor throws.
  Vector3 At(double time) const noexcept;
  const std::vector<Place>& List() const noexcept { return this->Places; }

private:
  std::vector<Place> Places;
};

/// Reads a CSV file with the columns time_s,x_mm,y_mm,z_mm, named in its first line. Throws
/// InputError.
PALPATESCENE_EXPORT HandPath ReadHandPath(const std::filesystem::path& path);

/// A path round all touchable structures of a scene: along a spiral from pole to pole, `depth` mm
/// below the first contact of the tool, at `speed` mm/s, and off again. Parts of the spiral that
/// meet no structure pass outside. Ends early once it takes at least `longest` seconds, since with
/// a large tool each place takes much time to find. Fails if the scene cannot be touched.
PALPATESCENE_EXPORT Status SweepOf(const TouchScene& scene, double depth, double speed,
                                   double longest, HandPath& path);

/// Presses into a scene at seeded places.
struct HandPresses
{
  int Count = 24;         ///< random directions from the scene's centre
  std::uint64_t Seed = 1; ///< equal seeds give the same places
  double Depth = 2.0;     ///< mm below the first contact of the tool
  double Aside = 5.0;     ///< mm along the surface at depth, and of approach and retreat
  double Speed = 50.0;    ///< mm/s
};

/// Moves in, along and out at each place; directions that meet no structure are skipped. Fails if
/// the scene cannot be touched.
PALPATESCENE_EXPORT Status PressesOf(const TouchScene& scene, const HandPresses& presses,
                                     HandPath& path);
} // namespace palpate
