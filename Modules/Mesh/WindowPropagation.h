#pragma once

#include "EdgeRings.h"
#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "NearestOnMesh.h"

#include <queue>
#include <utility>
#include <vector>

namespace palpate
{
/// The work of FindGeodesicDistances. A window is the part of an edge that straight lines reach
/// from a source, unfolded into the plane of the triangle behind the edge; sources are the start
/// and the points around which shortest paths can bend.
class WindowPropagation
{
public:
  explicit WindowPropagation(const IndexedMesh& mesh);

  /// Once. False if `progress` cancels.
  bool Run(const NearestOnMesh::Result& from, const KernelProgress& progress);
  const std::vector<double>& Distances() const noexcept { return this->Lengths; }

private:
  using Plane = Eigen::Vector2d;

  // In the frame of a half-edge: it runs along x from 0; its triangle lies above, the source below.
  struct Window
  {
    int HalfEdge; // of the triangle that is entered
    int Behind;   // end of the interval that lies next to the edge it came through: 0, 1; -1: none
    double First;
    double Last;
    Plane Source;
    double Offset; // length of the path up to the source, mm
  };
  // The best of the windows that see the point opposite of a half-edge, and where they look
  // through.
  struct Sight
  {
    double Length;
    double Place;
  };

  void Unfold();
  void FindBends();
  void StartIn(const NearestOnMesh::Result& from);
  void StartAt(int point);
  void Reach(int point, double length);
  void Add(const Window& window);
  bool IsUseless(const Window& window) const;
  void Propagate(const Window& window);
  void AddRight(const Window& window, bool seesApex);
  void AddLeft(const Window& window, bool seesApex);
  void AddBeyond(const Window& window, int left, const Plane& start, bool first, bool last);
  int Across(int halfEdge) const noexcept
  {
    return this->Rings.IsPair(halfEdge) ? this->Rings.Next(halfEdge) : -1;
  }
  // In the frame of the half-edge on an edge's other side.
  Plane Turned(int halfEdge, const Plane& place) const
  {
    return {this->EdgeLengths[halfEdge] - place[0], -place[1]};
  }

  const IndexedMesh& Mesh;
  EdgeRings Rings;
  std::vector<double> EdgeLengths;        // of half-edges
  std::vector<Plane> Apexes;              // the triangle's third point in each half-edge's frame
  std::vector<std::vector<int>> Opposite; // half-edges opposite of points
  std::vector<bool> Bends;                // whether shortest paths can bend around a point
  std::vector<double> Lengths;            // of points
  std::size_t ReachedCount = 0;           // points
  std::vector<Sight> Sights;              // of half-edges
  std::vector<Window> Windows;
  std::vector<int> Free;                // places in Windows
  using Entry = std::pair<double, int>; // least length, and a window, or -1 - a point
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Open;
};
} // namespace palpate
