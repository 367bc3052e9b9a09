#pragma once

#include "ContactModel.h"
#include "FacetTree.h"

#include <memory>
#include <vector>

namespace palpate
{
/// A structure whose surface is a closed triangle mesh: the baseline for comparisons. Supports
/// spherical tools.
class FacetContactModel final : public ContactModel
{
public:
  /// Fails as FacetTree::Make. Corners are indices of points.
  static Status Make(const std::vector<Vector3>& pointsWorld,
                     const std::vector<FacetTree::Triangle>& triangles,
                     std::shared_ptr<const ContactModel>& contact);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Tree->BoundsWorld(); }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  Status MakeGaps(const ToolShape& tool, const SurfaceFriction& friction,
                  std::unique_ptr<ToolGaps>& gaps) const override;
  std::size_t Bytes() const noexcept override { return this->Tree->Bytes(); }

private:
  explicit FacetContactModel(std::shared_ptr<const FacetTree> tree) : Tree(std::move(tree)) {}

  std::shared_ptr<const FacetTree> Tree;
};
} // namespace palpate
