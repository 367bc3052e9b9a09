/**
 * @class vtkLandmarks
 * @brief named points and distances between them, shared by linked views
 *
 * In 3D a landmark is a small sphere, in slices its cross-section: visible if the slice passes
 * within Radius of it. A distance is a straight line between two landmarks with its length in mm.
 */
#ifndef vtkLandmarks_h
#define vtkLandmarks_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <array>   // For points
#include <string>  // For names
#include <utility> // For distances
#include <vector>  // For both

class PALPATEINTERACTION_EXPORT vtkLandmarks : public vtkObject
{
public:
  static vtkLandmarks* New();
  vtkTypeMacro(vtkLandmarks, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** World, mm. Returns the landmark's number, from 0; -1 for a non-finite position. */
  int AddLandmark(const char* name, double x, double y, double z);
  int AddLandmark(const char* name, const double position[3])
  {
    return this->AddLandmark(name, position[0], position[1], position[2]);
  }
  /** Between two landmarks. Returns false for unknown numbers. */
  bool AddDistance(int from, int to);
  void RemoveAll();

  int GetNumberOfLandmarks();

  ///@{
  /** Radius of the spheres, mm. */
  vtkSetClampMacro(Radius, double, 0.01, 100.0);
  vtkGetMacro(Radius, double);
  ///@}
  ///@{
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}

#ifndef __VTK_WRAP__
  struct Landmark
  {
    std::string Name;
    std::array<double, 3> PositionWorld;
  };
  const std::vector<Landmark>& GetLandmarks() const
  {
    return this->Landmarks;
  }
  const std::vector<std::pair<int, int>>& GetDistances() const
  {
    return this->Distances;
  }
#endif

protected:
  vtkLandmarks() = default;
  ~vtkLandmarks() override = default;

private:
  vtkLandmarks(const vtkLandmarks&) = delete;
  void operator=(const vtkLandmarks&) = delete;

  double Radius = 2.0;
  double Color[3] = {0.34, 0.71, 0.91};
#ifndef __VTK_WRAP__
  std::vector<Landmark> Landmarks;
#endif
  std::vector<std::pair<int, int>> Distances;
};

#endif
