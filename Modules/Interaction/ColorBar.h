#pragma once

#include "PalpateInteractionModule.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkLookupTable;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

namespace palpate
{
/// Legend of an array's colours, at the left of a view.
class PALPATEINTERACTION_EXPORT ColorBar
{
public:
  ColorBar();
  ~ColorBar();
  ColorBar(const ColorBar&) = delete;
  ColorBar& operator=(const ColorBar&) = delete;

  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  /// Null hides it.
  void Update(vtkLookupTable* colors, const std::string& array);

private:
  vtkNew<vtkScalarBarActor> Bar;
  vtkSmartPointer<vtkTextActor> Title;
};
} // namespace palpate
