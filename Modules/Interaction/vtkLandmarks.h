/**
 * @class vtkLandmarks
 * @brief named points, distances between them and labelled curves, shared by linked views
 *
 * All have dark rims. In 3D a landmark is a small sphere, faint where something hides it, in slices
 * its cross-section: visible if the slice passes within Radius of it. A curve is a line through
 * points with a label; slices show its parts within Radius. A distance is a curve between two
 * landmarks with its length in mm as its label.
 */
#ifndef vtkLandmarks_h
#define vtkLandmarks_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <array>  // For points
#include <string> // For names
#include <vector> // For points

class vtkPoints;

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
  /** Through at least two points (world, mm), such as a measured length; closed, also from the last
   * one to the first. The label is drawn at `labelPlace`. Returns false for fewer points, and for
   * non-finite places. */
  bool AddCurve(const char* label, const double labelPlace[3], vtkPoints* points, bool isClosed);
  void RemoveAll();

  int GetNumberOfLandmarks();

  ///@{
  /** Radius of the spheres, mm. */
  vtkSetClampMacro(Radius, double, 0.01, 100.0);
  vtkGetMacro(Radius, double);
  ///@}
  ///@{
  /** Of points, lines and texts. Default: a light green, unlike tools, contacts and outlines. */
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
  struct Curve
  {
    std::string Label;
    std::array<double, 3> LabelWorld;
    std::vector<std::array<double, 3>> Points;
    bool IsClosed;
  };
  /** Distances are among them. */
  const std::vector<Curve>& GetCurves() const
  {
    return this->Curves;
  }
#endif

protected:
  vtkLandmarks() = default;
  ~vtkLandmarks() override = default;

private:
  vtkLandmarks(const vtkLandmarks&) = delete;
  void operator=(const vtkLandmarks&) = delete;

  double Radius = 2.0;
  double Color[3] = {0.62, 0.98, 0.45};
#ifndef __VTK_WRAP__
  std::vector<Landmark> Landmarks;
  std::vector<Curve> Curves;
#endif
};

#endif
