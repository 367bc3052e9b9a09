#ifndef vtkIcosahedronDirections_h
#define vtkIcosahedronDirections_h

#include "PalpateFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/// Source of the unit directions of a subdivided icosahedron: 10 f^2 + 2 points on the unit sphere,
/// 20 f^2 outward triangles. Point array "SolidAngle" (sr) holds the part of the sphere that each
/// direction represents. See palpate::IcosahedronDirections.
class PALPATEFILTERS_EXPORT vtkIcosahedronDirections : public vtkPolyDataAlgorithm
{
public:
  static vtkIcosahedronDirections* New();
  vtkTypeMacro(vtkIcosahedronDirections, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Number of parts into which each edge of the icosahedron is divided; 1 to 1000, default 20
  /// (4,002 directions, 8,000 triangles).
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

protected:
  vtkIcosahedronDirections() { this->SetNumberOfInputPorts(0); }
  ~vtkIcosahedronDirections() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkIcosahedronDirections(const vtkIcosahedronDirections&) = delete;
  void operator=(const vtkIcosahedronDirections&) = delete;

  int Frequency = 20;
};

#endif
