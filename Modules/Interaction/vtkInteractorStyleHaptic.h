/**
 * @class vtkInteractorStyleHaptic
 * @brief joins a render window to a haptic device: what is seen in it can be felt
 *
 * Give it surfaces, set it on an interactor, and start. A servo thread then feels them at the
 * device's rate, whatever the window does; a timer of the interactor fetches what happened, moves
 * the tool that is drawn, and tells it by events. The camera is led as by
 * vtkInteractorStyleMouseHand.
 *
 * - The device's axes are the camera's: right, up, towards the viewer. When the camera has come to
 *   rest somewhere else, forces fade in anew. Workspace and scene have the same centre at first.
 * - While the clutch button is held nothing is felt, and the tool stays where it is: so the hand
 *   reaches places beyond its workspace.
 * - The hand of the simulated device is the mouse: it is under the pointer, and the wheel moves it
 *   in depth. It begins in front of everything.
 * - Esc switches forces off, f on again.
 *
 * Whatever goes wrong ends in 0 N and a FaultEvent; GetStatusText says what to do. Destroying the
 * style, or its window, stops the touch.
 */
#ifndef vtkInteractorStyleHaptic_h
#define vtkInteractorStyleHaptic_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For the numbers of the events
#include "vtkInteractorStyleMouseHand.h"
#include "vtkSetGet.h" // For the device's name

#include <memory> // For what touches
#include <string> // For sentences

class vtkPolyData;
class vtkProbeRepresentation;

namespace palpate
{
class HapticDevice;
struct TouchScene;
struct TouchStructure;
struct WorkspaceFrame;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkInteractorStyleHaptic : public vtkInteractorStyleMouseHand
{
public:
  static vtkInteractorStyleHaptic* New();
  vtkTypeMacro(vtkInteractorStyleHaptic, vtkInteractorStyleMouseHand);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    /** A structure begins, or ceases, to be touched; the call data is its number, an int. */
    ContactBeginEvent = vtkCommand::UserEvent + 711,
    ContactEndEvent,
    /** A button of the device; the call data is its number from 0, an int. */
    ButtonPressEvent,
    ButtonReleaseEvent,
    /** Forces went off; the call data is the sentence, a const char*. */
    FaultEvent
  };

  ///@{
  /**
   * Adds a closed surface (world, mm) to be felt, by its triangles, or a structure of any kind.
   * Stiffness in N/mm. Returns its number, or -1, with an error event, where it cannot be felt.
   * What is added while touching is felt from then on.
   */
  int AddSurface(vtkPolyData* surface, double stiffness);
#ifndef __VTK_WRAP__
  int AddStructure(const palpate::TouchStructure& structure);
#endif
  ///@}
  void RemoveAllStructures();
  int GetNumberOfStructures();

  ///@{
  /** The device that StartTouch opens: "simulated" (the default, led by the mouse), "falcon" … */
  vtkSetStringMacro(DeviceName);
  vtkGetStringMacro(DeviceName);
  ///@}
  ///@{
  /** Of the tool, a sphere, mm. Default: 2. Taken by the next StartTouch. */
  vtkSetClampMacro(ToolRadius, double, 0.0, 1e3);
  vtkGetMacro(ToolRadius, double);
  ///@}
  ///@{
  /**
   * Millimetres of the world per millimetre of the device; 0, the default, reaches all structures.
   * Taken by the next StartTouch.
   */
  vtkSetClampMacro(Scale, double, 0.0, 1e6);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /** The device's button that is the clutch, from 0; -1 for none. Default: 2, a Falcon's middle. */
  vtkSetClampMacro(ClutchButton, int, -1, 31);
  vtkGetMacro(ClutchButton, int);
  ///@}
  ///@{
  /** Whether this style draws the tool into the renderer that it leads. On by default. */
  vtkSetMacro(ProbeVisibility, bool);
  vtkGetMacro(ProbeVisibility, bool);
  vtkBooleanMacro(ProbeVisibility, bool);
  ///@}

  /**
   * Opens the device and begins. Needs an interactor and a renderer in its window. False, with an
   * error event that says why, where it cannot.
   */
  bool StartTouch();
#ifndef __VTK_WRAP__
  /** The same with a device that is open. */
  bool StartTouch(std::unique_ptr<palpate::HapticDevice> device);
#endif
  /** 0 N; the device is closed. */
  void StopTouch();
  bool IsTouching();
  ///@{
  /** 0 N from the next tick on; and fading in again. The hand is followed all the same. */
  void SwitchForcesOff();
  void SwitchForcesOn();
  ///@}

  /** Where the tool is, and what it feels; to be shared with other views. */
  vtkProbeRepresentation* GetProbe();
  /** How forces are doing, in one sentence. */
  std::string GetStatusText();
  /** Fetches what happened since it was called last; the timer does it. */
  void Poll();

  void OnTimer() override;
  void OnKeyPress() override;
  void OnChar() override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;

protected:
  vtkInteractorStyleHaptic();
  ~vtkInteractorStyleHaptic() override;

private:
  vtkInteractorStyleHaptic(const vtkInteractorStyleHaptic&) = delete;
  void operator=(const vtkInteractorStyleHaptic&) = delete;

#ifndef __VTK_WRAP__
  palpate::TouchScene MakeScene() const;
#endif
  bool Publish(const palpate::WorkspaceFrame& frame);
  void FollowCamera();
  void ShowNewest();
  void TellChanges();
  void TakeHand();
  vtkRenderer* Led();

  char* DeviceName = nullptr;
  double ToolRadius = 2.0;
  double Scale = 0.0;
  int ClutchButton = 2;
  bool ProbeVisibility = true;

  struct Live;
  std::unique_ptr<Live> Inner;
};

#endif
