#include "vtkLandmarks.h"

#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkLandmarks);

int vtkLandmarks::AddLandmark(const char* name, double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    return -1;
  }
  this->Landmarks.push_back({name == nullptr ? "" : name, {{x, y, z}}});
  this->Modified();
  return this->GetNumberOfLandmarks() - 1;
}

bool vtkLandmarks::AddDistance(int from, int to)
{
  const auto isKnown = [this](int number)
  { return number >= 0 && number < this->GetNumberOfLandmarks(); };
  if (!isKnown(from) || !isKnown(to))
  {
    return false;
  }
  this->Distances.emplace_back(from, to);
  this->Modified();
  return true;
}

void vtkLandmarks::RemoveAll()
{
  this->Landmarks.clear();
  this->Distances.clear();
  this->Modified();
}

int vtkLandmarks::GetNumberOfLandmarks()
{
  return static_cast<int>(this->Landmarks.size());
}

void vtkLandmarks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Landmarks: " << this->Landmarks.size() << '\n';
  os << indent << "Distances: " << this->Distances.size() << '\n';
  os << indent << "Radius: " << this->Radius << '\n';
}
