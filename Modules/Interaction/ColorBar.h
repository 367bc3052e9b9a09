#pragma once

#include "PalpateInteractionModule.h"
#include "ViewProps.h"

#include "vtkNew.h"
#include "vtkScalarBarActor.h"

#include <string>

class vtkLookupTable;
class vtkTextActor;

namespace palpate
{
/// Legend of an array's colours, at the left of a view.
class PALPATEINTERACTION_EXPORT ColorBar : public ViewProps
{
public:
  ColorBar();
  /// Null hides it.
  void Update(vtkLookupTable* colors, const std::string& array);
  /// Of its text, 0 to 1.
  void SetGrey(double grey);

private:
  vtkNew<vtkScalarBarActor> Bar;
  vtkSmartPointer<vtkTextActor> Title;
};
} // namespace palpate
