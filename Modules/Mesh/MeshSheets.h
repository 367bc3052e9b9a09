#pragma once

#include "EdgeRings.h"
#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// The sheets of a mesh, connected across edges of exactly two triangles, and its parts, connected
/// across any common edge. Numbered from 0 in the order of their first triangles; -1 for triangles
/// that EdgeRings leaves out. Linear time.
struct MeshSheets
{
  MeshSheets(const IndexedMesh& mesh, const EdgeRings& rings);

  std::vector<int> SheetOf; ///< of each triangle
  /// Whether a triangle has to be reversed to agree with the majority of its sheet.
  std::vector<char> IsTurned;
  std::vector<int> PartOf; ///< of each sheet
  int SheetCount = 0;
  int PartCount = 0;
  bool IsOrientable = true; ///< every sheet has two sides

private:
  void Flood(const IndexedMesh& mesh, const EdgeRings& rings, int first, std::vector<int>& stack);
  void KeepMajority(const EdgeRings& rings);
  void JoinParts(const EdgeRings& rings);
};
} // namespace palpate
