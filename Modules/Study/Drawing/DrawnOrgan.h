#pragma once

#include "DeviationMap.h"
#include "OrganCompletion.h"
#include "PalpateStudyModule.h"
#include "StudyDrawing.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The most probable surface of a drawing, how sure it is, and where to touch next. Owner thread
/// only.
class PALPATESTUDY_EXPORT DrawnOrgan
{
public:
  /// Touches on the surface from which on there is one without a prior or a centre.
  static constexpr std::size_t LeastTouches = 3;
  /// Until there are as many touches, the prior says where to touch next; then the eye leads.
  static constexpr std::size_t ListedTouches = 6;
  /// Of the surface: 642 points, 0.1 mm of an organ; 1,442 of a surface model, which may be thin.
  static constexpr int Frequency = 8;
  static constexpr int SurfaceFrequency = 12;
  static constexpr const char* DeviationArray = "StandardDeviation"; ///< of the surface, mm

  /// Follows the drawing, by a prior and perhaps the known organ that it relates to, as
  /// StartCompletion. A touch more of radial models takes less than a millisecond for the
  /// completion, and some for the surface and the next places; of surface models, a tenth of a
  /// second for all of it.
  void Update(const StudyDrawing& drawing, OrganPrior prior,
              std::shared_ptr<const LogSurface> knownOrNull = nullptr);

  /// Null: there are too few touches.
  const StartedCompletion* Completion() const
  {
    return this->Completed ? &*this->Completed : nullptr;
  }
  /// Of a completion.
  OrganModel Model() const;
  std::size_t TouchCount() const { return this->Given.Touches.size(); }
  /// With DeviationArray; null without a completion. Another one after each change.
  vtkPolyData* Surface() const { return this->Drawn; }
  double Milliliters() const { return this->Volume; }
  double LargestDeviation() const { return this->Largest; } ///< mm, of the surface
  /// mm, the first one first; none once ListedTouches are there.
  const std::vector<Vector3>& Next() const { return this->NextWorld; }
  /// Why the surface must not be trusted, or why there is none although there are touches; one
  /// message, may be empty.
  const std::string& Refusal() const { return this->Refused; }
  /// Increases whenever any of these changes.
  std::uint64_t Revision() const { return this->Changes; }

private:
  bool HasSurface(const StudyDrawing& drawing) const;
  bool IsContinued(const StudyDrawing& drawing, const OrganPrior& prior,
                   const LogSurface* known) const;
  Status Complete(const StudyDrawing& drawing);
  Eigen::VectorXd Look(const ShapeCompletion& completion, int nextCount);
  Eigen::VectorXd Look(const SurfaceCompletion& completion, int nextCount);
  void Draw();

  StudyDrawing Given;
  OrganPrior Prior; ///< as given
  std::shared_ptr<const LogSurface> Known;
  std::optional<StartedCompletion> Completed;
  std::shared_ptr<const ShapePrior> Mapped; ///< whose maps are kept, as given
  std::unique_ptr<DeviationMap> Map;
  std::unique_ptr<DeviationMap> Design;
  vtkSmartPointer<vtkPolyData> Drawn;
  double Volume = 0.0;
  double Largest = 0.0;
  std::vector<Vector3> NextWorld;
  std::string Refused;
  std::uint64_t Changes = 0;
};
} // namespace palpate
