#include "vtkLandmarks.h"

#include "DecimalText.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
bool IsFinite(const std::array<double, 3>& place)
{
  return std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); });
}
} // namespace

vtkStandardNewMacro(vtkLandmarks);

int vtkLandmarks::AddLandmark(const char* name, double x, double y, double z)
{
  if (!IsFinite({{x, y, z}}))
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
  const std::array<double, 3>& a = this->Landmarks[from].PositionWorld;
  const std::array<double, 3>& b = this->Landmarks[to].PositionWorld;
  const double length = std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
  const std::array<double, 3> middle{
      {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])}};
  this->Curves.push_back({palpate::FixedText(length, 1) + " mm", middle, {a, b}, false});
  this->Modified();
  return true;
}

bool vtkLandmarks::AddCurve(const char* label, const double labelPlace[3], vtkPoints* points,
                            bool isClosed)
{
  Curve curve{
      label == nullptr ? "" : label, {{labelPlace[0], labelPlace[1], labelPlace[2]}}, {}, isClosed};
  for (vtkIdType i = 0; points != nullptr && i < points->GetNumberOfPoints(); ++i)
  {
    curve.Points.emplace_back();
    points->GetPoint(i, curve.Points.back().data());
  }
  const bool areFinite = std::all_of(curve.Points.begin(), curve.Points.end(), IsFinite);
  if (curve.Points.size() < 2 || !areFinite || !IsFinite(curve.LabelWorld))
  {
    return false;
  }
  this->Curves.push_back(std::move(curve));
  this->Modified();
  return true;
}

void vtkLandmarks::RemoveAll()
{
  this->Landmarks.clear();
  this->Curves.clear();
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
  os << indent << "Curves: " << this->Curves.size() << '\n';
  os << indent << "Radius: " << this->Radius << '\n';
}
