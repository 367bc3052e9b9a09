#pragma once

#include "Calibre.h"
#include "IndexedMesh.h"
#include "LevelLoops.h"
#include "MeshRays.h"
#include "Status.h"

#include <utility>
#include <vector>

namespace palpate
{
/// Makes the axis of a tube, through the centroids of its sections.
class TubeAxis
{
public:
  /// The sections of a closed surface along an axis that begins with these points (mm), some `step`
  /// apart. Fails if there are fewer than five, or no end.
  static Status Measure(const IndexedMesh& tube, std::vector<Vector3> points, double step,
                        Calibre& measured);

private:
  TubeAxis(const IndexedMesh& tube, std::vector<Vector3> points, double step)
      : Tube(tube), Points(std::move(points)), Step(step)
  {
  }

  bool FindLoop(const Vector3& point, const Vector3& axis, Loop& loop) const;
  std::vector<Vector3> Directions() const;
  void Extend();
  Status Finish(Calibre& measured) const;

  const IndexedMesh& Tube;
  std::vector<Vector3> Points;
  double Step;
  MeshRays Rays;
};
} // namespace palpate
