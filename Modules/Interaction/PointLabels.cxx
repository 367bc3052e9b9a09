#include "PointLabels.h"

#include "ViewText.h"

#include "vtkCoordinate.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace palpate
{
namespace
{
constexpr int LabelTextSize = 10; // points
} // namespace

void PointLabels::SetRenderer(vtkRenderer* renderer)
{
  this->Resize(0);
  this->Renderer = renderer;
}

void PointLabels::Resize(std::size_t count)
{
  while (this->Texts.size() > count)
  {
    if (this->Renderer != nullptr)
    {
      this->Renderer->RemoveViewProp(this->Texts.back());
    }
    this->Texts.pop_back();
  }
  while (this->Texts.size() < count && this->Renderer != nullptr)
  {
    this->Texts.push_back(MakeViewText(0.0, 0.0, LabelTextSize));
    this->Texts.back()->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    this->Renderer->AddViewProp(this->Texts.back());
  }
}

void PointLabels::Update(const std::vector<Label>& labels, const std::array<double, 3>& color)
{
  this->Resize(labels.size());
  for (std::size_t l = 0; l < this->Texts.size(); ++l)
  {
    // Spaces keep the text off its point.
    SetViewText(this->Texts[l], "  " + labels[l].Text);
    const Vector3& place = labels[l].PositionWorld;
    this->Texts[l]->GetPositionCoordinate()->SetValue(place.x(), place.y(), place.z());
    this->Texts[l]->GetTextProperty()->SetColor(color[0], color[1], color[2]);
    this->Texts[l]->SetReach(this->Reach);
  }
}
} // namespace palpate
