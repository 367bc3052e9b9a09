#include "DrawnOrgan.h"

#include "ModelMeasures.h"
#include "ModelSurface.h"
#include "Units.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr int DesignFrequency = 6; // 362 candidates

bool IsGiven(const OrganPrior& prior)
{
  return std::visit([](const auto& one) { return one != nullptr; }, prior);
}

double CubicMillimetersOf(const OrganModel& model)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  return radial != nullptr ? VolumeOf(*radial) : std::get<SurfaceModel>(model).Volume();
}
} // namespace

bool DrawnOrgan::HasSurface(const StudyDrawing& drawing) const
{
  return SurfaceCount(drawing) >= LeastTouches ||
         (IsGiven(this->Prior) && (drawing.CenterWorld || this->Known != nullptr));
}

// Whether the last completion is a start for this one: otherwise an undo could end elsewhere than
// where the same touches began.
bool DrawnOrgan::IsContinued(const StudyDrawing& drawing, const OrganPrior& prior,
                             const LogSurface* known) const
{
  const std::vector<SurfaceTouch>& before = this->Given.Touches;
  const bool isPlaced = known != nullptr || drawing.CenterWorld;
  return this->Completed && IsGiven(prior) && prior == this->Prior && known == this->Known.get() &&
         isPlaced && drawing.CenterWorld == this->Given.CenterWorld &&
         before.size() <= drawing.Touches.size() &&
         std::equal(before.begin(), before.end(), drawing.Touches.begin());
}

void DrawnOrgan::Update(const StudyDrawing& drawing, OrganPrior prior,
                        std::shared_ptr<const LogSurface> knownOrNull)
{
  const bool isSame = drawing.Touches == this->Given.Touches &&
                      drawing.CenterWorld == this->Given.CenterWorld && prior == this->Prior &&
                      knownOrNull == this->Known;
  if (isSame)
  {
    return;
  }
  if (!this->IsContinued(drawing, prior, knownOrNull.get()))
  {
    this->Completed.reset();
  }
  this->Prior = std::move(prior);
  this->Known = std::move(knownOrNull);
  ++this->Changes;
  this->Refused.clear();
  if (this->HasSurface(drawing))
  {
    Status status = this->Complete(drawing);
    if (!status.IsOk())
    {
      this->Completed.reset();
    }
    status = status.IsOk()
                 ? std::visit([](const auto& one) { return one->Judge(); }, *this->Completed)
                 : status;
    this->Refused = status.Message();
  }
  else
  {
    this->Completed.reset();
  }
  this->Given = drawing;
  this->Draw();
}

Status DrawnOrgan::Complete(const StudyDrawing& drawing)
{
  if (this->Completed)
  {
    return std::visit([&](const auto& one) { return one->Update(drawing.Touches); },
                      *this->Completed);
  }
  CompletionRequest request{drawing.Touches, this->Prior, drawing.CenterWorld};
  if (this->Known != nullptr)
  {
    request.Known = *this->Known;
  }
  StartedCompletion started;
  Status status = StartCompletion(request, started);
  if (status.IsOk())
  {
    this->Completed = std::move(started);
  }
  return status;
}

OrganModel DrawnOrgan::Model() const
{
  return std::visit([](const auto& one) { return OrganModel(one->Model()); }, *this->Completed);
}

// The standard deviations at the drawn points, and where to touch next.
Eigen::VectorXd DrawnOrgan::Look(const ShapeCompletion& completion, int nextCount)
{
  // All smooth priors have the same covariance, which is what the maps keep.
  const auto& given = std::get<std::shared_ptr<const ShapePrior>>(this->Prior);
  if (this->Map == nullptr || this->Mapped != given)
  {
    this->Mapped = given;
    this->Map = std::make_unique<DeviationMap>(completion.Prior(), Frequency);
    this->Design = std::make_unique<DeviationMap>(completion.Prior(), DesignFrequency);
  }
  if (nextCount > 0)
  {
    this->NextWorld = this->Design->NextTouches(completion, nextCount);
  }
  return this->Map->Evaluate(completion);
}

Eigen::VectorXd DrawnOrgan::Look(const SurfaceCompletion& completion, int nextCount)
{
  if (nextCount > 0)
  {
    this->NextWorld = completion.NextTouches(nextCount);
  }
  return completion.Deviations(SurfaceFrequency);
}

void DrawnOrgan::Draw()
{
  this->Drawn = nullptr;
  this->NextWorld.clear();
  if (!this->Completed)
  {
    return;
  }
  const int left = static_cast<int>(ListedTouches) - static_cast<int>(this->Given.Touches.size());
  const Eigen::VectorXd deviations =
      std::visit([&](const auto& one) { return this->Look(*one, left); }, *this->Completed);
  vtkNew<vtkDoubleArray> array;
  array->SetName(DeviationArray);
  array->SetNumberOfTuples(deviations.size());
  std::copy(deviations.begin(), deviations.end(), array->GetPointer(0));
  const OrganModel model = this->Model();
  this->Volume = CubicMillimetersOf(model) / CubicMillimetersPerMilliliter;
  this->Largest = deviations.maxCoeff();
  const bool isRadial = std::holds_alternative<RadialModel>(model);
  this->Drawn = DrawModel(model, isRadial ? Frequency : SurfaceFrequency);
  this->Drawn->GetPointData()->AddArray(array);
}
} // namespace palpate
