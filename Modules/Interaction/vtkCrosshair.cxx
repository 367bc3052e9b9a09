#include "vtkCrosshair.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkCrosshair);

void vtkCrosshair::SetPositionWorld(double x, double y, double z)
{
  const std::array<double, 3> position{{x, y, z}};
  const bool isNumber = std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  if (isNumber && !std::equal(position.begin(), position.end(), this->PositionWorld))
  {
    std::copy(position.begin(), position.end(), this->PositionWorld);
    this->Modified();
  }
}

void vtkCrosshair::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PositionWorld: (" << this->PositionWorld[0] << ", " << this->PositionWorld[1]
     << ", " << this->PositionWorld[2] << ")\n";
  os << indent << "Visibility: " << this->Visibility << '\n';
}
