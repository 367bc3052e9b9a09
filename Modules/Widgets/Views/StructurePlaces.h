#pragma once

#include "Segmentation.h"
#include "StudyState.h"

#include <map>
#include <memory>
#include <optional>
#include <set>

namespace palpate
{
/// Where the structures of a study are among the labels of its slices.
class StructurePlaces
{
public:
  /// `labels` may be null.
  void Take(const StudyState& state, const std::shared_ptr<const Segmentation>& labels);

  /// The structure of a label of the segmentation; 0 if there is none.
  int IdOf(int label) const;
  /// The visible structure at a point (world, mm), of several the one that is painted last; 0 if
  /// there is none.
  int At(const Vector3& pointWorld) const;
  /// A point in a structure, near its centroid (world, mm); none if it is no label of the
  /// segmentation. Measures all labels once.
  std::optional<Vector3> CenterOf(int id) const;

private:
  std::shared_ptr<const Segmentation> Labels;
  std::map<int, int> Ids; ///< by label
  std::set<int> Visible;
  mutable std::optional<std::map<int, Vector3>> Centers; ///< by label; none until asked for
};
} // namespace palpate
