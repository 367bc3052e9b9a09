#pragma once

#include "FeltStiffness.h"
#include "ModelDocument.h"
#include "ModelSoftening.h"
#include "PalpateFitModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
class ReportPage;

/// What a model that yields would feel like to a ball.
class PALPATEFIT_EXPORT SofteningReport
{
public:
  /// `model` is radial and yields as `softness` says; keeps the addresses of both. `name` is
  /// that of its file, for titles.
  SofteningReport(const ModelDocument& model, const ModelSoftness& softness, std::string name,
                  double ballRadius);

  /// The forces that it is on, at the points of the drawn organ.
  const FeltStiffness& Forces() const { return this->Felt; }
  /// One sentence on the forces: "A ball of 8 mm, 2.0 mm deep, feels 0.31 to 0.82 N, ...".
  std::string Sentence() const;
  /// A whole page: the sentence, the organ from six sides coloured by what a hand notices, and what
  /// was built.
  std::string Page() const;

private:
  void AddViews(ReportPage& page) const;

  const ModelDocument& Model;
  const ModelSoftness& Softness;
  std::string Name;
  double Radius; // mm
  vtkSmartPointer<vtkPolyData> Drawn;
  FeltStiffness Felt; // at its points
};
} // namespace palpate
