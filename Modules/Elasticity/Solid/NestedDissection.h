#pragma once

#include "StarMesh.h"

#include <array>
#include <vector>

namespace palpate
{
/// An order in which the unknowns of a mesh are eliminated with little fill (nested dissection:
/// George, SIAM J. Numer. Anal. 10, 1973). Nodes with one value of a lattice coordinate separate
/// those with smaller values from those with larger ones; each of these two sets is separated in
/// the same way, and so on. A set comes before what separates it from the other.
class NestedDissection
{
public:
  /// Nodes at consecutive positions of the order: a separator, or a set that is not separated
  /// further. The two sets that a separator separates are the subtrees of `Before`; those that
  /// separate nothing have None there.
  struct Part
  {
    int First;
    int Count;
    std::array<int, 2> Before;
  };
  static constexpr int None = -1;

  explicit NestedDissection(const std::vector<StarMesh::Place>& places);

  /// The node at each position.
  const std::vector<int>& Order() const noexcept { return this->Nodes; }
  /// Each after those before it, in the order of their nodes. The last is the outermost separator.
  const std::vector<Part>& Parts() const noexcept { return this->Tree; }

private:
  int Split(const std::vector<StarMesh::Place>& places, int first, int end);

  std::vector<int> Nodes;
  std::vector<Part> Tree;
};
} // namespace palpate
