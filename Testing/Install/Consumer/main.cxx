// Uses one kernel and one VTK module of an installed Palpate.
#include <palpate/RadialModel.h>
#include <palpate/vtkSegmentationSurface.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main()
{
  const double radius = 2.0; // mm
  const palpate::RadialModel sphere(0, {radius * std::sqrt(4.0 * M_PI)}, palpate::Vector3::Zero());

  vtkNew<vtkImageData> mask;
  mask->SetDimensions(9, 9, 9);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int k = 0; k < 9; ++k)
  {
    for (int j = 0; j < 9; ++j)
    {
      for (int i = 0; i < 9; ++i)
      {
        const bool inside = std::max({std::abs(i - 4), std::abs(j - 4), std::abs(k - 4)}) <= 2;
        mask->SetScalarComponentFromDouble(i, j, k, 0, inside ? 1.0 : 0.0);
      }
    }
  }
  vtkNew<vtkSegmentationSurface> surface;
  surface->SetInputData(mask);
  surface->SetLabel(1);
  surface->Update();

  const bool right = std::abs(sphere.Radius({0.0, 0.0, 1.0}) - radius) < 1e-12 &&
                     surface->GetOutput()->GetNumberOfPolys() > 0;
  std::puts(right ? "Palpate works from outside" : "Palpate gave wrong results");
  return right ? 0 : 1;
}
