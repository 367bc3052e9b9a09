#pragma once

#include "Contact.h"
#include "RigidProxy.h"
#include "ToolGaps.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// One tool of several balls among all structures of a scene: one proxy pose that enters none of
/// them, and each structure's share of what holds it up. The shares add up to the whole: the
/// multipliers of a structure's constraints are its part of the way from hand to proxy.
///
/// A structure that contains the tool where it begins is passed through until the tool has left it.
class SharedProxy
{
public:
  explicit SharedProxy(const ToolSkeleton& tool) : Proxy(tool) {}

  /// Adds a structure; returns its number, which counts from 0.
  std::size_t Add(std::unique_ptr<ToolGaps> gaps);

  /// Begins at this pose, among the `count` structures of these numbers.
  void Begin(const ToolPose& pose, const std::uint32_t* near, std::size_t count) noexcept;
  /// A tick, among these structures. No others hold the tool then.
  void Follow(const ToolPose& hand, const std::uint32_t* near, std::size_t count) noexcept;
  /// Whether the tool passes through a structure, which contains it.
  bool Passes(std::size_t structure) const noexcept { return this->Members[structure].IsPassed; }

  const ToolPose& Pose() const noexcept { return this->Proxy.Pose(); }
  /// A structure's part, in the last tick.
  const Contact& ShareOf(std::size_t structure) const noexcept
  {
    return this->Members[structure].Share;
  }

private:
  struct Member
  {
    std::unique_ptr<ToolGaps> Gaps;
    bool IsPassed = false;
    Contact Share;
  };

  void Tell(std::size_t structure, const ToolPose& hand, bool hasArrived) noexcept;

  RigidProxy Proxy;
  std::vector<Member> Members;
};
} // namespace palpate
