#pragma once

#include "CutSweep.h"
#include "NodeBox.h"
#include "RemovedDistances.h"

#include <array>
#include <memory>
#include <vector>

namespace palpate
{
/// A state of what was removed in the making: cuts on top of the state before, which stays as it
/// is. Only the first cut of a block copies it. For one thread.
class RemovalStroke
{
public:
  using Nodes = std::array<float, RemovedDistances::NodesOfBlock>;

  /// `forbidden` is of the same grid and band: what it has as removed no cut removes. None: all may
  /// be.
  explicit RemovalStroke(std::shared_ptr<const RemovedDistances> before,
                         std::shared_ptr<const RemovedDistances> forbidden = nullptr);

  /// Removes all that `sweep` passes. `changed` gets boxes that hold the nodes of the grid whose
  /// distance is another one now, one for each block, in the order of memory.
  void Cut(const CutSweep& sweep, std::vector<NodeBox>& changed);
  /// Fills a block that is not kept yet. False where `corner` is none of the grid, or it is.
  bool Set(const RemovedDistances::Corner& corner, const Nodes& distances);
  /// As it is now, until the next cut.
  const RemovedDistances& Now() const noexcept { return *this->Working; }
  bool IsEmpty() const noexcept { return !this->IsChanged; }

  const std::shared_ptr<const RemovedDistances>& Before() const noexcept { return this->Start; }
  /// What has become of the state before, which is the same object where nothing has changed. From
  /// there the next stroke begins.
  std::shared_ptr<const RemovedDistances> Finish();

  /// `removed` without what is forbidden; the same object where that is all of it.
  static std::shared_ptr<const RemovedDistances>
  Without(const std::shared_ptr<const RemovedDistances>& forbidden,
          const std::shared_ptr<const RemovedDistances>& removed);

private:
  using Block = RemovedDistances::Block;
  using Corner = RemovedDistances::Corner;

  bool MayChange(const Corner& corner, const CutSweep& sweep, const Block* block) const noexcept;
  // The ball that was cut with last, and where it ended.
  struct Ball
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
  Ball Last;
};
} // namespace palpate
