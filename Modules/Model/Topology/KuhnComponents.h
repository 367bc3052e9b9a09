#pragma once

#include "ShapeField.h"

#include <vector>

namespace palpate
{
/// Nodes of one row that are on one side, and their component.
struct NodeRun
{
  int First; ///< along i
  int End;
  bool IsInside;
  int Component;
};

/// The parts of a set of nodes and of its complement, connected by the 14 neighbours of the
/// Freudenthal triangulation. Union-find over runs: linear in their number.
class KuhnComponents
{
public:
  /// `inside` has 1 for nodes inside and 0 for others.
  KuhnComponents(const ShapeGrid& grid, const std::vector<unsigned char>& inside);

  int Count() const { return static_cast<int>(this->NodeCounts.size()); }
  bool IsInside(int component) const
  {
    return this->Inside[static_cast<std::size_t>(component)] != 0;
  }
  long long Nodes(int component) const
  {
    return this->NodeCounts[static_cast<std::size_t>(component)];
  }
  /// Of a node. Components are numbered in the order of their first nodes.
  int At(std::size_t offset) const;

  /// Calls visit(offset of the first node, number of nodes, component) for each run, in order.
  template <typename Visitor>
  void VisitRuns(const Visitor& visit) const
  {
    for (std::size_t row = 0; row + 1 < this->RowStarts.size(); ++row)
    {
      for (std::size_t run = this->RowStarts[row]; run < this->RowStarts[row + 1]; ++run)
      {
        const NodeRun& nodes = this->Runs[run];
        visit(row * this->RowLength + static_cast<std::size_t>(nodes.First),
              nodes.End - nodes.First, nodes.Component);
      }
    }
  }

private:
  void FindRuns(const std::vector<unsigned char>& inside);
  int Root(int run);
  void JoinRows(std::size_t row, std::size_t next);
  void Number();

  std::size_t RowLength;
  std::vector<NodeRun> Runs;
  std::vector<std::size_t> RowStarts{0}; // of each row's runs
  std::vector<int> Parents;              // of runs, until numbered
  std::vector<long long> NodeCounts;
  std::vector<unsigned char> Inside;
};
} // namespace palpate
