/**
 * @class vtkInteractorStyleHaptic
 * @brief connects a render window to a haptic device: its surfaces can be touched
 *
 * Add surfaces, set the style on an interactor, and start. A servo thread then renders forces at
 * the device's rate, whatever the window does; a timer of the interactor polls it, moves the drawn
 * tool, and raises events. The camera moves as in vtkInteractorStyleMouseHand.
 *
 * - The device's axes are the camera's: right, up, towards the viewer. When a moved camera has come
 *   to rest, forces fade in again. Initially workspace and scene have the same centre.
 * - While the clutch button is held there is no force, and the tool stays in place: so the hand can
 *   reach points beyond its workspace.
 * - The mouse is the hand of the simulated device: the tool rests on the surface under the pointer,
 *   and a left press, or the wheel, pushes it in.
 * - Esc switches forces off, f switches them on again.
 *
 * Any fault results in 0 N and a FaultEvent; GetStatusText says what to do. Destroying the style,
 * or its window, stops the touch.
 */
#ifndef vtkInteractorStyleHaptic_h
#define vtkInteractorStyleHaptic_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For the numbers of the events
#include "vtkInteractorStyleMouseHand.h"
#include "vtkSetGet.h" // For the device's name

#include <memory> // For the session's state
#include <string> // For messages

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
    /** Contact with a structure begins or ends; the call data is its number, an int. */
    ContactBeginEvent = vtkCommand::UserEvent + 711,
    ContactEndEvent,
    /** A button of the device; the call data is its number from 0, an int. */
    ButtonPressEvent,
    ButtonReleaseEvent,
    /** Forces were switched off; the call data is the message, a const char*. */
    FaultEvent
  };

  ///@{
  /**
   * Adds a closed surface (world, mm) to be touched by its triangles, or a structure of any kind.
   * Stiffness in N/mm. Returns its number, or -1, with an error event, if it cannot be touched. May
   * be called while touching.
   */
  int AddSurface(vtkPolyData* surface, double stiffness);
#ifndef __VTK_WRAP__
  int AddStructure(const palpate::TouchStructure& structure);
#endif
  ///@}
  void RemoveAllStructures();
  int GetNumberOfStructures();
#ifndef __VTK_WRAP__
  /** All structures and the tool; without a frame, which depends on device and camera. */
  palpate::TouchScene MakeScene() const;
#endif

  ///@{
  /** The device that StartTouch opens: "simulated" (the default, moved by the mouse), "falcon" … */
  vtkSetStringMacro(DeviceName);
  vtkGetStringMacro(DeviceName);
  ///@}
  ///@{
  /** Radius of the spherical tool, mm. Default: 2. Takes effect at the next StartTouch. */
  vtkSetClampMacro(ToolRadius, double, 0.0, 1e3);
  vtkGetMacro(ToolRadius, double);
  ///@}
  ///@{
  /**
   * Millimetres of the world per millimetre of the device; 0, the default, reaches all structures.
   * Takes effect at the next StartTouch.
   */
  vtkSetClampMacro(Scale, double, 0.0, 1e6);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /** The device's button that is the clutch, from 0; -1 for none. Default: 2, a Falcon's middle. */
  vtkSetClampMacro(ClutchButton, int, -1, 31);
  vtkGetMacro(ClutchButton, int);
  ///@}

  /**
   * Opens the device and starts touching. Needs an interactor and a renderer in its window. Returns
   * false, with an error event that gives the reason, on failure.
   */
  bool StartTouch();
#ifndef __VTK_WRAP__
  /** The same with an open device. */
  bool StartTouch(std::unique_ptr<palpate::HapticDevice> device);
#endif
  /** Sends 0 N and closes the device. */
  void StopTouch();
  bool IsTouching();
  ///@{
  /** 0 N from the next tick on; fading in again. The hand is tracked in any case. */
  void SwitchForcesOff();
  void SwitchForcesOn();
  ///@}

  /** The tool and its force, to be shared with other views. */
  vtkProbeRepresentation* GetProbe();
  /** Status of the forces. */
  std::string GetStatusText();
  /** Fetches changes since the last call; called by the timer. */
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

  bool Publish(const palpate::WorkspaceFrame& frame);
  void FollowCamera();
  void ShowNewest();
  void TellChanges();
  void TakeHand();
  void FindRest();
  void PressHand();
  vtkRenderer* Led();

  char* DeviceName = nullptr;
  double ToolRadius = 2.0;
  double Scale = 0.0;
  int ClutchButton = 2;

  struct Live;
  std::unique_ptr<Live> Inner;
};

#endif
