/**
 * @class vtkCrosshair
 * @brief the point that linked views share
 *
 * Slice views pass through it, the 3D view shows it; a move raises a ModifiedEvent, which tells
 * observers to draw again.
 */
#ifndef vtkCrosshair_h
#define vtkCrosshair_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

class PALPATEINTERACTION_EXPORT vtkCrosshair : public vtkObject
{
public:
  static vtkCrosshair* New();
  vtkTypeMacro(vtkCrosshair, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** World, patient LPS, mm. Non-finite positions are ignored. Default: the origin. */
  void SetPositionWorld(double x, double y, double z);
  void SetPositionWorld(const double position[3])
  {
    this->SetPositionWorld(position[0], position[1], position[2]);
  }
  vtkGetVector3Macro(PositionWorld, double);
  ///@}

  ///@{
  /** Whether views draw it; they pass through it in any case. On by default. */
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}

protected:
  vtkCrosshair() = default;
  ~vtkCrosshair() override = default;

private:
  vtkCrosshair(const vtkCrosshair&) = delete;
  void operator=(const vtkCrosshair&) = delete;

  double PositionWorld[3] = {0.0, 0.0, 0.0};
  bool Visibility = true;
};

#endif
