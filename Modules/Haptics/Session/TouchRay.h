#pragma once

#include "TouchScene.h"

#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// Where the tool of a scene comes to rest if it is moved along a line: what a hand that points,
/// such as a mouse, is led to. It follows the tool along the line with trackers of its own, so that
/// every kind of structure is met exactly as by touch. For one thread; queries allocate a
/// structure's tracker when the line first reaches it.
class TouchRay
{
public:
  struct Rest
  {
    Vector3 ToolWorld = Vector3::Zero();    ///< mm, of the tool's origin, outside
    Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, out of the structure
    int Structure = -1;                     ///< in the scene
  };

  explicit TouchRay(std::shared_ptr<const TouchScene> scene) : Scene(std::move(scene)) {}

  const std::shared_ptr<const TouchScene>& Touched() const noexcept { return this->Scene; }
  /// The newest versions of drilled fields, by site (TouchStructure::Site), for the next query;
  /// null leaves a site as it was.
  void UseSolids(std::vector<std::shared_ptr<const FieldSolid>> solids);

  /// The first rest on the way from `from` to `to` (world, mm), within 1 % of the tool's radius or
  /// a hundredth of a step; nothing where the line meets no structure, or begins inside of one.
  std::optional<Rest> First(const Vector3& from, const Vector3& to);

  /// Whether the tool touches nothing at a place (world, mm).
  bool IsFree(const Vector3& toolWorld);

private:
  struct Way;
  ContactTracker* TrackerOf(std::size_t structure);
  std::optional<Rest> FirstOn(std::size_t structure, const Way& way);

  std::shared_ptr<const TouchScene> Scene;
  std::vector<std::unique_ptr<ContactTracker>> Trackers; // of those that were reached
  std::vector<bool> CannotBeTouched;
  std::vector<std::shared_ptr<const FieldSolid>> Solids;
};
} // namespace palpate
