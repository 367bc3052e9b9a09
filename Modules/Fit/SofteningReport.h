#pragma once

#include "FeltStiffness.h"
#include "ModelSoftening.h"
#include "PalpateFitModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// What a model that yields would feel like to a ball.
class PALPATEFIT_EXPORT SofteningReport
{
public:
  /// `name` is that of the model's file, for titles. The model is star-shaped and yields.
  SofteningReport(const SoftenedModel& softened, std::string name, double ballRadius);

  /// One sentence on the forces: "A ball of 8 mm, 2.0 mm deep, feels 0.31 to 0.82 N, ...".
  std::string Sentence() const;
  /// A whole page: the sentence, the organ from six sides coloured by what a hand notices, and what
  /// was built.
  std::string Page() const;

private:
  std::string Views() const;

  const SoftenedModel& Softened;
  std::string Name;
  double Radius; // mm
  vtkSmartPointer<vtkPolyData> Drawn;
  FeltStiffness Felt; // at its points
};
} // namespace palpate
