#ifndef vtkRadialModelSurface_h
#define vtkRadialModelSurface_h

#include "PalpateFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

namespace palpate
{
class RadialModel;
}

/// Tessellates a spherical-harmonic model: one vertex for each direction of a subdivided
/// icosahedron, with the model's analytic outward normals.
///
/// Port 0: the model as a table (see palpate::ToTable). Port 1, optional: the original closed
/// surface. Output: triangles in world mm, point array "Radius" (mm); if the table has a
/// "CovarianceFactor" also "RadiusDeviation" (mm, one standard deviation of the fitted radius);
/// with an original also "DistanceToSurface" (mm to its nearest point, positive where the model
/// lies outside it) and "Residual" (mm, the original's outermost radius minus the model's; NaN
/// along directions that miss the original).
class PALPATEFILTERS_EXPORT vtkRadialModelSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkRadialModelSurface* New();
  vtkTypeMacro(vtkRadialModelSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Number of parts into which each edge of the icosahedron is divided; default 20.
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  void SetOriginalConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetOriginalData(vtkPolyData* surface);

protected:
  vtkRadialModelSurface() { this->SetNumberOfInputPorts(2); }
  ~vtkRadialModelSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkRadialModelSurface(const vtkRadialModelSurface&) = delete;
  void operator=(const vtkRadialModelSurface&) = delete;

  int Frequency = 20;
};

#endif
