#include "vtkSurfaceDisplay.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkSurfaceDisplay);

vtkMTimeType vtkSurfaceDisplay::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Surface == nullptr ? time : std::max(time, this->Surface->GetMTime());
}

void vtkSurfaceDisplay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.Get() << '\n';
  os << indent << "Color: (" << this->Color[0] << ", " << this->Color[1] << ", " << this->Color[2]
     << ")\n";
  os << indent << "Opacity: " << this->Opacity << '\n';
  os << indent << "Visibility: " << this->Visibility << '\n';
  os << indent << "ContourVisibility: " << this->ContourVisibility << '\n';
  os << indent << "Highlight: " << this->Highlight << '\n';
  os << indent << "Forbidden: " << this->Forbidden << '\n';
  os << indent << "LineWidth: " << this->LineWidth << '\n';
  os << indent << "Wireframe: " << this->Wireframe << '\n';
  os << indent << "Pickable: " << this->Pickable << '\n';
  os << indent << "ColorArray: " << this->ColorArray << '\n';
  os << indent << "ColorLimit: " << this->ColorLimit << '\n';
}
