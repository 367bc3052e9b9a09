#pragma once

#include "CutSweep.h"
#include "NodeBox.h"
#include "RemovedDistances.h"

#include <array>
#include <memory>
#include <vector>

namespace palpate
{
/// A state of removal under construction: cuts on top of a previous state, which does not change.
/// Only the first cut of a block copies it. Not thread-safe.
class RemovalStroke
{
public:
  using Nodes = std::array<float, RemovedDistances::NodesOfBlock>;

  /// `forbidden` has the same grid and band: the volume removed in it is never cut. nullptr:
  /// everything may be.
  explicit RemovalStroke(std::shared_ptr<const RemovedDistances> before,
                         std::shared_ptr<const RemovedDistances> forbidden = nullptr);

  /// Removes the volume of `sweep`. `changed` receives boxes that contain the nodes whose distance
  /// has changed, one for each block, in memory order.
  void Cut(const CutSweep& sweep, std::vector<NodeBox>& changed);
  /// Fills a block that is not stored yet. Returns false if `corner` is not one of the grid, or the
  /// block is stored.
  bool Set(const RemovedDistances::Corner& corner, const Nodes& distances);
  /// Current state, valid until the next cut.
  const RemovedDistances& Now() const noexcept { return *this->Working; }
  bool IsEmpty() const noexcept { return !this->IsChanged; }

  const std::shared_ptr<const RemovedDistances>& Before() const noexcept { return this->Start; }
  /// The new state, which is the previous object if nothing has changed. The next stroke starts
  /// from it.
  std::shared_ptr<const RemovedDistances> Finish();

  /// `removed` without `forbidden`; the same object if nothing of it is forbidden.
  static std::shared_ptr<const RemovedDistances>
  Without(const std::shared_ptr<const RemovedDistances>& forbidden,
          const std::shared_ptr<const RemovedDistances>& removed);

private:
  using Block = RemovedDistances::Block;
  using Corner = RemovedDistances::Corner;

  bool MayChange(const Corner& corner, const CutSweep& sweep, const Block* block) const noexcept;
  // The sphere of the last cut, and where it ended.
  struct Sphere
  {
    double Radius = 0.0;
    Vector3 EndWorld = Vector3::Zero();
  };

  std::array<int, 3> NodesInGrid(const Corner& corner) const noexcept;
  void FillUntouched(const Corner& corner, Nodes& distances) const;
  template <typename Rows>
  void CutWith(Rows& rows, const CutSweep& sweep, std::vector<NodeBox>& changed);
  template <typename Rows>
  bool CutBlock(const Corner& corner, Rows& rows, NodeBox& changed);
  Block& OwnBlock(const Corner& corner);
  void Begin();

  std::shared_ptr<const RemovedDistances> Start;
  std::shared_ptr<const RemovedDistances> Forbidden;
  std::shared_ptr<RemovedDistances> Working;
  bool IsChanged = false;
  Sphere Last;
};
} // namespace palpate
