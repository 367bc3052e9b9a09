#pragma once

#include "ComplianceMaps.h"
#include "DentedSurface.h"
#include "ElasticTracker.h"
#include "RadialModel.h"
#include "Vector3.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <vector>

namespace palpate
{
/// The surface of a structure that yields, as it is drawn: with the dent of the tool, and with what
/// a hand notices of its stiffness as an array of its points.
class YieldingSurface
{
public:
  /// In just noticeable differences of the force from its median (see FeltStiffness).
  static constexpr const char* StiffnessArray = "NoticedStiffness";

  YieldingSurface(const RadialModel& model, std::shared_ptr<const ComplianceMaps> maps);

  vtkPolyData* Surface() const { return this->Drawn; }
  /// What it was made from.
  const ComplianceMaps* Maps() const { return this->Compliance.get(); }

  /// With the dent of a ball (mm) at `probeWorld`, which would be at `proxyWorld` if the structure
  /// were rigid.
  void Press(const Vector3& proxyWorld, const Vector3& probeWorld, double ballRadius);
  /// The same where it is not known from where the ball came: from straight outside.
  void Press(const Vector3& probeWorld, double ballRadius);
  void Release();
  /// Adds the array, as felt with a ball of this radius (mm).
  void MapStiffness(double ballRadius);

private:
  bool HasHand(double ballRadius);
  void PressFrom(const Vector3& startWorld, const Vector3& probeWorld);
  void Move(const std::vector<Vector3>& points);
  std::vector<Vector3> NormalsOf(const std::vector<Vector3>& points) const;

  RadialModel Model;
  std::shared_ptr<const ComplianceMaps> Compliance;
  std::unique_ptr<DentedSurface> Dented; // null: its maps have no long waves
  // Tells where a ball of the radius (mm) presses.
  std::unique_ptr<ElasticTracker> Hand;
  double HandRadius = 0.0;
  double Farthest = 0.0; // of the rigid surface from its centre, mm
  vtkSmartPointer<vtkPolyData> Drawn;
  std::vector<Vector3> Directions;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<Vector3> RestNormals;     // of the smooth surface
  std::vector<Vector3> RestOfTriangles; // of its triangles
  double MappedRadius = 0.0;            // mm
  bool IsPressed = false;
};
} // namespace palpate
