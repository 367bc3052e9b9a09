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

bool HasSurface(const StudyDrawing& drawing, const ShapePrior* prior)
{
  return SurfaceCount(drawing) >= DrawnOrgan::LeastTouches ||
         (prior != nullptr && drawing.CenterWorld);
}
} // namespace

// Whether the last completion is a start for this one: otherwise an undo could end elsewhere than
// where the same touches began.
bool DrawnOrgan::IsContinued(const StudyDrawing& drawing, const ShapePrior* prior) const
{
  const std::vector<SurfaceTouch>& before = this->Given.Touches;
  return this->Completed != nullptr && prior != nullptr && prior == this->Prior.get() &&
         drawing.CenterWorld && drawing.CenterWorld == this->Given.CenterWorld &&
         before.size() <= drawing.Touches.size() &&
         std::equal(before.begin(), before.end(), drawing.Touches.begin());
}

void DrawnOrgan::Update(const StudyDrawing& drawing, std::shared_ptr<const ShapePrior> priorOrNull)
{
  const bool isSame = drawing.Touches == this->Given.Touches &&
                      drawing.CenterWorld == this->Given.CenterWorld && priorOrNull == this->Prior;
  if (isSame)
  {
    return;
  }
  if (!this->IsContinued(drawing, priorOrNull.get()))
  {
    this->Completed.reset();
  }
  this->Prior = std::move(priorOrNull);
  ++this->Changes;
  this->Refused.clear();
  if (HasSurface(drawing, this->Prior.get()))
  {
    Status status = this->Complete(drawing);
    if (!status.IsOk())
    {
      this->Completed.reset();
    }
    status = status.IsOk() ? this->Completed->Judge() : status;
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
  return this->Completed != nullptr
             ? this->Completed->Update(drawing.Touches)
             : CompleteSurface(drawing.Touches, this->Prior, drawing.CenterWorld, this->Completed);
}

void DrawnOrgan::Draw()
{
  this->Drawn = nullptr;
  this->NextWorld.clear();
  if (this->Completed == nullptr)
  {
    return;
  }
  // All smooth priors have the same covariance, which is what the maps keep.
  const bool isMapped = this->Map != nullptr && this->Mapped == this->Prior;
  if (!isMapped)
  {
    this->Mapped = this->Prior;
    this->Map = std::make_unique<DeviationMap>(this->Completed->Prior(), Frequency);
    this->Design = std::make_unique<DeviationMap>(this->Completed->Prior(), DesignFrequency);
  }
  const Eigen::VectorXd& deviations = this->Map->Evaluate(*this->Completed);
  vtkNew<vtkDoubleArray> array;
  array->SetName(DeviationArray);
  array->SetNumberOfTuples(deviations.size());
  std::copy(deviations.begin(), deviations.end(), array->GetPointer(0));
  const RadialModel model = this->Completed->Model();
  this->Volume = VolumeOf(model) / CubicMillimetersPerMilliliter;
  this->Largest = deviations.maxCoeff();
  this->Drawn = DrawModel(model, Frequency);
  this->Drawn->GetPointData()->AddArray(array);
  const std::size_t count = this->Given.Touches.size();
  if (count < ListedTouches)
  {
    this->NextWorld =
        this->Design->NextTouches(*this->Completed, static_cast<int>(ListedTouches - count));
  }
}
} // namespace palpate
