#pragma once

#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace palpate
{
/// Base of the parts of a view: what a part draws, added by its constructor in drawing order.
class ViewProps
{
public:
  ViewProps() = default;
  ViewProps(const ViewProps&) = delete;
  ViewProps& operator=(const ViewProps&) = delete;

  void AddTo(vtkRenderer* renderer) const
  {
    for (vtkProp* prop : this->Props)
    {
      renderer->AddViewProp(prop);
    }
  }
  void RemoveFrom(vtkRenderer* renderer) const
  {
    for (vtkProp* prop : this->Props)
    {
      renderer->RemoveViewProp(prop);
    }
  }
  void SetVisible(bool isVisible)
  {
    for (vtkProp* prop : this->Props)
    {
      prop->SetVisibility(isVisible ? 1 : 0);
    }
  }

protected:
  void Add(vtkProp* prop) { this->Props.emplace_back(prop); }
  void Add(const ViewProps& part)
  {
    this->Props.insert(this->Props.end(), part.Props.begin(), part.Props.end());
  }

private:
  std::vector<vtkSmartPointer<vtkProp>> Props;
};
} // namespace palpate
