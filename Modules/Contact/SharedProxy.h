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
/// multipliers of a structure's constraints are its part of the way from hand to proxy. As long as
/// the proxy has not arrived, they lead elsewhere: what lacks is shared by the pushes, also of the
/// last tick if nothing pushes while the tool tips over. So the whole is the gradient of the
/// coupling's energy (RigidProxy) in every tick, and steps of the proxy only lower that.
///
/// A structure that contains the tool where it begins is passed through until the tool has left it.
class SharedProxy
{
public:
  /// `gyration` (mm): how much a turn counts as a shift.
  SharedProxy(const ToolSkeleton& tool, double gyration) : Proxy(tool, gyration) {}

  /// Without the structures.
  std::size_t Bytes() const noexcept;
  /// Adds a structure; returns its number, which counts from 0.
  std::size_t Add(std::unique_ptr<ToolGaps> gaps);

  /// Begins at this pose, among the `count` structures of these numbers.
  void Begin(const ToolPose& pose, const std::uint32_t* near, std::size_t count) noexcept;
  /// A tick, among these structures. No others hold the tool then.
  void Follow(const ToolPose& hand, const std::uint32_t* near, std::size_t count) noexcept;
  /// Whether the tool passes through a structure, which contains it.
  bool Passes(std::size_t structure) const noexcept { return this->Members[structure].IsPassed; }

  /// mm: the part of its share's way from the hand that is due to what cuts of the tool.
  const Vector3& CutOffset(std::size_t structure) const noexcept
  {
    return this->Members[structure].CutOffset;
  }

  /// Uses another version of a drilled structure from now on; see ContactTracker.
  void UseSolid(std::size_t structure, const FieldSolid& solid) noexcept
  {
    this->Members[structure].Gaps->UseSolid(solid);
  }
  bool CanBeDrilled(std::size_t structure) const noexcept
  {
    return this->Members[structure].Gaps->CanBeDrilled();
  }
  /// A structure may have grown: it is passed through if it contains the tool now.
  void AskAgain(std::size_t structure) noexcept
  {
    Member& member = this->Members[structure];
    member.IsPassed = !member.Gaps->IsFreeAt(this->Proxy.Pose());
  }

  const ToolPose& Pose() const noexcept { return this->Proxy.Pose(); }
  double Gyration() const noexcept { return this->Proxy.Gyration(); }
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
    double Part = 0.0; // of all pushes
    Contact Share;
    Vector3 CutOffset = Vector3::Zero();
  };

  ToolWrench LackOf(const ToolPose& hand) const noexcept;
  void TakePart(std::size_t structure, bool hasArrived, double pushes) noexcept;
  void Tell(std::size_t structure, const ToolPose& hand, bool hasArrived,
            const ToolWrench& lack) noexcept;

  RigidProxy Proxy;
  std::vector<Member> Members;
};
} // namespace palpate
